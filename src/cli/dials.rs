//! What of the picture the command line says instead of the scene: its size and the accuracy dials.

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};

use crate::camera::Pattern;
use crate::film::{BitDepth, Rounding, Transfer};
use crate::math::Numerics;
use crate::read;
use crate::scene::{RenderSettings, Setting};
use crate::texture::Filter;

/// Settings of the `image` node.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "The picture, instead of what the scene says")]
pub(super) struct Dials {
    /// Width and height in pixels, such as 800x600.
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = size)]
    size: Option<[u32; 2]>,
    /// Rays through each pixel.
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = number("samples"))]
    samples: Option<Setting>,
    /// How several rays are spread over a pixel.
    #[arg(long, value_name = "WORD", value_parser = word("pattern", &Pattern::WORDS))]
    pattern: Option<Setting>,
    /// Add rays to each pixel until its error is probably no larger, such as 2/255 of white.
    #[arg(long, value_name = "E", allow_hyphen_values = true, value_parser = number("max-error"))]
    max_error: Option<Setting>,
    /// How much of white a pixel may lack because mirrored and transmitted rays are not followed.
    #[arg(long, value_name = "X", allow_hyphen_values = true, value_parser = number("cut-off"))]
    cut_off: Option<Setting>,
    /// The curve from intensities to code values; PFM files, which hold intensities, have none.
    #[arg(long, value_name = "WORD", value_parser = word("transfer", &Transfer::WORDS))]
    transfer: Option<Setting>,
    /// What the picture's numbers are kept in: code values of 8 or 16 bits, or 32-bit floats, which
    /// are intensities.
    #[arg(long, value_name = "WORD", value_parser = word("depth", &BitDepth::WORDS))]
    depth: Option<Setting>,
    /// How intensities are rounded to code values.
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
    /// The depth, if it is said.
    pub(super) fn depth(&self) -> Option<BitDepth> {
        BitDepth::from_word(self.depth.as_ref()?.value().text())
    }

    /// The reader's options with what is said.
    pub(super) fn added_to(&self, options: read::Options) -> read::Options {
        let all = [
            &self.samples,
            &self.pattern,
            &self.max_error,
            &self.cut_off,
            &self.transfer,
            &self.depth,
            &self.quantize,
            &self.numerics,
            &self.texture_filter,
        ];
        read::Options {
            size: self.size,
            settings: all.into_iter().flatten().cloned().collect(),
            ..options
        }
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

/// A width and a height from `800x600`.
fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = text
        .split_once(['x', 'X', '×'])
        .and_then(|(width, height)| {
            Some([width.trim().parse().ok()?, height.trim().parse().ok()?])
        });
    let sides = sides.ok_or_else(|| {
        let longest = RenderSettings::LONGEST_SIDE;
        format!("expected width and height from 1 to {longest}, such as 800x600")
    })?;
    RenderSettings::check_size(sides).map_err(|error| error.reason)?;
    Ok(sides)
}
