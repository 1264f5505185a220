//! Errors attributed to single settings, and to places in the picture.

use serde::Serialize;

use super::features::{Feature, FeatureMap};
use crate::film::Film;
use crate::measure::deviation::squared_errors;

/// Error of a picture against the same one with a setting at its best.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OwnError {
    /// The setting.
    pub setting: &'static str,
    /// Its value as text.
    pub text: String,
    /// Its value if it is a number.
    pub value: Option<f64>,
    /// Root mean square error; 1 is the largest code value.
    pub rmse: f64,
}

/// `Places` where a setting causes errors, at the value whose error is largest.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Breakdown {
    /// The setting.
    pub setting: &'static str,
    /// Its value as text.
    pub text: String,
    /// Label of the step with that value.
    pub label: String,
    /// Share of each kind of place with errors, the largest first.
    pub features: Vec<FeatureShare>,
    /// Surface with the largest share.
    pub surface: Option<SurfaceShare>,
    /// Column and row of the pixel with the largest error, counted from the top left, from 0.
    pub worst: [usize; 2],
    /// Sum of all squared errors.
    #[serde(skip)]
    pub(super) error: f64,
}

/// Share of the error in a kind of place.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FeatureShare {
    /// The kind of place.
    pub feature: Feature,
    /// Share of all squared errors.
    pub error: f64,
    /// Share of all pixels.
    pub pixels: f64,
}

/// Share of the error on a surface.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SurfaceShare {
    /// Kind and name of the surface.
    pub title: String,
    /// Share of all squared errors.
    pub error: f64,
}

impl Breakdown {
    /// Attributes the errors of a picture to places; `None` without errors.
    ///
    /// `best` is the same picture with `own.setting` at its best.
    pub(super) fn of(
        own: &OwnError,
        label: &str,
        [film, best]: [&Film; 2],
        map: &FeatureMap,
    ) -> Option<Self> {
        let errors: Vec<_> = squared_errors(film, best).collect();
        let all: f64 = errors.iter().sum();
        if all == 0.0 {
            return None;
        }
        #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
        let pixels = errors.len() as f64;
        let mut features = Feature::ALL.map(|feature| {
            let here = map.features.iter().zip(&errors);
            let here = here.filter(|(other, _)| **other == feature);
            let (error, count) = here.fold((0.0, 0.0), |(sum, count), (_, error)| {
                (sum + error, count + 1.0)
            });
            FeatureShare {
                feature,
                error: error / all,
                pixels: count / pixels,
            }
        });
        features.sort_by(|one, other| other.error.total_cmp(&one.error));
        let mut by_surface = vec![0.0; map.titles.len()];
        for (surface, error) in map.surfaces.iter().zip(&errors) {
            if let Some(surface) = surface {
                by_surface[*surface] += error;
            }
        }
        let surface = largest(&by_surface).filter(|surface| by_surface[*surface] > 0.0);
        let worst = largest(&errors)?;
        Some(Self {
            setting: own.setting,
            text: own.text.clone(),
            label: label.to_owned(),
            features: features.into_iter().filter(|it| it.error > 0.0).collect(),
            surface: surface.map(|surface| SurfaceShare {
                title: map.titles[surface].clone(),
                error: by_surface[surface] / all,
            }),
            worst: [worst % map.width, worst / map.width],
            error: all,
        })
    }
}

/// Place of the largest of some numbers.
fn largest(numbers: &[f64]) -> Option<usize> {
    let numbered = numbers.iter().enumerate();
    let largest = numbered.max_by(|(_, one), (_, other)| one.total_cmp(other));
    largest.map(|(place, _)| place)
}
