//! Settings that `cost` varies.

use crate::plan::Effect;
use crate::scene::{RenderSettings, SETTINGS, SettingKind};

/// The settings that have steps, in the order of their rank.
pub(crate) const VARIED: [&SettingKind; 8] = {
    let mut varied = [&SETTINGS[0]; 8];
    let mut next = 0;
    while next < SETTINGS.len() {
        if SETTINGS[next].rank > 0 {
            varied[SETTINGS[next].rank - 1] = &SETTINGS[next];
        }
        next += 1;
    }
    varied
};

impl SettingKind {
    /// True if it can change a picture in which these effects are simulated.
    pub(super) fn matters(&self, on: &[Effect]) -> bool {
        let effects: &[Effect] = match self.word {
            "texture-filter" => &[Effect::Textures],
            "cut-off" => &[Effect::Mirrors, Effect::Transparency, Effect::Refraction],
            _ => return true,
        };
        effects.iter().any(|effect| on.contains(effect))
    }
}

/// A picture's settings with the most accurate value of each.
pub(super) fn best_of(picture: RenderSettings) -> RenderSettings {
    let best = VARIED.into_iter().filter_map(SettingKind::best);
    best.fold(picture, |picture, setting| picture.with(&setting))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Setting;

    #[test]
    fn every_step_of_every_setting_can_be_set() {
        for kind in VARIED {
            let together = kind.together_with.iter().copied();
            let steps = kind.steps.iter().chain(&kind.best);
            for (word, text) in steps.map(|step| (kind.word, *step)).chain(together) {
                assert!(Setting::new(word, text).is_ok(), "{word}={text}");
            }
        }
    }

    #[test]
    fn every_setting_with_steps_has_a_rank_of_its_own() {
        // The curve is a matter of taste: no other picture is more accurate.
        for kind in SETTINGS.iter().filter(|kind| kind.word != "transfer") {
            assert!(SettingKind::varied(kind.word).is_some(), "{}", kind.word);
        }
    }
}
