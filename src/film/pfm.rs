//! Portable float maps: the picture before quantisation.

use std::io::{self, Write};

use super::{EncodedImage, Format};

/// What is stored of an intensity: brighter than a float can say is as bright as it can say.
#[expect(
    clippy::cast_possible_truncation,
    reason = "the format holds 32-bit floats"
)]
pub(super) fn float(intensity: f64) -> f32 {
    (intensity as f32).clamp(f32::MIN, f32::MAX)
}

/// Writes 32-bit little-endian floats; this format's rows run from bottom to top.
pub(super) fn write(print: &EncodedImage, out: &mut dyn Write) -> io::Result<()> {
    write!(out, "PF\n{} {}\n-1.0\n", print.width, print.height)?;
    let row = print.width * Format::Pfm.pixel_size();
    let mut rows = print.bytes().chunks(row).rev();
    rows.try_for_each(|row| out.write_all(row))
}
