//! Cost of each effect of a scene, and its influence on the picture.

use rayon::{ThreadPool, ThreadPoolBuilder};
use serde::Serialize;

use super::clock::timed;
use super::{Change, Timing, effects_of, without};
use crate::film::Film;
use crate::language::ValueError;
use crate::plan::{Effect, Scope};
use crate::render::{Counts, Render, STACK};
use crate::scene::Scene;

/// Costs of the effects of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Prices {
    /// Number of runs, of which times are medians.
    pub runs: u32,
    /// The scene as it is.
    pub whole: Effort,
    /// The scene without lossless shortcuts; its picture is the same.
    pub everything: Effort,
    /// The scene without each effect that it calls for.
    pub without: Vec<Price>,
}

/// Time and work of a picture.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Effort {
    /// Processor time of one thread, in seconds, planning included.
    pub time: Timing,
    /// Work in numbers, equal in every run.
    pub counts: Counts,
}

/// Cost of an effect.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Price {
    /// The effect that is switched off.
    pub effect: Effect,
    /// Other effects that are no longer called for without it.
    pub also_off: Vec<Effect>,
    /// Time and work without it.
    pub effort: Effort,
    /// Ratio of that time to the time of the whole scene.
    pub takes: f64,
    /// Change of the picture without it.
    pub change: Change,
}

impl Effort {
    /// Rays to lights and to points of lamps.
    #[must_use]
    pub fn shadow_rays(&self) -> u64 {
        self.counts.shadow_rays + self.counts.lamp_rays
    }

    /// Mean number of surfaces tested for each of them; `None` without any.
    #[must_use]
    pub fn tests_per_shadow_ray(&self) -> Option<f64> {
        #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
        let [rays, tests] =
            [self.shadow_rays(), self.counts.occlusion_tests].map(|count| count as f64);
        (rays > 0.0).then(|| tests / rays)
    }
}

/// Measures the cost of each effect: renders the scene as it is, with everything simulated, and
/// without each effect that is on, in turn, at least once.
///
/// `progress` gets the number of pictures rendered, and of all.
///
/// # Errors
/// If a film cannot have the scene's size, or the threads cannot start.
///
/// # Panics
/// If simulating everything changes the picture, which is a bug.
pub fn prices(
    scene: &Scene,
    runs: u32,
    progress: &dyn Fn(usize, usize),
) -> Result<Prices, ValueError> {
    let on = effects_of(scene)?;
    let lesser = on.iter().map(|effect| without(scene, *effect));
    let lesser = lesser.collect::<Result<Vec<_>, _>>()?;
    let subject = |scene| Subject {
        scene,
        scope: Scope::CalledFor,
        seconds: Vec::new(),
        counts: Counts::default(),
        change: Change::default(),
    };
    let mut subjects = vec![subject(scene), subject(scene)];
    subjects[1].scope = Scope::Everything;
    subjects.extend(lesser.iter().map(subject));
    let runs = runs.max(1);
    let all = runs as usize * subjects.len();
    let pool = one_thread()?;
    // Not measured: the first picture also fetches program and textures into the caches.
    let (picture, _) = pool.install(|| Render::new(scene).film::<Counts>())?;
    let hash = picture.hash();
    let picture = picture.displayed(scene.settings.transfer);
    let mut drawn = 0;
    for _ in 0..runs {
        for subject in &mut subjects {
            pool.install(|| subject.draw(&picture, &hash))?;
            drawn += 1;
            progress(drawn, all);
        }
    }
    let [whole, everything] = [&subjects[0], &subjects[1]].map(Subject::effort);
    let without = on.iter().zip(&subjects[2..]).map(|(effect, subject)| {
        let still = effects_of(subject.scene)?;
        let gone = |other: &Effect| other != effect && !still.contains(other);
        let effort = subject.effort();
        Ok(Price {
            effect: *effect,
            also_off: on.iter().copied().filter(gone).collect(),
            takes: effort.time.over(whole.time),
            effort,
            change: subject.change,
        })
    });
    let without = without.collect::<Result<_, ValueError>>()?;
    Ok(Prices {
        runs,
        whole,
        everything,
        without,
    })
}

/// A pool of one thread, whose processor time is that of the work.
fn one_thread() -> Result<ThreadPool, ValueError> {
    let builder = ThreadPoolBuilder::new().num_threads(1).stack_size(STACK);
    builder.build().map_err(|error| {
        let reason = format!("cannot start a thread: {error}");
        ValueError::new("threads", reason, "try again")
    })
}

/// A scene that is rendered again and again.
struct Subject<'a> {
    scene: &'a Scene,
    scope: Scope,
    seconds: Vec<f64>,
    counts: Counts,
    change: Change,
}

impl Subject<'_> {
    /// Renders it once more and compares it with the shown picture of the whole scene, whose hash
    /// before that is `hash`.
    fn draw(&mut self, picture: &Film, hash: &str) -> Result<(), ValueError> {
        let (seconds, drawn) = timed(|| Render::new(self.scene).scope(self.scope).film());
        let (film, counts) = drawn?;
        assert!(
            self.scope == Scope::CalledFor || film.hash() == hash,
            "simulating everything changes the picture"
        );
        self.seconds.push(seconds);
        self.counts = counts;
        let transfer = self.scene.settings.transfer;
        self.change = Change::between(picture, &film.displayed(transfer));
        Ok(())
    }

    fn effort(&self) -> Effort {
        Effort {
            time: Timing::of(&self.seconds),
            counts: self.counts.clone(),
        }
    }
}
