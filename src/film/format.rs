//! The kinds of picture files.

use super::{BitDepth, Encoding, pfm};
use crate::math::Rgb;

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
    /// All of them; of those with the same depth or the same ending, the usual one first.
    pub const ALL: [Self; 4] = [Self::Png8, Self::Png16, Self::Ppm, Self::Pfm];

    /// What its numbers are kept in.
    #[must_use]
    pub fn depth(self) -> BitDepth {
        match self {
            Self::Png8 | Self::Ppm => BitDepth::Eight,
            Self::Png16 => BitDepth::Sixteen,
            Self::Pfm => BitDepth::Float,
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

    /// The bytes of a pixel.
    pub(super) fn pixel_size(self) -> usize {
        3 * match self {
            Self::Png8 | Self::Ppm => size_of::<u8>(),
            Self::Png16 => size_of::<u16>(),
            Self::Pfm => size_of::<f32>(),
        }
    }

    /// Makes colours the bytes of pixels: red, green and blue in turn.
    pub(super) fn store(self, colors: &[Rgb], encoding: Encoding, bytes: &mut [u8]) {
        match self {
            // A code is at most 255, so its low byte is all of it.
            Self::Png8 | Self::Ppm => store(colors, bytes, |channel| {
                let [low, _] = encoding.code(channel, 255).to_le_bytes();
                [low]
            }),
            Self::Png16 => store(colors, bytes, |channel| {
                encoding.code(channel, 65_535).to_be_bytes()
            }),
            Self::Pfm => store(colors, bytes, |channel| pfm::float(channel).to_le_bytes()),
        }
    }
}

/// Makes colours bytes, `SIZE` of them for each channel.
fn store<const SIZE: usize>(colors: &[Rgb], bytes: &mut [u8], stored: impl Fn(f64) -> [u8; SIZE]) {
    let (channels, _) = bytes.as_chunks_mut();
    for (pixel, color) in channels.chunks_exact_mut(3).zip(colors) {
        let [r, g, b] = color.channels();
        pixel.copy_from_slice(&[stored(r), stored(g), stored(b)]);
    }
}
