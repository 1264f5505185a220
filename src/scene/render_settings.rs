//! The picture's size and how its pixels are made.

use super::{SETTINGS, Setting};
use crate::camera::Pattern;
use crate::film::{BitDepth, Encoding, Rounding, Transfer};
use crate::language::{Attribute, Location, Naming, Node, Range, Schema, Takes, Value, ValueError};
use crate::math::Numerics;
use crate::texture::Filter;

/// The picture's size, and the accuracy and encoding of its pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RenderSettings {
    /// Width in pixels, at least 1.
    pub width: u32,
    /// Height in pixels, at least 1.
    pub height: u32,
    /// Rays through each pixel, at least 1; the smallest number with [`max_error`](Self::max_error).
    pub samples: u32,
    /// Placement of the rays in a pixel.
    pub pattern: Pattern,
    /// Target for a pixel's error, where the largest code value is 1; 0 for none.
    pub max_error: f64,
    /// Curve from intensities to the values that are rounded to code values.
    pub transfer: Transfer,
    /// Number format of the picture.
    pub depth: BitDepth,
    /// Rounding of values to code values.
    pub rounding: Rounding,
    /// Most that a pixel may lose because mirrored and transmitted rays are not followed forever,
    /// where the largest code value is 1.
    pub cut_off: f64,
    /// Arithmetic that decides where rays hit surfaces.
    pub numerics: Numerics,
    /// Colour that a pixel takes from a texture.
    pub texture_filter: Filter,
    /// Place of the `image` node, if the settings were read from a file.
    pub place: Option<Location>,
}

impl RenderSettings {
    /// Longest side in pixels.
    pub const LONGEST_SIDE: u32 = 32_768;
    /// Largest number of pixels; each takes 24 bytes while the picture is rendered.
    pub const MOST_PIXELS: u64 = 1 << 27;
    /// Largest number of rays through one pixel.
    pub const MOST_SAMPLES: u32 = 65_536;
    /// Smallest number of rays through a pixel with `max-error`.
    pub const FEWEST_ADAPTIVE: u32 = 4;
    /// Largest number of rays through a pixel with `max-error`, unless `samples` is larger.
    pub const MOST_ADAPTIVE: u32 = 4096;

    /// A picture of one pixel with the defaults of the scene language.
    pub const DEFAULT: Self = Self {
        width: 1,
        height: 1,
        samples: 1,
        pattern: Pattern::Stratified,
        max_error: 0.0,
        transfer: Transfer::None,
        depth: BitDepth::Eight,
        rounding: Rounding::Nearest,
        // A quarter of a code value of 255.
        cut_off: 0.000_98,
        numerics: Numerics::Robust,
        texture_filter: Filter::Nearest,
        place: None,
    };

    /// The `image` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "image",
        about: "Size and accuracy of the picture.",
        naming: Naming::None,
        value: Some(
            &Attribute::new(
                "size",
                Takes::Pair(Range::Whole(1, Self::LONGEST_SIDE)),
                "width and height",
            )
            .unit("pixels"),
        ),
        properties: &PROPERTIES,
        attributes: &[],
    };

    /// Checks a width and a height.
    ///
    /// # Errors
    /// Refuses an empty side, a side above [`LONGEST_SIDE`](Self::LONGEST_SIDE), and more pixels than
    /// [`MOST_PIXELS`](Self::MOST_PIXELS).
    pub fn check_size([width, height]: [u32; 2]) -> Result<(), ValueError> {
        let sides = 1..=Self::LONGEST_SIDE;
        let reason = if !(sides.contains(&width) && sides.contains(&height)) {
            format!("width and height must be from 1 to {}", Self::LONGEST_SIDE)
        } else if u64::from(width) * u64::from(height) > Self::MOST_PIXELS {
            let millions = Self::MOST_PIXELS / 1_000_000;
            format!("a picture has at most {millions} million pixels")
        } else {
            return Ok(());
        };
        Err(ValueError::new("image", reason, "choose a smaller picture"))
    }

    /// Checks the settings against each other.
    ///
    /// # Errors
    /// Refuses several rays through a pixel's centre, and `max-error` with a pattern that cannot be
    /// continued.
    pub fn check(&self) -> Result<(), ValueError> {
        let (samples, pattern) = (self.samples, self.pattern);
        let (reason, advice, expected) = if self.max_error > 0.0
            && ![Pattern::Stratified, Pattern::Sobol].contains(&pattern)
        {
            let word = pattern.word();
            (
                format!("`max-error` adds rays to a pixel, which the pattern {word:?} cannot do"),
                "set `pattern=\"sobol\"`, or remove `max-error`",
                "expected \"sobol\", or no pattern, with `max-error`",
            )
        } else if pattern == Pattern::Center && samples > 1 {
            (
                format!("{samples} rays through the centre of a pixel are the same ray"),
                "set `samples=1`, or another pattern, such as `grid`",
                "expected one ray with `pattern=\"center\"`",
            )
        } else {
            return Ok(());
        };
        Err(ValueError::new("pattern", reason, advice).expected(expected))
    }

    /// The settings that an `image` node gives.
    ///
    /// # Errors
    /// Refuses a picture that is too large.
    pub fn from_node(node: &Node) -> Result<Self, ValueError> {
        let size = node.value.as_ref().map_or(glam::DVec2::ONE, Value::pair);
        let [width, height] = [whole(size.x), whole(size.y)];
        Self::check_size([width, height])?;
        let mut settings = Self {
            width,
            height,
            place: node.location,
            ..Self::DEFAULT
        };
        for kind in SETTINGS {
            if let Some(value) = node.property(kind.word) {
                (kind.set)(&mut settings, &value);
            }
        }
        Ok(settings)
    }

    /// The same settings but for one.
    #[must_use]
    pub fn with(mut self, setting: &Setting) -> Self {
        (setting.kind().set)(&mut self, setting.value());
        self
    }

    /// The settings as a node of the scene language.
    #[must_use]
    pub fn describe(&self) -> Node {
        let size = [f64::from(self.width), f64::from(self.height)];
        let node = Node::new(&Self::SCHEMA, None).value(size);
        SETTINGS.iter().fold(node, |node, kind| {
            node.with_property(kind.word, (kind.get)(self))
        })
    }

    /// Rays through each pixel with `max-error` before its error is estimated.
    #[must_use]
    pub fn first_rays(&self) -> u32 {
        self.samples.next_power_of_two().max(Self::FEWEST_ADAPTIVE)
    }

    /// The way from intensities to code values.
    #[must_use]
    pub fn encoding(&self) -> Encoding {
        Encoding {
            transfer: self.transfer,
            rounding: self.rounding,
        }
    }

    /// Intensity that a pixel may lose, so that its shown value loses at most
    /// [`cut_off`](Self::cut_off), however dark the pixel is.
    #[must_use]
    pub fn missing_light(&self) -> f64 {
        self.cut_off / self.transfer.max_slope()
    }
}

/// The properties of the `image` node: the table of settings in the form of a schema.
const PROPERTIES: [Attribute; SETTINGS.len()] = {
    let mut properties = [SETTINGS[0].attribute(); SETTINGS.len()];
    let mut next = 1;
    while next < SETTINGS.len() {
        properties[next] = SETTINGS[next].attribute();
        next += 1;
    }
    properties
};

/// A number that the schema has found to be whole and positive.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the schema allows positive whole numbers only"
)]
pub(super) fn whole(number: f64) -> u32 {
    number as u32
}
