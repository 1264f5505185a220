//! Binary portable pixmaps, the chapter's format.

use std::io::{self, Write};

use super::EncodedImage;

/// Writes a P6 file with 8 bits a channel.
pub(super) fn write(print: &EncodedImage, out: &mut dyn Write) -> io::Result<()> {
    write!(out, "P6\n{} {}\n255\n", print.width, print.height)?;
    out.write_all(print.bytes())
}
