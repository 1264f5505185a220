//! Picture file formats.

use super::bit_depth::{BitDepth, float};
use super::encoding::Encoding;
use crate::math::Rgb;

/// A picture file format.
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
    /// All formats; of those with the same depth or extension, the usual one first.
    pub const ALL: [Self; 4] = [Self::Png8, Self::Png16, Self::Ppm, Self::Pfm];

    /// The number format of its channels.
    #[must_use]
    pub fn depth(self) -> BitDepth {
        match self {
            Self::Png8 | Self::Ppm => BitDepth::Eight,
            Self::Png16 => BitDepth::Sixteen,
            Self::Pfm => BitDepth::Float,
        }
    }

    /// The usual extension of its file names.
    #[must_use]
    pub fn extension(self) -> &'static str {
        match self {
            Self::Png8 | Self::Png16 => "png",
            Self::Ppm => "ppm",
            Self::Pfm => "pfm",
        }
    }

    /// Bytes of a pixel.
    pub(super) fn pixel_size(self) -> usize {
        3 * match self.depth() {
            BitDepth::Eight => size_of::<u8>(),
            BitDepth::Sixteen => size_of::<u16>(),
            BitDepth::Float => size_of::<f32>(),
        }
    }

    /// Encodes colours as the bytes of pixels: red, green and blue in turn.
    pub(super) fn encode(self, colors: &[Rgb], encoding: Encoding, bytes: &mut [u8]) {
        match self.depth() {
            // A code is at most 255, so its low byte is all of it.
            BitDepth::Eight => encode(colors, bytes, |channel| {
                let [low, _] = encoding.code(channel, 255).to_le_bytes();
                [low]
            }),
            BitDepth::Sixteen => encode(colors, bytes, |channel| {
                encoding.code(channel, 65_535).to_be_bytes()
            }),
            BitDepth::Float => encode(colors, bytes, |channel| float(channel).to_le_bytes()),
        }
    }
}

/// Encodes colours with `SIZE` bytes a channel.
fn encode<const SIZE: usize>(
    colors: &[Rgb],
    bytes: &mut [u8],
    channel: impl Fn(f64) -> [u8; SIZE],
) {
    let (channels, _) = bytes.as_chunks_mut();
    for (pixel, color) in channels.chunks_exact_mut(3).zip(colors) {
        let [r, g, b] = color.channels();
        pixel.copy_from_slice(&[channel(r), channel(g), channel(b)]);
    }
}
