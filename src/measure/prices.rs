//! What each effect of a scene costs, and what it does to the picture.

use rayon::{ThreadPool, ThreadPoolBuilder};
use serde::Serialize;

use super::clock::timed;
use super::{Change, Timing, effects_of, without};
use crate::film::Film;
use crate::language::ValueError;
use crate::plan::{Effect, Scope};
use crate::render::{Counts, STACK, observed};
use crate::scene::Scene;

/// What the effects of a scene cost.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Prices {
    /// How often everything was drawn; times are medians of so many runs.
    pub runs: u32,
    /// The scene as it is.
    pub whole: Effort,
    /// The scene with nothing left out that changes nothing; its picture is the same.
    pub everything: Effort,
    /// The scene without each effect that it calls for.
    pub without: Vec<Price>,
}

/// What it takes to draw a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Effort {
    /// Processor time of one thread, in seconds; planning is a part of it, reading the scene is not.
    pub time: Timing,
    /// The work in numbers, which are the same in every run.
    pub counts: Counts,
}

/// What an effect costs: what it takes to draw the scene without it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Price {
    /// What is switched off.
    pub effect: Effect,
    /// What goes with it: other effects that are no longer called for.
    pub also_off: Vec<Effect>,
    /// What it takes to draw the scene without it.
    pub effort: Effort,
    /// How many times as long as the whole scene that takes.
    pub takes: f64,
    /// How the picture without it differs.
    pub change: Change,
}

impl Effort {
    /// Rays to lights and to points of lamps.
    #[must_use]
    pub fn shadow_rays(&self) -> u64 {
        self.counts.shadow_rays + self.counts.lamp_rays
    }

    /// Surfaces that are asked for each such ray, on average; `None` without any.
    #[must_use]
    pub fn tests_per_shadow_ray(&self) -> Option<f64> {
        #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
        let [rays, tests] =
            [self.shadow_rays(), self.counts.occlusion_tests].map(|count| count as f64);
        (rays > 0.0).then(|| tests / rays)
    }
}

/// Measures what the effects of a scene cost: draws it as it is, with everything simulated, and
/// without each effect that its plan says is on, all of them in turn, as often as `runs` says,
/// and once at least.
///
/// `progress` is told how many of how many pictures are drawn.
///
/// # Errors
/// Refuses what [`observed`] and [`without`] refuse.
///
/// # Panics
/// If simulating everything changes the picture, which it must not.
pub fn prices(
    scene: &Scene,
    runs: u32,
    progress: &dyn Fn(usize, usize),
) -> Result<Prices, ValueError> {
    let on = effects_of(scene)?;
    let scenes = on.iter().map(|effect| without(scene, *effect));
    let scenes = scenes.collect::<Result<Vec<_>, _>>()?;
    let lesser = scenes.iter().map(|scene| (scene, Scope::CalledFor));
    let mut subjects: Vec<_> = [Scope::CalledFor, Scope::Everything]
        .map(|scope| (scene, scope))
        .into_iter()
        .chain(lesser)
        .map(|(scene, scope)| Subject::new(scene, scope))
        .collect();
    let runs = runs.max(1);
    let all = runs as usize * subjects.len();
    let pool = one_thread()?;
    // Not measured: the first picture also fetches program and textures into the caches.
    let (picture, _) = pool.install(|| observed::<Counts>(scene, Scope::CalledFor, &|_| ()))?;
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

/// A pool of one thread, so that what it does is done in the thread whose time is taken.
fn one_thread() -> Result<ThreadPool, ValueError> {
    let builder = ThreadPoolBuilder::new().num_threads(1).stack_size(STACK);
    builder.build().map_err(|error| {
        let reason = format!("cannot start a thread: {error}");
        ValueError::new("threads", reason, "try again")
    })
}

/// A scene that is drawn again and again.
struct Subject<'a> {
    scene: &'a Scene,
    scope: Scope,
    seconds: Vec<f64>,
    counts: Counts,
    change: Change,
}

impl<'a> Subject<'a> {
    fn new(scene: &'a Scene, scope: Scope) -> Self {
        Self {
            scene,
            scope,
            seconds: Vec::new(),
            counts: Counts::default(),
            change: Change::default(),
        }
    }

    /// Draws it once more and compares it with a picture as it is shown, that had this hash before.
    fn draw(&mut self, picture: &Film, hash: &str) -> Result<(), ValueError> {
        let (seconds, drawn) = timed(|| observed(self.scene, self.scope, &|_| ()));
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
