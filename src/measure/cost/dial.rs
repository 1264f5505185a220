//! Settings that `cost` varies, in the order in which it tries them.

use crate::plan::Effect;
use crate::scene::{RenderSettings, SETTINGS, Setting};

pub use crate::scene::SettingKind as Dial;

/// The settings that have steps, by their rank.
pub const DIALS: [&Dial; 8] = {
    let mut dials = [&SETTINGS[0]; 8];
    let mut next = 0;
    while next < SETTINGS.len() {
        if SETTINGS[next].rank > 0 {
            dials[SETTINGS[next].rank - 1] = &SETTINGS[next];
        }
        next += 1;
    }
    dials
};

impl Dial {
    /// The setting with this word, if it has steps.
    #[must_use]
    pub fn of(word: &str) -> Option<&'static Self> {
        DIALS.into_iter().find(|dial| dial.word == word)
    }

    /// True if it can change a picture in which these effects are simulated.
    #[must_use]
    pub fn matters(&self, on: &[Effect]) -> bool {
        let effects: &[Effect] = match self.word {
            "texture-filter" => &[Effect::Textures],
            "cut-off" => &[Effect::Mirrors, Effect::Transparency, Effect::Refraction],
            _ => return true,
        };
        effects.iter().any(|effect| on.contains(effect))
    }

    /// The setting with its most accurate value, if it has one.
    #[must_use]
    pub fn best(&self) -> Option<Setting> {
        Setting::new(self.word, self.best?).ok()
    }
}

/// A picture's settings with the most accurate value of each.
pub(super) fn best_of(picture: RenderSettings) -> RenderSettings {
    let best = DIALS.into_iter().filter_map(Dial::best);
    best.fold(picture, |picture, setting| picture.with(&setting))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_step_of_every_dial_can_be_set() {
        for dial in DIALS {
            let together = dial.together_with.iter().copied();
            let steps = dial.steps.iter().chain(&dial.best);
            for (word, text) in steps.map(|step| (dial.word, *step)).chain(together) {
                assert!(Setting::new(word, text).is_ok(), "{word}={text}");
            }
        }
    }

    #[test]
    fn every_setting_with_steps_has_a_rank_of_its_own() {
        // The curve is a matter of taste: no other picture is more accurate.
        for kind in SETTINGS.iter().filter(|kind| kind.word != "transfer") {
            assert!(Dial::of(kind.word).is_some(), "{}", kind.word);
        }
    }
}
