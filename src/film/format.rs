//! The kinds of picture files.

use std::path::Path;

/// A kind of picture file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// PNG with 8 bits a channel.
    Png8,
    /// PNG with 16 bits a channel.
    Png16,
    /// Binary portable pixmap (P6) with 8 bits a channel.
    Ppm,
    /// Portable float map: linear, unclamped 32-bit floats.
    Pfm,
}

impl Format {
    /// The format that a file name's ending asks for; PNG means 8 bits.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        match extension.as_str() {
            "png" => Some(Self::Png8),
            "ppm" => Some(Self::Ppm),
            "pfm" => Some(Self::Pfm),
            _ => None,
        }
    }

    /// The usual ending of its file names.
    #[must_use]
    pub fn extension(self) -> &'static str {
        match self {
            Self::Png8 | Self::Png16 => "png",
            Self::Ppm => "ppm",
            Self::Pfm => "pfm",
        }
    }
}
