//! What pictures are compared with.

use std::path::Path;

use super::dial::best_of;
use super::{Ladder, draw};
use crate::film::{Film, Transfer};
use crate::language::ValueError;
use crate::math::Rgb;
use crate::measure::deviation::rmse;
use crate::measure::{Appearance, Change, Deviation};
use crate::render;
use crate::scene::{RenderSettings, Scene};
use serde::Serialize;

/// The picture that all others are compared with.
#[derive(Debug, Clone, Serialize)]
pub struct Reference {
    /// The picture as it is shown.
    #[serde(skip)]
    pub film: Film,
    /// What an eye sees of it.
    #[serde(skip)]
    pub appearance: Appearance,
    /// How it was made.
    pub about: String,
    /// How far it may be off itself; `None` if nobody knows.
    pub doubt: Option<Doubt>,
}

/// How far a reference is off itself, to judge by how its two halves differ.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Doubt {
    /// The root mean square error; 1 is the largest code value.
    pub rmse: f64,
    /// The largest error in code values.
    pub largest: f64,
}

impl Reference {
    /// The best picture of a scene that there is, good enough for the rungs of a ladder.
    ///
    /// Every dial is at its best, and there are about as many samples as [`enough`] for each rung. They
    /// are two pictures of *k²* and of *(k + 1)²* stratified samples, whose cells and so whose places
    /// have nothing in common; half of what these differ by is how far their mean may be off.
    ///
    /// # Errors
    /// Refuses what cannot be rendered.
    pub(super) fn automatic(scene: &mut Scene, ladder: &Ladder) -> Result<Self, ValueError> {
        let most = ladder.0.iter().map(|rung| enough(rung.picture)).max();
        let half = f64::from(most.unwrap_or(FEWEST).max(FEWEST)) / 2.0;
        #[expect(clippy::cast_possible_truncation, reason = "at most 255")]
        #[expect(clippy::cast_sign_loss, reason = "positive")]
        let side = half.sqrt().min(255.0) as u32;
        let counts = [side * side, (side + 1) * (side + 1)];
        let best = best_of(scene.settings);
        let mut halves = Vec::new();
        for samples in counts {
            let picture = RenderSettings { samples, ..best };
            halves.push(draw(scene, picture)?.0);
        }
        let [weight, other_weight] = counts.map(f64::from);
        let film = mixed(&halves[0], &halves[1], weight / (weight + other_weight));
        let halves = halves.into_iter().map(|half| half.displayed(best.transfer));
        let halves: Vec<_> = halves.collect();
        let film = film.displayed(best.transfer);
        Ok(Self {
            appearance: Appearance::of(&film),
            film,
            about: format!(
                "{} samples in two halves, each dial at its best",
                counts[0] + counts[1]
            ),
            doubt: Some(Doubt {
                rmse: rmse(&halves[0], &halves[1]) / 2.0,
                largest: Change::between(&halves[0], &halves[1]).largest / 2.0,
            }),
        })
    }

    /// A picture in a file: PNG, PPM or PFM, of the size of the scene's, whose curve this is.
    ///
    /// # Errors
    /// Tells what is wrong with the file.
    pub fn from_file(
        path: &Path,
        [width, height]: [u32; 2],
        transfer: Transfer,
    ) -> Result<Self, String> {
        let film = Film::read(path, transfer).map_err(|error| error.to_string())?;
        if [film.width(), film.height()] != [width as usize, height as usize] {
            return Err(format!(
                "it has {}x{} pixels, and the scene's picture {width}x{height}",
                film.width(),
                film.height()
            ));
        }
        Ok(Self {
            appearance: Appearance::of(&film),
            film,
            about: path.display().to_string(),
            doubt: None,
        })
    }

    /// How far a picture is from it.
    #[must_use]
    pub fn deviation(&self, picture: &Film) -> Deviation {
        Deviation::of(picture, &self.film, &self.appearance)
    }
}

/// About the fewest samples of a reference.
const FEWEST: u32 = 200;

/// How many samples a reference has to have so that it is much better than a rung with these settings:
/// six times as many, which leaves a quarter of the error at borders.
///
/// Of the rays that `max-error` adds where black borders on white, twice as many are enough: where there
/// is less contrast, the rung has fewer rays, and the reference less error. There are no more for them
/// than `max-error` may add to any pixel.
fn enough(rung: RenderSettings) -> u32 {
    let adaptive = 2 * render::rays_at_a_border(&rung);
    (6 * rung.samples).max(adaptive.min(RenderSettings::MOST_ADAPTIVE))
}

/// The weighted mean of two pictures.
fn mixed(one: &Film, other: &Film, weight: f64) -> Film {
    let mut mixed = one.clone();
    for (pixel, other) in mixed.pixels_mut().iter_mut().zip(other.pixels()) {
        *pixel = (*pixel * weight + *other * (1.0 - weight)).saturated();
    }
    mixed
}

/// A picture as it is shown once it is written.
pub(super) fn written(film: &Film, picture: RenderSettings) -> Film {
    let mut written = film.clone();
    for pixel in written.pixels_mut() {
        let channels = pixel.channels();
        let [r, g, b] = channels.map(|it| picture.depth.displayed(it, picture.encoding()));
        *pixel = Rgb::new(r, g, b);
    }
    written
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
            let rung = settings.iter().fold(base, |rung, it| rung.with(it));
            assert_eq!(enough(rung), expected, "{samples} {max_error}");
        }
    }
}
