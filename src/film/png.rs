//! PNG files.

use std::io::{self, Write};

use super::{Film, Notes, Rounding};
use crate::math::Rgb;

/// Bits a channel.
#[derive(Debug, Clone, Copy)]
pub(super) enum Depth {
    Eight,
    Sixteen,
}

/// Writes a PNG with the notes as text chunks; nothing in it depends on clock, host or path.
pub(super) fn write(
    film: &Film,
    out: &mut dyn Write,
    depth: Depth,
    rounding: Rounding,
    notes: &Notes,
) -> io::Result<()> {
    let side = |length: usize| u32::try_from(length).map_err(io::Error::other);
    let mut encoder = png::Encoder::new(out, side(film.width())?, side(film.height())?);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::Fast);
    for (keyword, text) in &notes.0 {
        encoder
            .add_itxt_chunk((*keyword).to_owned(), text.clone())
            .map_err(io_error)?;
    }
    let bytes = match depth {
        Depth::Eight => {
            encoder.set_depth(png::BitDepth::Eight);
            film.bytes(rounding)
        }
        Depth::Sixteen => {
            encoder.set_depth(png::BitDepth::Sixteen);
            let codes = |pixel: &Rgb| pixel.channels().map(|c| rounding.code(c, 65_535));
            film.pixels()
                .iter()
                .flat_map(codes)
                .flat_map(u16::to_be_bytes)
                .collect()
        }
    };
    let mut writer = encoder.write_header().map_err(io_error)?;
    writer.write_image_data(&bytes).map_err(io_error)?;
    writer.finish().map_err(io_error)
}

/// The system's own error if there is one, so that its kind is kept.
fn io_error(error: png::EncodingError) -> io::Error {
    match error {
        png::EncodingError::IoError(error) => error,
        other => io::Error::other(other),
    }
}
