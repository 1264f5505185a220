//! The accuracy dials: what of the picture the command line says instead of the scene.

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};

use crate::camera::Pattern;
use crate::film::{Rounding, Transfer};
use crate::math::Numerics;
use crate::scene::Setting;
use crate::texture::Filter;

/// Settings of the `image` node.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Accuracy, instead of what the scene says")]
pub(super) struct Dials {
    /// Rays through each pixel.
    #[arg(long, value_name = "N", value_parser = number("samples"))]
    samples: Option<Setting>,
    /// How several rays are spread over a pixel.
    #[arg(long, value_name = "WORD", value_parser = word("pattern", &Pattern::WORDS))]
    pattern: Option<Setting>,
    /// Add rays to each pixel until its error is probably no larger, such as 2/255 of white.
    #[arg(long, value_name = "E", value_parser = number("max-error"))]
    max_error: Option<Setting>,
    /// How much of white a pixel may lack because mirrored and transmitted rays are not followed.
    #[arg(long, value_name = "X", value_parser = number("cut-off"))]
    cut_off: Option<Setting>,
    /// The curve from intensities to code values; PFM files, which hold intensities, have none.
    #[arg(long, value_name = "WORD", value_parser = word("transfer", &Transfer::WORDS))]
    transfer: Option<Setting>,
    /// How they are rounded to code values.
    #[arg(long, value_name = "WORD", value_parser = word("quantize", &Rounding::WORDS))]
    quantize: Option<Setting>,
    /// What decides where rays meet surfaces; the classic ones are the chapter's own algorithm.
    #[arg(long, value_name = "WORD", value_parser = word("numerics", &Numerics::WORDS))]
    numerics: Option<Setting>,
    /// What is seen of a texture in a pixel: the texel in its middle, or more.
    #[arg(long, value_name = "WORD", value_parser = word("texture-filter", &Filter::WORDS))]
    texture_filter: Option<Setting>,
}

impl Dials {
    /// What is said, in the order of the fields.
    pub(super) fn settings(&self) -> Vec<Setting> {
        let all = [
            &self.samples,
            &self.pattern,
            &self.max_error,
            &self.cut_off,
            &self.transfer,
            &self.quantize,
            &self.numerics,
            &self.texture_filter,
        ];
        all.into_iter().flatten().cloned().collect()
    }
}

/// A number for a property of the picture.
fn number(property: &'static str) -> impl TypedValueParser<Value = Setting> {
    clap::builder::StringValueParser::new().try_map(move |text| Setting::new(property, &text))
}

/// A word for a property of the picture.
fn word(
    property: &'static str,
    words: &'static [&'static str],
) -> impl TypedValueParser<Value = Setting> {
    PossibleValuesParser::new(words).try_map(move |text| Setting::new(property, &text))
}
