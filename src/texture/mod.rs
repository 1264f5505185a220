//! Images laid over surfaces, and their filters.

mod anisotropic;
mod area;
mod bilinear;
mod classic;
mod decode;
mod fetches;
mod filter;
mod map;
mod polygon;
mod pyramid;
mod summed_area;
mod texels;
mod wrap;

pub use classic::{gettexel, texture_map};
pub use decode::{check, decode};
pub use fetches::fetched_by_this_thread;
pub use filter::Filter;
pub use map::TextureMap;
pub use texels::Texels;
pub use wrap::Wrap;

use std::path::PathBuf;
use std::sync::OnceLock;

use crate::language::{Attribute, Default, Naming, Node, Range, Schema, Takes};
use crate::math::Rgb;
use bilinear::Image;
use pyramid::Pyramid;
use summed_area::SummedAreaTable;

/// The chapter's `texture_t`: the texels of an image, and their colours.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    /// The name that surfaces use.
    pub name: String,
    /// The file as the scene names it.
    pub file: String,
    /// The path of the file.
    pub path: PathBuf,
    /// The texels.
    pub texels: Texels,
    divisor: f64,
    /// The channel value of intensity 1.
    unit: f64,
    /// The intensity of each channel value.
    intensities: Vec<f64>,
    mean: Rgb,
    /// Made for the first filter that needs it.
    pyramid: OnceLock<Pyramid>,
    /// Made for the first filter that needs it.
    sums: OnceLock<SummedAreaTable>,
}

impl Texture {
    /// The `texture` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "texture",
        about: "An image file for surfaces.",
        naming: Naming::Required,
        value: Some(&Attribute::new(
            "file",
            Takes::Path,
            "PNG, JPEG, PPM or PGM; relative to the scene file",
        )),
        properties: &[Attribute::new(
            "divisor",
            Takes::Number(Range::Between(255.0, 256.0)),
            "divisor of an 8-bit channel; 256 in the course preset",
        )
        .or(Default::Number(255.0))],
        attributes: &[],
    };

    /// A texture of texels from a file that the scene calls `file`.
    ///
    /// `divisor` is the divisor of an 8-bit channel: 255, or 256 as in the course's programs.
    #[must_use]
    pub fn new(name: &str, file: &str, path: PathBuf, texels: Texels, divisor: f64) -> Self {
        const SIXTEEN_BITS_PER_EIGHT: f64 = 257.0;
        let (largest, unit) = if texels.deep {
            (u16::MAX, divisor * SIXTEEN_BITS_PER_EIGHT)
        } else {
            (u16::from(u8::MAX), divisor)
        };
        let intensity = |channel: u16| f64::from(channel) / unit;
        Self {
            name: name.to_owned(),
            file: file.to_owned(),
            path,
            divisor,
            unit,
            intensities: (0..=largest).map(intensity).collect(),
            mean: texels.mean() / unit,
            texels,
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
        fetches::add_fetches(1);
        self.color_from_top(column, row)
    }

    fn color_from_top(&self, column: usize, row: usize) -> Rgb {
        let [r, g, b] = self.texels.channels[row * self.texels.width + column];
        let intensity = |channel| self.intensities[usize::from(channel)];
        Rgb::new(intensity(r), intensity(g), intensity(b))
    }

    fn pyramid(&self) -> &Pyramid {
        self.pyramid.get_or_init(|| Pyramid::new(self))
    }

    fn sums(&self) -> &SummedAreaTable {
        let new = || SummedAreaTable::new(&self.texels, self.unit);
        self.sums.get_or_init(new)
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

impl Image for Texture {
    fn sides(&self) -> [usize; 2] {
        [self.texels.width, self.texels.height]
    }

    fn color(&self, column: usize, row: usize) -> Rgb {
        self.color_from_top(column, self.texels.height - 1 - row)
    }
}
