//! Measurement of a sweep.

use serde::Serialize;
use serde_json::Value;

use super::attribution::Breakdown;
use super::choice::{self, Best, Limit};
use super::draw::draw;
use super::front;
use super::law::{self, Law};
use super::measurement::{Measurement, Times, Truth, compared};
use super::reference::Reference;
use super::sweep::Sweep;
use super::varied::VARIED;
use crate::language::ValueError;
use crate::measure::clock::timed_in_all_threads;
use crate::measure::{Timing, aliases};
use crate::scene::{RenderSettings, Scene};

/// Error and time of settings of one scene.
#[derive(Debug, Clone, Serialize)]
pub struct Cost {
    /// Width and height of the picture in pixels.
    pub size: [u32; 2],
    /// Most runs of a step; times are medians of its runs.
    pub runs: u32,
    /// Number of threads.
    pub threads: usize,
    /// Picture that all others are compared with.
    pub reference: Reference,
    /// Steps in the order of the sweep.
    pub steps: Vec<Measurement>,
    /// Relation of error and time, for each setting.
    pub laws: Vec<Law>,
    /// `Places` of errors in the picture, for each setting at its worst.
    pub breakdowns: Vec<Breakdown>,
    /// The recommended step.
    pub recommended: Best,
}

/// Options of a measurement.
#[derive(Debug, Default)]
pub struct CostOptions {
    /// Reference; `None` renders the most accurate picture.
    pub reference: Option<Reference>,
    /// Most runs of a step, at least one; fewer if its times agree within 2 %.
    pub runs: u32,
    /// True to keep the pictures of all steps for [`Cost::page`].
    pub with_pictures: bool,
}

/// Measures error and time of each step of a sweep, in turn and on all threads of the current pool.
///
/// `progress` gets the number of pictures rendered, and of all. The scene keeps its settings.
///
/// # Errors
/// Refuses a scene that cannot be rendered.
pub fn cost(
    scene: &mut Scene,
    sweep: &Sweep,
    options: CostOptions,
    progress: &dyn Fn(usize, usize),
) -> Result<Cost, ValueError> {
    let runs = options.runs.max(1);
    // What precedes the runs is about as much work as one run.
    let all = (runs as usize + 1) * sweep.0.len();
    progress(0, all);
    let truth = Truth::new(scene, sweep, options.reference)?;
    warm_up(scene, sweep)?;
    let mut done = sweep.0.len();
    progress(done, all);
    let mut steps: Vec<Measurement> = Vec::new();
    let mut times = vec![Times::default(); sweep.0.len()];
    for _ in 0..runs {
        for (step, times) in sweep.0.iter().zip(&mut times) {
            if !Timing::of(&times.cpu).has_settled() {
                let ([cpu, wall], drawn) = timed_in_all_threads(|| draw(scene, step.settings));
                times.cpu.push(cpu);
                times.wall.push(wall);
                let drawn = drawn?;
                if steps.len() < sweep.0.len() {
                    steps.push(compared(step, drawn, &truth, options.with_pictures)?);
                }
            }
            done += 1;
            progress(done, all);
        }
    }
    for (step, times) in steps.iter_mut().zip(&times) {
        step.timed(times);
    }
    let noise = truth.reference.noise();
    front::mark(&mut steps, noise);
    Ok(Cost {
        size: [scene.settings.width, scene.settings.height],
        runs,
        threads: rayon::current_num_threads(),
        laws: law::all(&steps, noise),
        breakdowns: worst_of_each(&steps),
        recommended: choice::recommended(&steps, noise),
        reference: truth.reference,
        steps,
    })
}

impl Cost {
    /// The result as JSON, with former names of keys beside the current ones.
    #[must_use]
    pub fn json(&self) -> Value {
        aliases::json(self)
    }

    /// The step with the least processor time of those that are accurate enough.
    #[must_use]
    pub fn cheapest(&self, limit: Limit) -> Best {
        choice::cheapest(&self.steps, limit)
    }

    /// The most accurate step of those that take at most `budget` seconds.
    #[must_use]
    pub fn within(&self, budget: f64) -> Best {
        choice::within(&self.steps, budget, self.reference.noise())
    }
}

/// Renders pictures that are not measured: the first one fetches program and textures into the
/// caches, and the first one with a texture filter prepares the textures for it.
fn warm_up(scene: &mut Scene, sweep: &Sweep) -> Result<(), ValueError> {
    let base = scene.settings;
    draw(scene, base)?;
    let mut filters = vec![base.texture_filter];
    for step in &sweep.0 {
        let texture_filter = step.settings.texture_filter;
        if !filters.contains(&texture_filter) {
            filters.push(texture_filter);
            let quick = RenderSettings {
                samples: 1,
                max_error: 0.0,
                texture_filter,
                ..base
            };
            draw(scene, quick)?;
        }
    }
    Ok(())
}

/// For each setting, the breakdown with the largest error.
fn worst_of_each(steps: &[Measurement]) -> Vec<Breakdown> {
    let of_setting = |word: &'static str| {
        let all = steps.iter().flat_map(|step| &step.breakdowns);
        let all = all.filter(|breakdown| breakdown.setting == word);
        all.max_by(|one, other| one.error.total_cmp(&other.error))
            .cloned()
    };
    VARIED
        .iter()
        .filter_map(|kind| of_setting(kind.word))
        .collect()
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;
    use std::sync::Mutex;

    use super::super::sweep::Variation;
    use super::*;
    use crate::read::{Options, read_bytes};

    #[test]
    fn progress_begins_with_nothing_done_and_ends_with_all() {
        let text = "image 4 3\ncamera { viewpoint 0 0 4; look-at 0 0 0 }";
        let reading = read_bytes("scene", text.into(), PathBuf::new(), &Options::default());
        let mut scene = reading.expect("a scene").scene;
        let variation = Variation::new("samples=4").expect("a variation");
        let sweep = Sweep::each(scene.settings, &[variation]).expect("a sweep");
        let options = CostOptions {
            runs: 2,
            ..CostOptions::default()
        };
        let reports = Mutex::new(Vec::new());
        let note = |done, of| reports.lock().expect("a list").push((done, of));
        cost(&mut scene, &sweep, options, &note).expect("a cost");
        let reports = reports.into_inner().expect("a list");
        assert_eq!(reports, [(0, 6), (2, 6), (3, 6), (4, 6), (5, 6), (6, 6)]);
    }
}
