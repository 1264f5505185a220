//! Pictures from files.

use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

use super::{Film, Transfer};
use crate::math::Rgb;

impl Film {
    /// Reads a picture as it is shown: PNG, JPEG or PNM, whose largest code value becomes 1, or PFM, whose
    /// intensities this curve makes such values.
    ///
    /// # Errors
    /// Tells why the file cannot be read as a picture.
    pub fn read(path: &Path, transfer: Transfer) -> Result<Self, String> {
        let mut bytes = Vec::new();
        let read = File::open(path).and_then(|mut file| file.read_to_end(&mut bytes));
        read.map_err(|error| error.to_string())?;
        if bytes.starts_with(b"PF") {
            let film = from_pfm(&bytes).ok_or("it is a damaged PFM")?;
            let mut pixels = film.pixels().iter();
            if let Some(at) = pixels.position(|pixel| !pixel.is_finite()) {
                let (column, row) = (at % film.width(), at / film.width());
                let reason = format!("pixel {column},{row} of it is infinite or not a number");
                return Err(reason);
            }
            return Ok(film.shown(transfer));
        }
        let image = image::load_from_memory(&bytes).map_err(|error| error.to_string())?;
        let image = image.into_rgb16();
        let (width, height) = (image.width() as usize, image.height() as usize);
        let mut film = Self::new(width, height).ok_or("there is no memory for it")?;
        for (pixel, codes) in film.pixels_mut().iter_mut().zip(image.pixels()) {
            let [r, g, b] = codes.0.map(|code| f64::from(code) / f64::from(u16::MAX));
            *pixel = Rgb::new(r, g, b);
        }
        Ok(film)
    }
}

fn from_pfm(bytes: &[u8]) -> Option<Film> {
    let mut reader = BufReader::new(bytes);
    let mut lines = [const { String::new() }; 3];
    for line in &mut lines {
        reader.read_line(line).ok()?;
    }
    let [kind, size, scale] = lines.each_ref().map(|line| line.trim());
    let (width, height) = size.split_once(' ')?;
    let (width, height): (usize, usize) = (width.parse().ok()?, height.trim().parse().ok()?);
    let scale: f64 = scale.parse().ok()?;
    let mut body = Vec::new();
    reader.read_to_end(&mut body).ok()?;
    let length = width.checked_mul(height)?.checked_mul(12)?;
    if kind != "PF" || body.len() != length || width == 0 {
        return None;
    }
    let mut film = Film::new(width, height)?;
    // This format's rows run from bottom to top; a negative scale says that the low byte comes first.
    let rows = film.pixels_mut().chunks_mut(width).rev().flatten();
    let (floats, _) = body.as_chunks::<4>();
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
    fn what_is_written_is_read() {
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
            std::fs::write(&path, &bytes).expect("a file");
            let read = Film::read(&path, Transfer::None).expect("a picture");
            assert_eq!(read.bytes(Rounding::Nearest), film.bytes(Rounding::Nearest));
            std::fs::write(&path, &bytes[..bytes.len() - 3]).expect("a file");
            if format == Format::Pfm {
                assert_eq!(
                    Film::read(&path, Transfer::None),
                    Err("it is a damaged PFM".to_owned())
                );
                // The last floats are those of the upper right pixel.
                let last = bytes.len() - 4;
                bytes[last..].copy_from_slice(&f32::NAN.to_le_bytes());
                std::fs::write(&path, &bytes).expect("a file");
                let reason = "pixel 2,0 of it is infinite or not a number".to_owned();
                assert_eq!(Film::read(&path, Transfer::None), Err(reason));
            }
        }
    }
}
