//! The accuracy dials, as data.

use crate::plan::Effect;
use crate::scene::{RenderSettings, Setting};

/// A property of the `image` node that buys accuracy for time, and what is tried of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dial {
    /// The property's word.
    pub word: &'static str,
    /// What it is set to in turn.
    pub steps: &'static [&'static str],
    /// What else is set while it is.
    pub beside: &'static [(&'static str, &'static str)],
    /// The effects of which at least one has to be on for it to matter; none if it always does.
    pub matters_for: &'static [Effect],
    /// What gives the most accurate picture; `None` if the reference chooses for itself.
    pub best: Option<&'static str>,
    /// Whether its error is that against the reference; else it is how far the picture is from the same
    /// one with this dial at its best.
    pub by_reference: bool,
    /// Whether it shapes what is written only, so that pictures are compared as they are written.
    pub in_writing: bool,
}

/// Rays that go on from surfaces.
const BOUNCES: &[Effect] = &[Effect::Mirrors, Effect::Transparency, Effect::Refraction];

/// The accuracy dials in the order in which they are tried.
pub const DIALS: &[Dial] = &[
    Dial {
        word: "samples",
        steps: &["1", "2", "3", "4", "6", "9", "16", "25"],
        by_reference: true,
        ..Dial::PLAIN
    },
    Dial {
        word: "pattern",
        steps: &["random", "grid", "stratified", "sobol"],
        beside: &[("samples", "16")],
        // The reference's halves have nothing in common only if they are stratified.
        best: Some("stratified"),
        by_reference: true,
        ..Dial::PLAIN
    },
    Dial {
        word: "max-error",
        // Less takes more rays, and a reference of more samples still.
        steps: &["0.1", "0.05", "0.025"],
        best: Some("0"),
        by_reference: true,
        ..Dial::PLAIN
    },
    Dial {
        word: "texture-filter",
        steps: &["nearest", "bilinear", "mipmap", "anisotropic", "exact"],
        matters_for: &[Effect::Textures],
        best: Some("exact"),
        ..Dial::PLAIN
    },
    Dial {
        word: "cut-off",
        steps: &["1", "0.25", "0.0625", "0.016", "0.004", "0.00098", "6e-5"],
        matters_for: BOUNCES,
        best: Some("0.00001"),
        ..Dial::PLAIN
    },
    Dial {
        word: "numerics",
        steps: &["classic-f32", "classic", "robust"],
        best: Some("robust"),
        ..Dial::PLAIN
    },
    Dial {
        word: "depth",
        steps: &["8", "16", "float"],
        in_writing: true,
        ..Dial::PLAIN
    },
    Dial {
        word: "quantize",
        steps: &["truncate", "round"],
        in_writing: true,
        ..Dial::PLAIN
    },
];

impl Dial {
    const PLAIN: Self = Self {
        word: "",
        steps: &[],
        beside: &[],
        matters_for: &[],
        best: None,
        by_reference: false,
        in_writing: false,
    };

    /// Those that the `image` node has.
    pub fn all() -> impl Iterator<Item = &'static Self> {
        DIALS.iter().filter(|dial| dial.exists())
    }

    /// The dial with this word.
    #[must_use]
    pub fn of(word: &str) -> Option<&'static Self> {
        DIALS.iter().find(|dial| dial.word == word)
    }

    /// Whether it can change a picture that these effects are simulated in.
    #[must_use]
    pub fn matters(&self, on: &[Effect]) -> bool {
        self.matters_for.is_empty() || self.matters_for.iter().any(|effect| on.contains(effect))
    }

    /// Whether the `image` node has it.
    #[must_use]
    fn exists(&self) -> bool {
        let mut properties = RenderSettings::SCHEMA.properties.iter();
        properties.any(|property| property.word == self.word)
    }

    /// The setting that gives the most accurate picture.
    #[must_use]
    pub fn best(&self) -> Option<Setting> {
        Setting::new(self.word, self.best?).ok()
    }
}

/// A picture's settings with each dial at its best.
pub(super) fn best_of(picture: RenderSettings) -> RenderSettings {
    let best = Dial::all().filter_map(Dial::best);
    best.fold(picture, |picture, setting| picture.with(&setting))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_step_of_every_dial_can_be_set() {
        for dial in Dial::all() {
            let beside = dial.beside.iter().copied();
            let steps = dial.steps.iter().chain(&dial.best);
            for (word, text) in steps.map(|step| (dial.word, *step)).chain(beside) {
                assert!(Setting::new(word, text).is_ok(), "{word}={text}");
            }
        }
    }

    #[test]
    fn every_property_of_the_picture_is_a_dial() {
        // The curve is a matter of taste: no other picture is righter.
        let properties = RenderSettings::SCHEMA.properties.iter();
        for property in properties.filter(|property| property.word != "transfer") {
            assert!(Dial::of(property.word).is_some(), "{}", property.word);
        }
    }
}
