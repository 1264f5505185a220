//! Writers of PNG, PPM and PFM files.

use std::io::{self, Write};

use png::{BitDepth, Compression, Encoder, EncodingError, ScaledFloat, SrgbRenderingIntent};

use super::{EncodedImage, Encoding, Film, Format, Transfer};

/// Text chunks of a picture file: keywords and texts.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Notes(pub Vec<(&'static str, String)>);

impl Film {
    /// Writes the picture as a file.
    ///
    /// # Errors
    /// Returns the writer's error, or one if memory is short.
    pub fn write(
        &self,
        out: &mut dyn Write,
        format: Format,
        encoding: impl Into<Encoding>,
        notes: &Notes,
    ) -> io::Result<()> {
        let image = EncodedImage::of(self, format, encoding.into());
        image.ok_or(io::ErrorKind::OutOfMemory)?.write(out, notes)
    }
}

impl EncodedImage {
    /// Writes the picture as a file. Only PNG files hold the notes.
    ///
    /// # Errors
    /// Returns the writer's error.
    pub fn write(&self, out: &mut dyn Write, notes: &Notes) -> io::Result<()> {
        let (width, height) = (self.width, self.height);
        match self.format {
            Format::Png8 => write_png(self, out, BitDepth::Eight, notes).map_err(io_error),
            Format::Png16 => write_png(self, out, BitDepth::Sixteen, notes).map_err(io_error),
            Format::Ppm => {
                write!(out, "P6\n{width} {height}\n255\n")?;
                out.write_all(self.bytes())
            }
            Format::Pfm => {
                // A negative scale means little-endian; rows run from bottom to top.
                write!(out, "PF\n{width} {height}\n-1.0\n")?;
                let mut rows = self.bytes().chunks(width * self.format.pixel_size()).rev();
                rows.try_for_each(|row| out.write_all(row))
            }
        }
    }
}

/// Writes a PNG file, whose bytes depend on the picture and the notes alone.
///
/// It declares the sRGB curve. Without a curve it declares none, as the chapter's files: a viewer
/// would convert intensities, and show another picture than the chapter.
fn write_png(
    image: &EncodedImage,
    out: &mut dyn Write,
    depth: BitDepth,
    notes: &Notes,
) -> Result<(), EncodingError> {
    let side = |length: usize| u32::try_from(length).map_err(io::Error::other);
    let mut encoder = Encoder::new(out, side(image.width)?, side(image.height)?);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(Compression::Fast);
    if image.encoding.transfer == Transfer::Srgb {
        encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
        // For readers without sRGB: the closest power, as the PNG standard recommends.
        encoder.set_source_gamma(ScaledFloat::from_scaled(45_455));
    }
    for (keyword, text) in &notes.0 {
        encoder.add_itxt_chunk((*keyword).to_owned(), text.clone())?;
    }
    encoder.set_depth(depth);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(image.bytes())?;
    writer.finish()
}

/// The system's own error if there is one, which keeps its kind.
fn io_error(error: EncodingError) -> io::Error {
    match error {
        EncodingError::IoError(error) => error,
        other => io::Error::other(other),
    }
}
