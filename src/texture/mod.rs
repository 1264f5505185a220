//! Images laid over surfaces.

mod anisotropic;
mod area;
mod bilinear;
mod classic;
mod decode;
mod fetches;
mod filter;
mod map;
mod pnm;
mod polygon;
mod pyramid;
mod sums;
mod wrap;

pub use classic::{gettexel, texture_map};
pub use decode::{DecodeError, ImageFileError, LONGEST_SIDE, MOST_TEXELS, check, decode};
pub use fetches::fetched_by_this_thread;
pub use filter::Filter;
pub use map::TextureMap;
pub use wrap::Wrap;

use std::path::PathBuf;
use std::sync::OnceLock;

use crate::language::{Attribute, Default, Naming, Node, Range, Schema, Takes};
use crate::math::Rgb;
use pyramid::Pyramid;
use sums::Sums;

/// The chapter's `texture_t`: the texels of one image, and how to look one up.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    /// The name that surfaces use.
    pub name: String,
    /// The file as the scene names it.
    pub file: String,
    /// The file that was read.
    pub path: PathBuf,
    /// The texels.
    pub texels: Texels,
    divisor: f64,
    /// What a channel is divided by.
    unit: f64,
    /// The intensity of every value that a channel can have.
    intensities: Vec<f64>,
    mean: Rgb,
    /// Made when a filter first asks for it.
    pyramid: OnceLock<Pyramid>,
    sums: OnceLock<Sums>,
}

/// The texels of an image, row by row from the top.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Texels {
    /// Texels in a row; at least 1.
    pub width: usize,
    /// Rows; at least 1.
    pub height: usize,
    /// Red, green and blue of each texel.
    pub channels: Vec<[u16; 3]>,
    /// Whether the channels have 16 bits instead of 8.
    pub deep: bool,
}

impl Texture {
    /// The `texture` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "texture",
        about: "An image file that surfaces can wear.",
        naming: Naming::Required,
        value: Some(&Attribute::new(
            "file",
            Takes::Path,
            "PNG, JPEG, PPM or PGM; relative to the scene file",
        )),
        properties: &[Attribute::new(
            "divisor",
            Takes::Number(Range::Between(255.0, 256.0)),
            "what an 8-bit channel is divided by; 256 is the course preset's",
        )
        .or(Default::Number(255.0))],
        attributes: &[],
    };

    /// A texture of these texels, read from a file that the scene calls `file`.
    ///
    /// `divisor` is what an 8-bit channel is divided by: 255, or 256 as in the course's programs.
    #[must_use]
    pub fn new(name: &str, file: &str, path: PathBuf, texels: Texels, divisor: f64) -> Self {
        const SIXTEEN_BITS_PER_EIGHT: f64 = 257.0;
        let (largest, unit) = if texels.deep {
            (u16::MAX, divisor * SIXTEEN_BITS_PER_EIGHT)
        } else {
            (u16::from(u8::MAX), divisor)
        };
        let intensities = (0..=largest)
            .map(|channel| f64::from(channel) / unit)
            .collect();
        let mean = mean(&texels) / unit;
        let (name, file) = (name.to_owned(), file.to_owned());
        Self {
            name,
            file,
            path,
            texels,
            divisor,
            unit,
            intensities,
            mean,
            pyramid: OnceLock::new(),
            sums: OnceLock::new(),
        }
    }

    /// The colour of a texel; column from the left, row from the top.
    ///
    /// # Panics
    /// If there is no such texel.
    #[must_use]
    #[inline]
    pub fn texel(&self, column: usize, row: usize) -> Rgb {
        fetches::note(1);
        self.color(column, row)
    }

    fn color(&self, column: usize, row: usize) -> Rgb {
        let [r, g, b] = self.texels.channels[row * self.texels.width + column];
        let intensity = |channel| self.intensities[usize::from(channel)];
        Rgb::new(intensity(r), intensity(g), intensity(b))
    }

    /// The same as [`texel_upwards`](Self::texel_upwards), for what is made once and no picture's work.
    fn uncounted(&self, column: usize, row: usize) -> Rgb {
        self.color(column, self.texels.height - 1 - row)
    }

    /// The colour of a texel; column from the left, row from the bottom.
    fn texel_upwards(&self, column: usize, row: usize) -> Rgb {
        // Images are stored from the top.
        self.texel(column, self.texels.height - 1 - row)
    }

    fn pyramid(&self) -> &Pyramid {
        self.pyramid.get_or_init(|| Pyramid::new(self))
    }

    /// The mean colour of all texels.
    #[must_use]
    pub fn mean(&self) -> Rgb {
        self.mean
    }

    /// The texture as a node of the scene language.
    #[must_use]
    pub fn describe(&self) -> Node {
        Node::new(&Self::SCHEMA, Some(&self.name))
            .value(self.file.as_str())
            .with_property("divisor", self.divisor)
    }
}

/// The mean channels of all texels.
fn mean(texels: &Texels) -> Rgb {
    // At most 2^28 texels of 16 bits, so the sums are whole numbers that fit.
    let sum = texels.channels.iter().fold([0u64; 3], |sum, texel| {
        std::array::from_fn(|channel| sum[channel] + u64::from(texel[channel]))
    });
    #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
    let ([r, g, b], count) = (sum.map(|sum| sum as f64), texels.channels.len() as f64);
    Rgb::new(r, g, b) / count
}
