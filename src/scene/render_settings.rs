//! The picture's size and how its pixels are made.

use super::Setting;
use crate::camera::Pattern;
use crate::film::{BitDepth, Encoding, Rounding, Transfer};
use crate::language::{
    Attribute, Default, Location, Naming, Node, Range, Schema, Takes, Value, ValueError,
};
use crate::math::Numerics;
use crate::texture::Filter;

/// What the scene says about its picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RenderSettings {
    /// Width in pixels; at least 1.
    pub width: u32,
    /// Height in pixels; at least 1.
    pub height: u32,
    /// Rays through each pixel; at least 1.
    pub samples: u32,
    /// How they are spread over the pixel.
    pub pattern: Pattern,
    /// The error that a pixel may probably have, where the largest code value is 1; 0 if all pixels have
    /// as many rays.
    pub max_error: f64,
    /// The curve from intensities to the values that are rounded to code values.
    pub transfer: Transfer,
    /// What its numbers are kept in.
    pub depth: BitDepth,
    /// How values are rounded to code values.
    pub rounding: Rounding,
    /// How much a pixel may lack because mirrored and transmitted rays are not followed for ever,
    /// where the largest code value is 1; by default a quarter of a code value of 255.
    pub cut_off: f64,
    /// What decides where rays meet surfaces.
    pub numerics: Numerics,
    /// What is seen of a texture in a pixel.
    pub texture_filter: Filter,
    /// Where the scene file says so, if it was read from one.
    pub place: Option<Location>,
}

impl RenderSettings {
    /// The longest side in pixels.
    pub const LONGEST_SIDE: u32 = 32_768;
    /// The most pixels; they take 24 bytes each while the picture is made.
    pub const MOST_PIXELS: u64 = 1 << 27;
    /// The most rays through one pixel.
    pub const MOST_SAMPLES: u32 = 65_536;
    /// The fewest rays through a pixel with `max-error`.
    pub const FEWEST_ADAPTIVE: u32 = 4;
    /// The most rays through a pixel with `max-error`, if `samples` does not ask for more.
    pub const MOST_ADAPTIVE: u32 = 4096;

    /// The `image` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "image",
        about: "The picture's width and height in pixels, and how its pixels are made.",
        naming: Naming::None,
        value: Some(
            &Attribute::new(
                "size",
                Takes::Pair(Range::Whole(1, Self::LONGEST_SIDE)),
                "width and height",
            )
            .unit("pixels"),
        ),
        properties: &[
            Attribute::new(
                "samples",
                Takes::Number(Range::Whole(1, Self::MOST_SAMPLES)),
                "rays through each pixel; one goes through its centre",
            )
            .or(Default::Number(1.0)),
            Attribute::new(
                "pattern",
                Takes::Word(&Pattern::WORDS),
                "how several rays are spread over a pixel: `grid` in the centres of equal cells, \
                 `stratified` anywhere in each cell, `sobol` in an Owen-scrambled Sobol sequence, \
                 of which the places on lamps are parts, too, and `random` anywhere; `center` is \
                 for one ray",
            )
            .or(Default::Word(Pattern::Stratified.word())),
            Attribute::new(
                "max-error",
                Takes::Number(Range::Between(0.0, 1.0)),
                "a target: rays are added to a pixel, in its Sobol sequence, until its error, as a \
                 share of the largest code value, is probably no larger; `samples` are then the \
                 fewest, four at least, and 4096 the most; 0 is none",
            )
            .or(Default::Number(0.0)),
            Attribute::new(
                "transfer",
                Takes::Word(&Transfer::WORDS),
                "the curve from intensities to code values: none, as in the chapter, or that of \
                 sRGB, which screens expect",
            )
            .or(Default::Word(Transfer::None.word())),
            Attribute::new(
                "depth",
                Takes::Word(&BitDepth::WORDS),
                "what the picture's numbers are kept in: code values of 8 or of 16 bits, or 32-bit \
                 floats, which are intensities; it chooses between formats as far as neither the \
                 output's name nor `--format` does",
            )
            .or(Default::Word(BitDepth::Eight.word())),
            Attribute::new(
                "quantize",
                Takes::Word(&Rounding::WORDS),
                "to the nearest code value, or to the next lower one",
            )
            .or(Default::Word(Rounding::Nearest.word())),
            Attribute::new(
                "cut-off",
                Takes::Number(Range::Between(0.0, 1.0)),
                "how much a pixel may lack, as a share of the largest code value, because \
                 mirrored and transmitted rays are not followed for ever",
            )
            .or(Default::Number(0.000_98)),
            Attribute::new(
                "numerics",
                Takes::Word(&Numerics::WORDS),
                "what decides where rays meet surfaces; `classic` is the chapter's own algorithm",
            )
            .or(Default::Word(Numerics::Robust.word())),
            Attribute::new(
                "texture-filter",
                Takes::Word(&Filter::WORDS),
                "what is seen of a texture in a pixel: the texel in its middle, or more",
            )
            .or(Default::Word(Filter::Nearest.word())),
        ],
        attributes: &[],
    };

    /// Whether a picture may have this width and height.
    ///
    /// # Errors
    /// Refuses a side of no pixels, a side too long, and too many pixels.
    pub fn check_size([width, height]: [u32; 2]) -> Result<(), ValueError> {
        let sides = 1..=Self::LONGEST_SIDE;
        let reason = if !(sides.contains(&width) && sides.contains(&height)) {
            format!("width and height must be from 1 to {}", Self::LONGEST_SIDE)
        } else if u64::from(width) * u64::from(height) > Self::MOST_PIXELS {
            format!(
                "a picture has at most {} million pixels",
                Self::MOST_PIXELS / 1_000_000
            )
        } else {
            return Ok(());
        };
        Err(ValueError::new("image", reason, "choose a smaller picture"))
    }

    /// Whether the settings make sense together.
    ///
    /// # Errors
    /// Refuses several rays through one place, and a pattern that cannot go on as long as it takes.
    pub fn check(&self) -> Result<(), ValueError> {
        let Self {
            samples,
            pattern,
            max_error,
            ..
        } = self;
        if *max_error > 0.0 && ![Pattern::Stratified, Pattern::Sobol].contains(pattern) {
            let word = pattern.word();
            let reason = format!("with `max-error` rays are added, which {word:?} cannot do");
            let advice = "ask for `pattern=\"sobol\"`, or for no `max-error`";
            let expected = "expected \"sobol\", or no pattern, with `max-error`";
            return Err(ValueError::new("pattern", reason, advice).expected(expected));
        }
        if *pattern == Pattern::Center && *samples > 1 {
            let reason = format!("{samples} rays through the centre of a pixel are the same ray");
            let advice = "ask for `samples=1`, or for another pattern, such as `grid`";
            let expected = "expected one ray with `pattern=\"center\"`";
            return Err(ValueError::new("pattern", reason, advice).expected(expected));
        }
        Ok(())
    }

    /// What an `image` node says.
    ///
    /// # Errors
    /// Refuses a picture that is too large.
    pub fn from_node(node: &Node) -> Result<Self, ValueError> {
        let size = node.value.as_ref().map_or(glam::DVec2::ONE, Value::pair);
        let (width, height) = (whole(size.x), whole(size.y));
        Self::check_size([width, height])?;
        Ok(Self::with_properties([width, height], node))
    }

    /// The same picture with another setting.
    #[must_use]
    pub fn with(self, setting: &Setting) -> Self {
        let mut node = self.describe();
        let mut properties = node.properties.iter_mut();
        let property = properties.find(|entry| entry.attribute.word == setting.word());
        if let Some(property) = property {
            property.value = Some(setting.value().clone());
        }
        node.location = self.place;
        Self::with_properties([self.width, self.height], &node)
    }

    /// How many rays go through each pixel with `max-error` before its error is looked at.
    #[must_use]
    pub fn first_rays(&self) -> u32 {
        self.samples.next_power_of_two().max(Self::FEWEST_ADAPTIVE)
    }

    /// How intensities become code values.
    #[must_use]
    pub fn encoding(&self) -> Encoding {
        Encoding {
            transfer: self.transfer,
            rounding: self.rounding,
        }
    }

    /// How much intensity a pixel may lack, so that it lacks no more than `cut_off` when it is shown,
    /// however dark it is.
    #[must_use]
    pub fn missing_light(&self) -> f64 {
        self.cut_off / self.transfer.max_slope()
    }

    fn with_properties([width, height]: [u32; 2], node: &Node) -> Self {
        let number = |word| node.property(word).map_or(0.0, |value| value.number());
        let word = |word| node.property(word).unwrap_or_else(|| "".into());
        Self {
            width,
            height,
            samples: whole(number("samples")),
            pattern: Pattern::from_word(word("pattern").text()).unwrap_or_default(),
            max_error: number("max-error"),
            transfer: Transfer::from_word(word("transfer").text()).unwrap_or_default(),
            depth: BitDepth::from_word(word("depth").text()).unwrap_or_default(),
            rounding: Rounding::from_word(word("quantize").text()).unwrap_or_default(),
            cut_off: number("cut-off"),
            numerics: Numerics::from_word(word("numerics").text()).unwrap_or_default(),
            texture_filter: Filter::from_word(word("texture-filter").text()).unwrap_or_default(),
            place: node.location,
        }
    }

    /// The settings as a node of the scene language.
    #[must_use]
    pub fn describe(&self) -> Node {
        Node::new(&Self::SCHEMA, None)
            .value([f64::from(self.width), f64::from(self.height)])
            .with_property("samples", f64::from(self.samples))
            .with_property("pattern", self.pattern.word())
            .with_property("max-error", self.max_error)
            .with_property("transfer", self.transfer.word())
            .with_property("depth", self.depth.word())
            .with_property("quantize", self.rounding.word())
            .with_property("cut-off", self.cut_off)
            .with_property("numerics", self.numerics.word())
            .with_property("texture-filter", self.texture_filter.word())
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the schema allows positive whole numbers only"
)]
fn whole(number: f64) -> u32 {
    number as u32
}
