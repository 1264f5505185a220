//! Pixels in memory and on disk.

mod bit_depth;
mod encoded_image;
mod encoding;
mod format;
mod load;
mod pfm;
mod png;
mod ppm;
mod region;
mod rounding;
mod save;
mod transfer;

pub use bit_depth::BitDepth;
pub use encoded_image::{EncodedImage, EncodedRow};
pub use encoding::Encoding;
pub use format::Format;
pub use region::Region;
pub use rounding::Rounding;
pub use save::{check_place, discard_unfinished, save};
pub use transfer::Transfer;

use std::io::{self, Write};

use crate::math::Rgb;

/// A picture of linear, unclamped colours; rows from top to bottom.
///
/// Intensity 1 becomes the largest code value; how the others become code values is said where they do,
/// by an [`Encoding`].
#[derive(Debug, Clone, PartialEq)]
pub struct Film {
    width: usize,
    height: usize,
    pixels: Vec<Rgb>,
}

/// What goes into a picture file beside the pixels.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Notes(pub Vec<(&'static str, String)>);

impl Film {
    /// A black picture; `None` if there is no memory for it.
    #[must_use]
    pub fn new(width: usize, height: usize) -> Option<Self> {
        Some(Self {
            width,
            height,
            pixels: blank([width, height], Rgb::BLACK)?,
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

    /// All pixels to be written, row by row from the top.
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
        Format::Ppm.store(&self.pixels, encoding.into(), &mut bytes);
        bytes
    }

    /// The picture as it is shown: each channel is the value that its code value is a share of.
    #[must_use]
    pub fn shown(mut self, transfer: Transfer) -> Self {
        if transfer != Transfer::None {
            for pixel in &mut self.pixels {
                let [r, g, b] = pixel.channels().map(|channel| transfer.value(channel));
                *pixel = Rgb::new(r, g, b);
            }
        }
        self
    }

    /// A fingerprint of the picture before it is quantised: its size and the bits of every channel.
    #[must_use]
    pub fn hash(&self) -> String {
        let mut hasher = blake3::Hasher::new();
        for side in [self.width, self.height] {
            hasher.update(&(side as u64).to_le_bytes());
        }
        for pixel in &self.pixels {
            for channel in pixel.channels() {
                hasher.update(&channel.to_le_bytes());
            }
        }
        hasher.finalize().to_hex().to_string()
    }

    /// Column and row of every pixel with an infinite or not-a-number channel.
    pub fn non_finite(&self) -> impl Iterator<Item = (usize, usize)> {
        let odd = self
            .pixels
            .iter()
            .enumerate()
            .filter(|(_, pixel)| !pixel.is_finite());
        odd.map(|(index, _)| (index % self.width, index / self.width))
    }

    /// Writes the picture as a file of this format.
    ///
    /// # Errors
    /// Whatever the writer fails with.
    pub fn write(
        &self,
        out: &mut dyn Write,
        format: Format,
        encoding: impl Into<Encoding>,
        notes: &Notes,
    ) -> io::Result<()> {
        let print = EncodedImage::of(self, format, encoding.into());
        print.ok_or(io::ErrorKind::OutOfMemory)?.write(out, notes)
    }
}

/// As many times the same as these sides make together; `None` if there is no memory for it.
fn blank<T: Clone, const SIDES: usize>(sides: [usize; SIDES], one: T) -> Option<Vec<T>> {
    let count = sides.into_iter().try_fold(1, usize::checked_mul)?;
    let mut all = Vec::new();
    all.try_reserve_exact(count).ok()?;
    all.resize(count, one);
    Some(all)
}
