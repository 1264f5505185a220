//! PNG files.

use std::io::{self, Write};

use super::{EncodedImage, Notes, Transfer};

/// Writes a PNG with the notes as text chunks; nothing in it depends on clock, host or path.
///
/// With the curve of sRGB it says so. Without a curve it says nothing, like the chapter's files: a viewer
/// that was told that the numbers are intensities would show another picture than the chapter does.
pub(super) fn write(
    print: &EncodedImage,
    out: &mut dyn Write,
    depth: png::BitDepth,
    notes: &Notes,
) -> io::Result<()> {
    let side = |length: usize| u32::try_from(length).map_err(io::Error::other);
    let mut encoder = png::Encoder::new(out, side(print.width)?, side(print.height)?);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::Fast);
    if print.encoding.transfer == Transfer::Srgb {
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        // For readers that do not know of sRGB: the power that is closest, as the PNG standard has it.
        encoder.set_source_gamma(png::ScaledFloat::from_scaled(45_455));
    }
    for (keyword, text) in &notes.0 {
        encoder
            .add_itxt_chunk((*keyword).to_owned(), text.clone())
            .map_err(io_error)?;
    }
    encoder.set_depth(depth);
    let mut writer = encoder.write_header().map_err(io_error)?;
    writer.write_image_data(print.bytes()).map_err(io_error)?;
    writer.finish().map_err(io_error)
}

/// The system's own error if there is one, so that its kind is kept.
fn io_error(error: png::EncodingError) -> io::Error {
    match error {
        png::EncodingError::IoError(error) => error,
        other => io::Error::other(other),
    }
}
