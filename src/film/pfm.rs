//! Portable float maps: the picture before quantisation.

use std::io::{self, Write};

use super::Film;

/// Writes 32-bit little-endian floats; this format's rows run from bottom to top.
pub(super) fn write(film: &Film, out: &mut dyn Write) -> io::Result<()> {
    write!(out, "PF\n{} {}\n-1.0\n", film.width(), film.height())?;
    let rows = film.pixels().chunks(film.width()).rev();
    let channels = rows.flatten().flat_map(|pixel| pixel.channels());
    #[expect(
        clippy::cast_possible_truncation,
        reason = "the format holds 32-bit floats"
    )]
    let bytes: Vec<u8> = channels
        // Brighter than this format can say is as bright as it can say.
        .flat_map(|channel| (channel as f32).clamp(f32::MIN, f32::MAX).to_le_bytes())
        .collect();
    out.write_all(&bytes)
}
