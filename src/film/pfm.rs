//! Portable float maps: the picture before quantisation.

use std::io::{self, Write};

use super::{Format, Print};

/// Writes 32-bit little-endian floats; this format's rows run from bottom to top.
pub(super) fn write(print: &Print, out: &mut dyn Write) -> io::Result<()> {
    write!(out, "PF\n{} {}\n-1.0\n", print.width(), print.height())?;
    let row = print.width() * Format::Pfm.pixel_size();
    let mut rows = print.bytes().chunks(row).rev();
    rows.try_for_each(|row| out.write_all(row))
}
