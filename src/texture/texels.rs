//! Texels of an image, with 8 or 16 bits a channel.

use crate::image_file::Pixels;
use crate::math::Rgb;

/// The texels of an image, row by row from the top.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Texels {
    /// Width in texels, at least 1.
    pub width: usize,
    /// Height in texels, at least 1.
    pub height: usize,
    /// Red, green and blue of each texel.
    pub channels: Vec<[u16; 3]>,
    /// True for channels of 16 bits, false for 8 bits.
    pub deep: bool,
}

impl Texels {
    /// The mean channels of all texels.
    pub(super) fn mean(&self) -> Rgb {
        // At most 2^28 texels of 16 bits: the sums are exact.
        let sum = self.channels.iter().fold([0u64; 3], |sum, texel| {
            std::array::from_fn(|channel| sum[channel] + u64::from(texel[channel]))
        });
        #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
        let ([r, g, b], count) = (sum.map(|sum| sum as f64), self.channels.len() as f64);
        Rgb::new(r, g, b) / count
    }
}

impl From<Pixels> for Texels {
    /// Scales channels to 16 bits, rounded, unless they have 8 or 16 bits already.
    fn from(pixels: Pixels) -> Self {
        let (largest, mut channels) = (u32::from(pixels.largest), pixels.channels);
        if ![0xFF, 0xFFFF].contains(&largest) {
            for channel in channels.as_flattened_mut() {
                let scaled = (u32::from(*channel) * 0xFFFF + largest / 2) / largest;
                *channel = u16::try_from(scaled).unwrap_or(u16::MAX);
            }
        }
        Self {
            width: pixels.width,
            height: pixels.height,
            channels,
            deep: largest != 0xFF,
        }
    }
}
