//! Binary portable pixmaps, the chapter's format.

use std::io::{self, Write};

use super::{Film, Rounding};

/// Writes a P6 file with 8 bits a channel.
pub(super) fn write(film: &Film, out: &mut dyn Write, rounding: Rounding) -> io::Result<()> {
    write!(out, "P6\n{} {}\n255\n", film.width(), film.height())?;
    out.write_all(&film.bytes(rounding))
}
