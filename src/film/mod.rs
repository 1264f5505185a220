//! Pixels in memory and in picture files.

mod bit_depth;
mod encoded_image;
mod encoding;
mod format;
mod read;
mod region;
mod save;
mod transfer;
mod write;

pub use bit_depth::BitDepth;
pub use encoded_image::{EncodedImage, EncodedRow};
pub use encoding::{Encoding, Rounding};
pub use format::Format;
pub use region::Region;
pub use save::{check_writable, discard_unfinished, save};
pub use transfer::Transfer;
pub use write::Notes;

use crate::math::Rgb;

/// A framebuffer: linear, unclamped colours, row by row from the top.
///
/// Intensity 1 becomes the largest code value; an [`Encoding`] maps the others.
#[derive(Debug, Clone, PartialEq)]
pub struct Film {
    width: usize,
    height: usize,
    pixels: Vec<Rgb>,
}

impl Film {
    /// A black picture; `None` if memory is short.
    #[must_use]
    pub fn new(width: usize, height: usize) -> Option<Self> {
        Some(Self {
            width,
            height,
            pixels: filled([width, height], Rgb::BLACK)?,
        })
    }

    /// The width in pixels.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// The height in pixels.
    #[must_use]
    pub fn height(&self) -> usize {
        self.height
    }

    /// All pixels, row by row from the top.
    #[must_use]
    pub fn pixels(&self) -> &[Rgb] {
        &self.pixels
    }

    /// All pixels for writing, row by row from the top.
    pub fn pixels_mut(&mut self) -> &mut [Rgb] {
        &mut self.pixels
    }

    /// The pixel in a column from the left and a row from the top.
    #[must_use]
    pub fn pixel(&self, column: usize, row: usize) -> Rgb {
        self.pixels[row * self.width + column]
    }

    /// The code values of 8-bit formats: red, green and blue of each pixel in turn.
    #[must_use]
    pub fn bytes(&self, encoding: impl Into<Encoding>) -> Vec<u8> {
        let mut bytes = vec![0; 3 * self.pixels.len()];
        Format::Ppm.encode(&self.pixels, encoding.into(), &mut bytes);
        bytes
    }

    /// The picture in display values: the transfer curve is applied to each channel.
    #[must_use]
    pub fn displayed(mut self, transfer: Transfer) -> Self {
        if transfer != Transfer::None {
            for pixel in &mut self.pixels {
                let [r, g, b] = pixel.channels().map(|channel| transfer.value(channel));
                *pixel = Rgb::new(r, g, b);
            }
        }
        self
    }

    /// Hash of the picture before quantisation: its size and the bits of each channel.
    #[must_use]
    pub fn hash(&self) -> String {
        let mut hasher = blake3::Hasher::new();
        for side in [self.width, self.height] {
            hasher.update(&(side as u64).to_le_bytes());
        }
        for channel in self.pixels.iter().flat_map(|pixel| pixel.channels()) {
            hasher.update(&channel.to_le_bytes());
        }
        hasher.finalize().to_hex().to_string()
    }

    /// Column and row of each pixel with an infinite or NaN channel.
    pub fn non_finite(&self) -> impl Iterator<Item = (usize, usize)> {
        let pixels = self.pixels.iter().enumerate();
        let non_finite = pixels.filter(|(_, pixel)| !pixel.is_finite());
        non_finite.map(|(index, _)| (index % self.width, index / self.width))
    }
}

/// Equal elements, as many as the product of the sides; `None` if memory is short.
fn filled<T: Clone, const SIDES: usize>(sides: [usize; SIDES], element: T) -> Option<Vec<T>> {
    let count = sides.into_iter().try_fold(1, usize::checked_mul)?;
    let mut all = Vec::new();
    all.try_reserve_exact(count).ok()?;
    all.resize(count, element);
    Some(all)
}
