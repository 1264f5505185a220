//! Reference picture that all others are compared with.

use std::path::Path;

use serde::Serialize;

use super::draw::draw;
use super::sweep::Sweep;
use super::varied::best_of;
use crate::film::{Film, Transfer};
use crate::language::ValueError;
use crate::measure::deviation::rmse;
use crate::measure::{Appearance, Change, Deviation};
use crate::render;
use crate::scene::{RenderSettings, Scene};

/// Reference picture that all others are compared with.
#[derive(Debug, Clone, Serialize)]
pub struct Reference {
    /// Picture as it is shown.
    #[serde(skip)]
    pub film: Film,
    #[serde(skip)]
    appearance: Appearance,
    /// Its origin in words.
    pub about: String,
    /// Its own error; `None` if unknown.
    pub uncertainty: Option<Uncertainty>,
}

/// Own error of a reference, estimated as half the difference of its halves.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Uncertainty {
    /// Root mean square error; 1 is the largest code value.
    pub rmse: f64,
    /// Largest error in code values.
    pub largest: f64,
}

impl Reference {
    /// The most accurate picture of a scene, with about [`enough`] samples for each step.
    pub(super) fn automatic(scene: &mut Scene, sweep: &Sweep) -> Result<Self, ValueError> {
        // Two halves of k² and (k + 1)² stratified samples have no place in common, so half of
        // their difference estimates the error of their mean.
        let most = sweep.0.iter().map(|step| enough(step.settings)).max();
        let half = f64::from(most.unwrap_or(FEWEST).max(FEWEST)) / 2.0;
        #[expect(clippy::cast_possible_truncation, reason = "at most 255")]
        #[expect(clippy::cast_sign_loss, reason = "positive")]
        let side = half.sqrt().min(255.0) as u32;
        let counts = [side * side, (side + 1) * (side + 1)];
        let best = best_of(scene.settings);
        let mut half = |samples| {
            let drawn = draw(scene, RenderSettings { samples, ..best });
            drawn.map(|(film, _)| film)
        };
        let [one, other] = [half(counts[0])?, half(counts[1])?];
        let [weight, other_weight] = counts.map(f64::from);
        let film = mixed(&one, &other, weight / (weight + other_weight));
        let [one, other] = [one, other].map(|half| half.displayed(best.transfer));
        let uncertainty = Uncertainty {
            rmse: rmse(&one, &other) / 2.0,
            largest: Change::between(&one, &other).largest / 2.0,
        };
        let samples: u32 = counts.iter().sum();
        let about = format!("{samples} samples in two halves, every setting at its best");
        Ok(Self::new(
            film.displayed(best.transfer),
            about,
            Some(uncertainty),
        ))
    }

    /// Reads a PNG, PPM or PFM file with a picture of the scene's size and transfer curve.
    ///
    /// # Errors
    /// Describes what is wrong with the file.
    pub fn from_file(path: &Path, size: [u32; 2], transfer: Transfer) -> Result<Self, String> {
        let film = Film::read(path, transfer).map_err(|error| error.to_string())?;
        let [width, height] = size;
        let [own_width, own_height] = [film.width(), film.height()];
        if [own_width, own_height] != size.map(|side| side as usize) {
            return Err(format!(
                "it has {own_width}x{own_height} pixels, and the scene's picture {width}x{height}"
            ));
        }
        Ok(Self::new(film, path.display().to_string(), None))
    }

    fn new(film: Film, about: String, uncertainty: Option<Uncertainty>) -> Self {
        Self {
            appearance: Appearance::of(&film),
            film,
            about,
            uncertainty,
        }
    }

    /// Compares a picture with it.
    #[must_use]
    pub fn deviation(&self, picture: &Film) -> Deviation {
        Deviation::of(picture, &self.film, &self.appearance)
    }

    /// RMSE below which errors cannot be told apart; zero if unknown.
    pub(super) fn noise(&self) -> f64 {
        self.uncertainty.map_or(0.0, |it| it.rmse)
    }
}

/// Fewest samples of a reference, about.
const FEWEST: u32 = 200;

/// Samples with which a reference is much better than a picture with these settings.
fn enough(settings: RenderSettings) -> u32 {
    // Six times as many leave a quarter of the error at borders. Of the rays that `max-error` adds
    // where black borders on white, twice as many suffice: with less contrast the picture has fewer
    // rays, and the reference less error. There are no more than `max-error` may add to any pixel.
    let adaptive = 2 * render::rays_at_a_border(&settings);
    (6 * settings.samples).max(adaptive.min(RenderSettings::MOST_ADAPTIVE))
}

/// Weighted mean of two pictures.
fn mixed(one: &Film, other: &Film, weight: f64) -> Film {
    let mut mixed = one.clone();
    for (pixel, other) in mixed.pixels_mut().iter_mut().zip(other.pixels()) {
        *pixel = (*pixel * weight + *other * (1.0 - weight)).saturated();
    }
    mixed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::Node;
    use crate::scene::Setting;

    #[test]
    fn a_reference_is_better_than_what_samples_and_max_error_ask_for() {
        let node = Node::new(&RenderSettings::SCHEMA, None).value([4.0, 3.0]);
        let base = RenderSettings::from_node(&node).expect("a picture");
        for (samples, max_error, expected) in [
            ("1", "0", 6),
            ("25", "0", 150),
            ("65536", "0", 393_216),
            // (0.8 / E) to the power of 4/3 is 16, 81 and 477 there.
            ("1", "0.1", 32),
            ("9", "0.1", 54),
            ("1", "0.0296296296296296296", 162),
            ("1", "2/255", 954),
            ("1", "1/510", 4096),
            ("1024", "1/510", 6144),
        ] {
            let settings = [("samples", samples), ("max-error", max_error)];
            let settings = settings.map(|(word, text)| Setting::new(word, text).expect(text));
            let settings = settings.iter().fold(base, RenderSettings::with);
            assert_eq!(enough(settings), expected, "{samples} {max_error}");
        }
    }
}
