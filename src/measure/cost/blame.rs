//! Where in the picture a dial errs.

use serde::Serialize;

use super::spots::Spots;
use super::{DIALS, Measured, Spot};
use crate::film::Film;
use crate::measure::change::shown;
use crate::plan::Cause;
use crate::scene::Scene;

/// Where in the picture a dial errs, at the step that errs most by itself.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Blame {
    /// The dial.
    pub dial: &'static str,
    /// What it is turned to there, in its own word.
    pub step: String,
    /// The rung that was looked at.
    pub rung: String,
    /// How much of it is in each kind of place; the most first, and none without error.
    pub spots: Vec<SpotShare>,
    /// The surface on which most of it is.
    pub surface: Option<SurfaceShare>,
    /// Column and row of the pixel that is most off, counted from the top left, from 0.
    pub worst: [usize; 2],
    #[serde(skip)]
    index: Option<usize>,
    #[serde(skip)]
    error: f64,
}

/// How much of the error is in a kind of place.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SpotShare {
    /// What is there.
    pub spot: Spot,
    /// The share of all squared error.
    pub error: f64,
    /// The share of all pixels.
    pub pixels: f64,
}

/// How much of the error is on a surface.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SurfaceShare {
    /// The surface's kind and name.
    pub title: String,
    /// The share of all squared error.
    pub error: f64,
}

impl Blame {
    /// Where a picture errs; `None` if nowhere.
    pub(super) fn of(
        dial: &'static str,
        step: &str,
        rung: &str,
        film: &Film,
        truth: &Film,
        spots: &Spots,
    ) -> Option<Self> {
        let pairs = film.pixels().iter().zip(truth.pixels());
        let errors = pairs.map(|(pixel, truth)| {
            let [pixel, truth] = [pixel, truth].map(|pixel| pixel.channels().map(shown));
            let channels = pixel.iter().zip(&truth);
            channels.map(|(a, b)| (a - b) * (a - b)).sum::<f64>()
        });
        let errors: Vec<_> = errors.collect();
        let all: f64 = errors.iter().sum();
        let share = |belongs: &dyn Fn(usize) -> bool| {
            let errors = errors.iter().enumerate().filter(|(at, _)| belongs(*at));
            errors.map(|(_, error)| error).sum::<f64>() / all
        };
        if all == 0.0 {
            return None;
        }
        #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
        let pixels = |spot| {
            let count = spots.spots.iter().filter(|other| **other == spot).count();
            count as f64 / errors.len() as f64
        };
        let error_in = |spot| share(&|at| spots.spots[at] == spot);
        let mut kinds = Spot::ALL
            .map(|spot| SpotShare {
                spot,
                error: error_in(spot),
                pixels: pixels(spot),
            })
            .to_vec();
        kinds.retain(|share| share.error > 0.0);
        kinds.sort_by(|one, other| other.error.total_cmp(&one.error));
        let seen = spots.surfaces.iter().flatten().max();
        let mut by_surface = vec![0.0; seen.map_or(0, |most| most + 1)];
        for (surface, error) in spots.surfaces.iter().zip(&errors) {
            if let Some(surface) = surface {
                by_surface[*surface] += error;
            }
        }
        let most = by_surface.iter().enumerate();
        let most = most.max_by(|(_, one), (_, other)| one.total_cmp(other));
        let worst = errors.iter().enumerate();
        let (worst, _) = worst.max_by(|(_, one), (_, other)| one.total_cmp(other))?;
        Some(Self {
            dial,
            step: step.to_owned(),
            rung: rung.to_owned(),
            spots: kinds,
            surface: most.map(|(_, share)| SurfaceShare {
                title: String::new(),
                error: *share / all,
            }),
            worst: [worst % spots.width, worst / spots.width],
            index: most.map(|(surface, _)| surface),
            error: all,
        })
    }
}

/// For each dial, where the step of it errs that errs most.
pub(super) fn all(rungs: &[Measured], scene: &Scene) -> Vec<Blame> {
    let of_dial = |dial: &'static str| {
        let blames = rungs.iter().flat_map(|rung| &rung.blames);
        let blames = blames.filter(|blame| blame.dial == dial);
        blames.max_by(|one, other| one.error.total_cmp(&other.error))
    };
    let blames = DIALS.iter().filter_map(|dial| of_dial(dial.word)).cloned();
    blames
        .map(|mut blame| {
            if let (Some(share), Some(index)) = (&mut blame.surface, blame.index) {
                share.title = Cause::of_surface(&*scene.surfaces[index]).title;
            }
            blame
        })
        .collect()
}
