//! Pixels in memory and on disk.

mod format;
mod load;
mod pfm;
mod png;
mod ppm;
mod print;
mod quantize;
mod region;
mod save;

pub use format::Format;
pub use print::{Print, PrintRow};
pub use quantize::Rounding;
pub use region::Region;
pub use save::{discard_unfinished, save};

use std::io::{self, Write};

use crate::math::Rgb;

/// A picture of linear, unclamped colours; rows from top to bottom.
///
/// No transfer curve is applied, as in the chapter: intensity 1 is the largest code value.
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
        let count = width.checked_mul(height)?;
        let mut pixels = Vec::new();
        pixels.try_reserve_exact(count).ok()?;
        pixels.resize(count, Rgb::BLACK);
        Some(Self {
            width,
            height,
            pixels,
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
    pub fn bytes(&self, rounding: Rounding) -> Vec<u8> {
        let mut bytes = vec![0; 3 * self.pixels.len()];
        Format::Ppm.store(&self.pixels, rounding, &mut bytes);
        bytes
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
        rounding: Rounding,
        notes: &Notes,
    ) -> io::Result<()> {
        let print = Print::of(self, format, rounding);
        print.ok_or(io::ErrorKind::OutOfMemory)?.write(out, notes)
    }
}
