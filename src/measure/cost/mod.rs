//! What accuracy costs in time: settings of one scene, each measured against a reference.

mod blame;
mod chart;
mod choice;
mod csv;
mod dial;
mod front;
mod ladder;
mod law;
mod measured;
mod page;
mod pictures;
mod plot;
mod reference;
mod spots;
mod table;
mod words;

pub use blame::{Blame, SpotShare, SurfaceShare};
pub use choice::{Best, Limit, Metric};
pub use dial::{DIALS, Dial};
pub use ladder::{Ladder, Rung, Variation};
pub use law::{Law, Trade, exponent};
pub use measured::{Measured, Pictures};
pub use reference::{Doubt, Reference};
pub use spots::Spot;

use serde::Serialize;

use crate::film::Film;
use crate::language::ValueError;
use crate::plan::{Effect, Plan, Scope};
use crate::render::{Counts, observed};
use crate::scene::{RenderSettings, Scene};
use crate::surface::classic;
use measured::Subject;
use spots::Spots;

/// What accuracy costs in one scene.
#[derive(Debug, Clone, Serialize)]
pub struct Cost {
    /// Width and height of the picture in pixels.
    pub size: [u32; 2],
    /// How often each rung was drawn at most; times are medians of its runs.
    pub runs: u32,
    /// How many threads drew.
    pub threads: usize,
    /// What the pictures were compared with.
    pub reference: Reference,
    /// The rungs in the order of the ladder.
    pub rungs: Vec<Measured>,
    /// What each dial buys for time.
    pub laws: Vec<Law>,
    /// Where in the picture each dial errs most.
    pub blames: Vec<Blame>,
    /// The rung that is recommended.
    pub recommended: Best,
}

/// Measures what the rungs of a ladder cost: draws each of them in turn, at most as often as `runs`
/// says and no more once its time has settled ([`Timing::has_settled`](super::Timing::has_settled)),
/// on all threads of the current pool, after some pictures that are not counted; and compares them with a
/// reference, the best picture that there is if none is given.
///
/// The scene's picture has its own settings whenever nothing is drawn. `pictures` asks for the pictures of
/// all rungs. `progress` is told how many of how many steps are done.
///
/// # Errors
/// Refuses what cannot be rendered.
pub fn cost(
    scene: &mut Scene,
    ladder: &Ladder,
    reference: Option<Reference>,
    runs: u32,
    pictures: bool,
    progress: &dyn Fn(usize, usize),
) -> Result<Cost, ValueError> {
    let (base, runs) = (scene.settings, runs.max(1));
    // The reference and the best of each dial are about as much work as one run.
    let steps = (runs as usize + 1) * ladder.0.len();
    progress(0, steps);
    let truth = Truth {
        // First, while the scene has its own settings.
        spots: Spots::of(scene)?,
        reference: match reference {
            Some(reference) => reference,
            None => Reference::automatic(scene, ladder)?,
        },
        twins: twins(scene, base, ladder)?,
    };
    warm_up(scene, ladder)?;
    let mut done = ladder.0.len();
    progress(done, steps);
    let subjects = ladder.0.iter();
    let mut subjects: Vec<_> = subjects.map(|rung| Subject::new(rung.clone())).collect();
    for run in 0..runs {
        for subject in &mut subjects {
            if !subject.has_settled() {
                let film = subject.draw(scene)?;
                if run == 0 {
                    subject.compare(film, &truth, pictures)?;
                }
            }
            done += 1;
            progress(done, steps);
        }
    }
    let mut rungs: Vec<_> = subjects.into_iter().map(Subject::measured).collect();
    let doubt = truth.reference.doubt.map_or(0.0, |doubt| doubt.rmse);
    front::mark(&mut rungs, doubt);
    Ok(Cost {
        size: [base.width, base.height],
        runs,
        threads: rayon::current_num_threads(),
        laws: law::all(&rungs, doubt),
        blames: blame::all(&rungs, scene),
        recommended: choice::recommended(&rungs, doubt),
        reference: truth.reference,
        rungs,
    })
}

/// What a rung is compared with, and what there is to be seen where it errs.
#[derive(Debug)]
struct Truth {
    reference: Reference,
    twins: Vec<Twin>,
    spots: Spots,
}

/// A picture in which one dial is at its best, and else what the scene says.
#[derive(Debug)]
struct Twin {
    dial: &'static str,
    film: Film,
}

/// The twins of the dials of a ladder that have a best setting; what only shapes what is written is
/// at its best before that.
fn twins(
    scene: &mut Scene,
    base: RenderSettings,
    ladder: &Ladder,
) -> Result<Vec<Twin>, ValueError> {
    let mut twins = Vec::new();
    for dial in DIALS {
        let turned = ladder.0.iter().find(|rung| rung.dial == Some(dial.word));
        let (Some(rung), true) = (turned, !dial.by_reference) else {
            continue;
        };
        let best = if dial.in_writing {
            base
        } else {
            dial.best()
                .map_or(rung.picture, |best| rung.picture.with(&best))
        };
        let (film, _) = draw(scene, best)?;
        twins.push(Twin {
            dial: dial.word,
            film: film.displayed(best.transfer),
        });
    }
    Ok(twins)
}

/// Draws what is not measured: the first picture also fetches program and textures into the caches, and
/// the first with a filter makes what that needs of each texture.
fn warm_up(scene: &mut Scene, ladder: &Ladder) -> Result<(), ValueError> {
    let base = scene.settings;
    draw(scene, base)?;
    let mut filters = vec![base.texture_filter];
    for Rung { picture, .. } in &ladder.0 {
        if !filters.contains(&picture.texture_filter) {
            filters.push(picture.texture_filter);
            let quick = RenderSettings {
                samples: 1,
                max_error: 0.0,
                texture_filter: picture.texture_filter,
                ..base
            };
            draw(scene, quick)?;
        }
    }
    Ok(())
}

/// Draws a scene with other settings of its picture, and gives it back its own.
fn draw(scene: &mut Scene, picture: RenderSettings) -> Result<(Film, Counts), ValueError> {
    let own = std::mem::replace(&mut scene.settings, picture);
    let drawn = observed(scene, Scope::CalledFor, &|_| ());
    scene.settings = own;
    drawn
}

/// The effects that are simulated in a scene.
///
/// # Errors
/// Refuses a camera that cannot exist.
pub fn effects_of(scene: &Scene) -> Result<Vec<Effect>, ValueError> {
    let classic = classic::surfaces(&scene.surfaces, scene.settings.numerics);
    let plan = Plan::new(scene, classic.as_deref(), Scope::CalledFor)?;
    let on = plan.decisions().into_iter().filter(|decision| decision.on);
    Ok(on.map(|decision| decision.effect).collect())
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;
    use std::sync::Mutex;

    use super::*;
    use crate::read::{Options, read_bytes};

    #[test]
    fn progress_begins_with_nothing_done_and_ends_with_all() {
        let text = "image 4 3\ncamera { viewpoint 0 0 4; look-at 0 0 0 }";
        let reading = read_bytes("scene", text.into(), PathBuf::new(), &Options::default());
        let mut scene = reading.expect("a scene").scene;
        let variation = Variation::new("samples=4").expect("a variation");
        let ladder = Ladder::of_each(scene.settings, &[variation]).expect("a ladder");
        let told = Mutex::new(Vec::new());
        let note = |done, of| told.lock().expect("a list").push((done, of));
        cost(&mut scene, &ladder, None, 2, false, &note).expect("a cost");
        let told = told.into_inner().expect("a list");
        assert_eq!(told, [(0, 6), (2, 6), (3, 6), (4, 6), (5, 6), (6, 6)]);
    }
}
