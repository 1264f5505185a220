//! Readers of picture files.

use std::fs;
use std::io::BufRead;
use std::path::Path;

use super::{Film, Transfer};
use crate::image_file::{self, ImageFileError};
use crate::math::Rgb;

impl Film {
    /// Reads a picture in display values, from 0 to 1.
    ///
    /// The largest code value of PNG, JPEG and PNM becomes 1. The curve maps the intensities of PFM.
    ///
    /// # Errors
    /// Returns an error if the file cannot be read, is no picture, or has a channel that is not
    /// finite.
    pub fn read(path: &Path, transfer: Transfer) -> Result<Self, ImageFileError> {
        let bytes = fs::read(path).map_err(ImageFileError::Io)?;
        if bytes.starts_with(b"PF") {
            let damaged = || ImageFileError::Damaged("it breaks the rules of PFM".to_owned());
            let film = from_pfm(&bytes).ok_or_else(damaged)?;
            if let Some((column, row)) = film.non_finite().next() {
                let reason = format!("pixel {column},{row} is infinite or not a number");
                return Err(ImageFileError::Damaged(reason));
            }
            return Ok(film.displayed(transfer));
        }
        let image = image_file::decode(&bytes)?;
        let no_memory = || ImageFileError::Io(std::io::ErrorKind::OutOfMemory.into());
        let mut film = Self::new(image.width, image.height).ok_or_else(no_memory)?;
        let largest = f64::from(image.largest);
        for (pixel, channels) in film.pixels_mut().iter_mut().zip(&image.channels) {
            let [r, g, b] = channels.map(|channel| f64::from(channel) / largest);
            *pixel = Rgb::new(r, g, b);
        }
        Ok(film)
    }
}

fn from_pfm(mut bytes: &[u8]) -> Option<Film> {
    let mut lines = [const { String::new() }; 3];
    for line in &mut lines {
        bytes.read_line(line).ok()?;
    }
    let [kind, size, scale] = lines.each_ref().map(|line| line.trim());
    let (width, height) = size.split_once(' ')?;
    let (width, height): (usize, usize) = (width.parse().ok()?, height.trim().parse().ok()?);
    let scale: f64 = scale.parse().ok()?;
    let length = width.checked_mul(height)?.checked_mul(12)?;
    if kind != "PF" || bytes.len() != length || width == 0 {
        return None;
    }
    let mut film = Film::new(width, height)?;
    // Rows run from bottom to top. A negative scale means little-endian.
    let rows = film.pixels_mut().chunks_mut(width).rev().flatten();
    let (floats, _) = bytes.as_chunks::<4>();
    let (channels, _) = floats.as_chunks::<3>();
    for (pixel, channels) in rows.zip(channels) {
        let value = |bytes: [u8; 4]| {
            f64::from(if scale < 0.0 {
                f32::from_le_bytes(bytes)
            } else {
                f32::from_be_bytes(bytes)
            })
        };
        let [r, g, b] = channels.map(value);
        *pixel = Rgb::new(r, g, b);
    }
    Some(film)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::{Format, Notes, Rounding};

    #[test]
    fn a_written_picture_is_read() {
        let folder = tempfile::tempdir().expect("a folder");
        let mut film = Film::new(3, 2).expect("memory");
        for (at, pixel) in film.pixels_mut().iter_mut().enumerate() {
            let code = f64::from(u8::try_from(at * 40).expect("small")) / 255.0;
            *pixel = Rgb::new(code, 1.0 - code, 0.0);
        }
        for format in [Format::Png8, Format::Png16, Format::Ppm, Format::Pfm] {
            let path = folder.path().join(format!("it.{}", format.extension()));
            let mut bytes = Vec::new();
            film.write(&mut bytes, format, Rounding::Nearest, &Notes::default())
                .expect("bytes");
            fs::write(&path, &bytes).expect("a file");
            let read = Film::read(&path, Transfer::None).expect("a picture");
            assert_eq!(read.bytes(Rounding::Nearest), film.bytes(Rounding::Nearest));
            let error = || Film::read(&path, Transfer::None).map_err(|error| error.to_string());
            fs::write(&path, &bytes[..bytes.len() - 3]).expect("a file");
            if format == Format::Pfm {
                let reason = "the file is damaged: it breaks the rules of PFM";
                assert_eq!(error(), Err(reason.to_owned()));
                // The last floats are those of the upper right pixel.
                let last = bytes.len() - 4;
                bytes[last..].copy_from_slice(&f32::NAN.to_le_bytes());
                fs::write(&path, &bytes).expect("a file");
                let reason = "the file is damaged: pixel 2,0 is infinite or not a number";
                assert_eq!(error(), Err(reason.to_owned()));
            }
        }
    }

    /// The `image` crate rounds such values to 8 bits: 50 of 100 to 127 of 255.
    #[test]
    fn a_pnm_file_is_read_exactly() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("it.ppm");
        fs::write(&path, "P3 2 1 100\n50 1 100  33 0 99\n").expect("a file");
        let film = Film::read(&path, Transfer::None).expect("a picture");
        let expected = [[0.5, 0.01, 1.0], [0.33, 0.0, 0.99]];
        assert_eq!([0, 1].map(|x| film.pixel(x, 0).channels()), expected);
        fs::write(&path, "P3 1 1 100\n50 1 101\n").expect("a file");
        let error = Film::read(&path, Transfer::None).expect_err("a value too large");
        assert_eq!(error.to_string(), "the value 101 is above the largest, 100");
    }
}
