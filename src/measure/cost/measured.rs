//! What one rung takes and how far off it is.

use serde::Serialize;

use super::reference::written;
use super::{Blame, Dial, Rung, Truth, draw, pictures};
use crate::film::Film;
use crate::language::ValueError;
use crate::measure::change::share_within;
use crate::measure::clock::timed_in_all_threads;
use crate::measure::deviation::rmse;
use crate::measure::{Deviation, Timing};
use crate::render::Counts;
use crate::scene::Scene;

/// What one rung takes and how far off it is.
#[derive(Debug, Clone, Serialize)]
pub struct Measured {
    /// What it is called.
    pub label: String,
    /// The dial that alone is turned, if one is.
    pub dial: Option<&'static str>,
    /// The number that it is turned to, if it takes one.
    pub value: Option<f64>,
    /// How often it was drawn.
    pub runs: usize,
    /// Processor time of all threads, in seconds.
    pub cpu: Timing,
    /// The time that goes by, in seconds.
    pub wall: Timing,
    /// All rays.
    pub rays: u64,
    /// The work in numbers, which are the same in every run and on any number of threads.
    pub counts: Counts,
    /// How far the picture is from the reference.
    #[serde(flatten)]
    pub deviation: Deviation,
    /// The share of the pixels that are within the picture's `max-error` of the reference; `None` if it has
    /// none.
    pub met: Option<f64>,
    /// The root mean square error that is each dial's own: how far the picture is from the same one
    /// with that dial at its best; for the scene as it is, that of every dial.
    pub own: Vec<Own>,
    /// The inverse of the mean square error times the processor time; `None` if there is no error.
    pub efficiency: Option<f64>,
    /// A rung that is at least as accurate and as fast, as far as anybody can tell, and better in one of
    /// that; none if this one is on the Pareto front.
    pub dominated_by: Option<String>,
    /// Where each dial errs that it turns.
    #[serde(skip)]
    pub blames: Vec<Blame>,
    /// The picture, if that was asked for.
    #[serde(skip)]
    pub pictures: Option<Pictures>,
}

/// The error that is a dial's own.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Own {
    /// The dial.
    pub dial: &'static str,
    /// What it is turned to, in its own word.
    pub step: String,
    /// The number that it is turned to, if it takes one.
    pub value: Option<f64>,
    /// The root mean square error; 1 is the largest code value.
    pub rmse: f64,
}

/// A rung's picture and its errors as PNG files.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pictures {
    /// The picture.
    pub picture: Vec<u8>,
    /// How far each pixel is off.
    pub errors: Vec<u8>,
    /// The pixels that are most off, no two of them close to each other.
    pub worst: Vec<[usize; 2]>,
}

impl Measured {
    /// The error that is this dial's own, if it was measured.
    #[must_use]
    pub fn own(&self, dial: &str) -> Option<&Own> {
        self.own.iter().find(|own| own.dial == dial)
    }

    /// Whether no rung is better in accuracy or time without being worse in the other.
    #[must_use]
    pub fn is_on_front(&self) -> bool {
        self.dominated_by.is_none()
    }
}

#[cfg(test)]
impl Measured {
    /// A rung that takes so many seconds of processor time and half as many on the clock, and is so far
    /// off.
    pub(super) fn example(label: &str, seconds: f64, rmse: f64) -> Self {
        Self {
            label: label.to_owned(),
            dial: None,
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
            met: None,
            own: Vec::new(),
            efficiency: None,
            dominated_by: None,
            blames: Vec::new(),
            pictures: None,
        }
    }
}

/// A rung that is drawn again and again.
pub(super) struct Subject {
    rung: Rung,
    cpu: Vec<f64>,
    wall: Vec<f64>,
    counts: Counts,
    deviation: Option<Deviation>,
    met: Option<f64>,
    own: Vec<Own>,
    blames: Vec<Blame>,
    pictures: Option<Pictures>,
}

impl Subject {
    pub(super) fn new(rung: Rung) -> Self {
        Self {
            rung,
            cpu: Vec::new(),
            wall: Vec::new(),
            counts: Counts::default(),
            deviation: None,
            met: None,
            own: Vec::new(),
            blames: Vec::new(),
            pictures: None,
        }
    }

    /// Draws it once more.
    pub(super) fn draw(&mut self, scene: &mut Scene) -> Result<Film, ValueError> {
        let ([cpu, wall], drawn) = timed_in_all_threads(|| draw(scene, self.rung.picture));
        let (film, counts) = drawn?;
        self.cpu.push(cpu);
        self.wall.push(wall);
        self.counts = counts;
        Ok(film)
    }

    /// The picture as it is compared: as it is shown, or as it is written if the rung is about that.
    fn as_compared(&self, film: Film) -> Film {
        if self.rung.is_as_written() {
            written(&film, self.rung.picture)
        } else {
            film.displayed(self.rung.picture.transfer)
        }
    }

    /// Whether more runs would tell little about its time.
    pub(super) fn has_settled(&self) -> bool {
        Timing::of(&self.cpu).has_settled()
    }

    /// Finds out how far off its picture is, and keeps that if it is asked for.
    pub(super) fn compare(
        &mut self,
        film: Film,
        truth: &Truth,
        pictures: bool,
    ) -> Result<(), ValueError> {
        let film = self.as_compared(film);
        let reference = &truth.reference;
        let (deviation, kept) = rayon::join(
            || reference.deviation(&film),
            || pictures.then(|| pictures::of(&film, &reference.film)),
        );
        self.deviation = Some(deviation);
        let limit = self.rung.picture.max_error;
        self.met = (limit > 0.0).then(|| share_within(&reference.film, &film, limit));
        self.pictures = kept.transpose()?;
        self.attribute(&film, deviation, truth);
        Ok(())
    }

    /// Finds out what of the error is each dial's own, and where it errs.
    fn attribute(&mut self, film: &Film, deviation: Deviation, truth: &Truth) {
        let as_it_is = self.rung.settings.is_empty();
        let all = self.rung.picture.describe();
        for dial in Dial::all() {
            let is_turned = self.rung.turns(dial);
            // The scene as it is, is a step of each dial that is turned alone.
            let is_step = as_it_is && dial.beside.is_empty() && !dial.in_writing;
            let (true, Some(value)) = (is_turned || is_step, all.property(dial.word)) else {
                continue;
            };
            let twin = truth.twins.iter().find(|twin| twin.dial == dial.word);
            let own = match twin {
                Some(twin) => rmse(film, &twin.film),
                None if dial.by_reference => deviation.rmse,
                None => continue,
            };
            let step = self.rung.step(dial, &value);
            if is_turned {
                let best = twin.map_or(&truth.reference.film, |twin| &twin.film);
                let rung = &self.rung.label;
                let blame = Blame::of(dial.word, &step, rung, film, best, &truth.spots);
                self.blames.extend(blame);
            }
            self.own.push(Own {
                dial: dial.word,
                value: value.text().is_empty().then(|| value.number()),
                step,
                rmse: own,
            });
        }
    }

    pub(super) fn measured(self) -> Measured {
        let cpu = Timing::of(&self.cpu);
        let deviation = self.deviation.unwrap_or(Deviation {
            change: crate::measure::Change::default(),
            rmse: 0.0,
            psnr: None,
            ssim: 1.0,
            flip: 0.0,
        });
        let square = deviation.rmse * deviation.rmse;
        let mut turned = self.own.iter();
        let own = turned.find(|own| Some(own.dial) == self.rung.dial);
        Measured {
            label: self.rung.label,
            dial: self.rung.dial,
            value: own.and_then(|own| own.value),
            runs: self.cpu.len(),
            cpu,
            wall: Timing::of(&self.wall),
            rays: self.counts.rays(),
            counts: self.counts,
            deviation,
            efficiency: (square > 0.0 && cpu.median > 0.0).then(|| 1.0 / (square * cpu.median)),
            met: self.met,
            own: self.own,
            dominated_by: None,
            blames: self.blames,
            pictures: self.pictures,
        }
    }
}
