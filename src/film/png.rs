//! PNG files.

use std::io::{self, Write};

use super::{Film, Notes, Rounding};

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
        encoder.add_itxt_chunk((*keyword).to_owned(), text.clone())?;
    }
    let channels = film.pixels().iter().flat_map(|pixel| pixel.channels());
    let bytes: Vec<u8> = match depth {
        Depth::Eight => {
            encoder.set_depth(png::BitDepth::Eight);
            // The code is at most 255, so its low byte is all of it.
            channels
                .map(|channel| rounding.code(channel, 255).to_le_bytes()[0])
                .collect()
        }
        Depth::Sixteen => {
            encoder.set_depth(png::BitDepth::Sixteen);
            channels
                .flat_map(|channel| rounding.code(channel, 65_535).to_be_bytes())
                .collect()
        }
    };
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&bytes)?;
    writer.finish()?;
    Ok(())
}
