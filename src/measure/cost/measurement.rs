//! Time and error of one step.

use serde::Serialize;

use super::attribution::{Breakdown, OwnError};
use super::draw::{draw, written};
use super::features::FeatureMap;
use super::pictures::Pictures;
use super::reference::Reference;
use super::sweep::{Step, Sweep};
use super::varied::VARIED;
use crate::film::Film;
use crate::language::ValueError;
use crate::measure::deviation::{rmse, share_within};
use crate::measure::{Deviation, Timing};
use crate::render::Counts;
use crate::scene::{Scene, SettingKind};

/// Time and error of one step.
#[derive(Debug, Clone, Serialize)]
pub struct Measurement {
    /// Changes of the step such as `samples=4`, or "as it is".
    pub label: String,
    /// The setting that alone is varied, if one is.
    pub setting: Option<&'static str>,
    /// Its value if it is a number.
    pub value: Option<f64>,
    /// Number of runs.
    pub runs: usize,
    /// Processor time of all threads, in seconds.
    pub cpu: Timing,
    /// Elapsed time, in seconds.
    pub wall: Timing,
    /// All rays.
    pub rays: u64,
    /// Work in numbers, equal in every run and on any number of threads.
    pub counts: Counts,
    /// Difference from the reference.
    #[serde(flatten)]
    pub deviation: Deviation,
    /// Share of the pixels within `max-error` of the reference; `None` if it is zero.
    pub within_max_error: Option<f64>,
    /// Own error of each setting of which it is a step.
    pub own: Vec<OwnError>,
    /// 1 / (mean square error × processor time); `None` without error.
    pub efficiency: Option<f64>,
    /// Label of a step at least as accurate and as fast, and better in one of them; `None` on the
    /// Pareto front.
    pub dominated_by: Option<String>,
    /// `Places` of the errors of each setting that is varied.
    #[serde(skip)]
    pub(super) breakdowns: Vec<Breakdown>,
    /// Picture and errors, if they were asked for.
    #[serde(skip)]
    pub(super) pictures: Option<Pictures>,
}

impl Measurement {
    /// Own error of a setting, if it was measured.
    #[must_use]
    pub fn own(&self, setting: &str) -> Option<&OwnError> {
        self.own.iter().find(|own| own.setting == setting)
    }

    /// Own error of the setting that alone is varied.
    pub(super) fn own_of_varied(&self) -> Option<&OwnError> {
        self.own(self.setting?)
    }

    /// Adds the own error of each setting of which this is a step, and its places.
    fn attribute(&mut self, step: &Step, film: &Film, truth: &Truth) {
        let properties = step.settings.describe();
        for kind in VARIED {
            let is_varied = step.varies(kind.word);
            // The scene as it is counts as a step of each setting that is varied alone.
            let is_base =
                step.changes.is_empty() && kind.together_with.is_empty() && !kind.in_writing;
            let value = properties
                .property(kind.word)
                .filter(|_| is_varied || is_base);
            let (Some(value), Some(best)) = (value, truth.best_for(kind)) else {
                continue;
            };
            let own = OwnError {
                setting: kind.word,
                text: step.text_of(kind.word, &value),
                value: value.text().is_empty().then(|| value.number()),
                rmse: rmse(film, best),
            };
            if is_varied {
                let places = Breakdown::of(&own, &step.label, [film, best], &truth.features);
                self.breakdowns.extend(places);
            }
            self.own.push(own);
        }
    }

    /// Adds the times of its runs.
    pub(super) fn timed(&mut self, times: &Times) {
        self.runs = times.cpu.len();
        [self.cpu, self.wall] = [&times.cpu, &times.wall].map(|times| Timing::of(times));
        let product = self.deviation.rmse * self.deviation.rmse * self.cpu.median;
        self.efficiency = (product > 0.0).then(|| 1.0 / product);
    }
}

/// Times of the runs of a step, in seconds.
#[derive(Debug, Clone, Default)]
pub(super) struct Times {
    pub(super) cpu: Vec<f64>,
    pub(super) wall: Vec<f64>,
}

/// Pictures that others are compared with, and the features in them.
#[derive(Debug)]
pub(super) struct Truth {
    pub(super) reference: Reference,
    /// For settings not compared with the reference: the picture with that setting at its best and
    /// all others as in the scene.
    best: Vec<(&'static str, Film)>,
    features: FeatureMap,
}

impl Truth {
    /// Renders what the steps of a sweep are compared with.
    pub(super) fn new(
        scene: &mut Scene,
        sweep: &Sweep,
        reference: Option<Reference>,
    ) -> Result<Self, ValueError> {
        let features = FeatureMap::of(scene)?;
        let reference = match reference {
            Some(reference) => reference,
            None => Reference::automatic(scene, sweep)?,
        };
        let mut best = Vec::new();
        for kind in VARIED.iter().filter(|kind| !kind.by_reference) {
            let varied = sweep.0.iter().find(|step| step.varied == Some(kind.word));
            let Some(step) = varied else { continue };
            // Before it is written, a picture is at its best for settings of the writing.
            let settings = match kind.best() {
                _ if kind.in_writing => scene.settings,
                Some(best) => step.settings.with(&best),
                None => step.settings,
            };
            let (film, _) = draw(scene, settings)?;
            best.push((kind.word, film.displayed(settings.transfer)));
        }
        Ok(Self {
            reference,
            best,
            features,
        })
    }

    /// The picture that tells the own error of a setting.
    fn best_for(&self, kind: &SettingKind) -> Option<&Film> {
        let best = self.best.iter().find(|(word, _)| *word == kind.word);
        let reference = kind.by_reference.then_some(&self.reference.film);
        best.map(|(_, film)| film).or(reference)
    }
}

/// Compares the picture of a step with the truth; times are left out.
pub(super) fn compared(
    step: &Step,
    (film, counts): (Film, Counts),
    truth: &Truth,
    with_pictures: bool,
) -> Result<Measurement, ValueError> {
    let film = if step.is_as_written() {
        written(&film, step.settings)
    } else {
        film.displayed(step.settings.transfer)
    };
    let reference = &truth.reference;
    let (deviation, pictures) = rayon::join(
        || reference.deviation(&film),
        || with_pictures.then(|| Pictures::of(&film, &reference.film)),
    );
    let limit = step.settings.max_error;
    let mut measurement = Measurement {
        label: step.label.clone(),
        setting: step.varied,
        value: None,
        runs: 0,
        cpu: Timing::of(&[]),
        wall: Timing::of(&[]),
        rays: counts.rays(),
        counts,
        deviation,
        within_max_error: (limit > 0.0).then(|| share_within(&reference.film, &film, limit)),
        own: Vec::new(),
        efficiency: None,
        dominated_by: None,
        breakdowns: Vec::new(),
        pictures: pictures.transpose()?,
    };
    measurement.attribute(step, &film, truth);
    measurement.value = measurement.own_of_varied().and_then(|own| own.value);
    Ok(measurement)
}

#[cfg(test)]
impl Measurement {
    /// A step with so many seconds of processor time, half as many elapsed, and this error.
    pub(super) fn example(label: &str, seconds: f64, rmse: f64) -> Self {
        Self {
            label: label.to_owned(),
            setting: None,
            value: None,
            runs: 1,
            cpu: Timing::of(&[seconds]),
            wall: Timing::of(&[seconds / 2.0]),
            rays: 1,
            counts: Counts::default(),
            deviation: Deviation {
                change: crate::measure::Change {
                    largest: 1000.0 * rmse,
                    pixels: 10.0 * rmse,
                },
                rmse,
                psnr: (rmse > 0.0).then(|| -20.0 * libm::log10(rmse)),
                ssim: 1.0 - rmse,
                flip: rmse,
            },
            within_max_error: None,
            own: Vec::new(),
            efficiency: None,
            dominated_by: None,
            breakdowns: Vec::new(),
            pictures: None,
        }
    }
}
