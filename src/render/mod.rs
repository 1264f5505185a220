//! Scene to film: pixels in parallel, the colour along one ray.

mod beams;
mod errors;
mod lamps;
mod media;
mod probe;
mod samples;
mod shading;
mod tracer;

pub use errors::{Certificate, Errors};
pub use probe::{Arrival, Counts, Probe, RayKind, Unfollowed};
pub use samples::samples;
pub use tracer::Tracer;

use std::iter::Sum;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::film::Film;
use crate::language::Refusal;
use crate::math::{Decisions, Rgb};
use crate::plan::{Plan, Scope};
use crate::scene::Scene;
use crate::surface::classic;

/// Stack of a thread that renders, in bytes: room for the longest path of mirrored rays.
pub const STACK: usize = 16 << 20;

/// Renders a scene on the current thread pool, and counts the work.
///
/// `progress` is told how many of the picture's rows are done; it may be called from any thread.
/// The film does not depend on the number of threads.
///
/// # Errors
/// Refuses a camera that cannot exist and a picture that memory cannot hold.
pub fn render(scene: &Scene, progress: &(dyn Fn(usize) + Sync)) -> Result<(Film, Counts), Refusal> {
    observed(scene, Scope::CalledFor, progress)
}

/// Renders a scene like [`render`], and finds out how right the picture is.
///
/// # Errors
/// As [`render`].
pub fn certify(
    scene: &Scene,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<(Film, Certificate), Refusal> {
    observed(scene, Scope::CalledFor, progress)
}

/// Renders a scene with an onlooker of any kind for each row of pixels, and adds up what they saw;
/// neither the film nor the sum depends on the number of threads.
///
/// # Errors
/// As [`render`].
pub fn observed<P: Probe + Default + Send + Sum>(
    scene: &Scene,
    scope: Scope,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<(Film, P), Refusal> {
    let classic = classic::surfaces(&scene.surfaces, scene.picture.numerics);
    drawn(&Plan::new(scene, classic.as_deref(), scope)?, progress)
}

/// Renders a scene as it is planned; for the rest as [`observed`].
///
/// # Errors
/// Refuses a picture that memory cannot hold.
pub fn drawn<P: Probe + Default + Send + Sum>(
    plan: &Plan<'_>,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<(Film, P), Refusal> {
    let (scene, tracer) = (plan.scene, Tracer::new(plan));
    let (width, height) = (scene.picture.width as usize, scene.picture.height as usize);
    let mut film = Film::new(width, height).ok_or_else(|| {
        let reason = format!("there is no memory for {width} by {height} pixels");
        Refusal::new("image", reason, "choose a smaller picture")
    })?;
    let done = AtomicUsize::new(0);
    let rows = film.pixels_mut().par_chunks_mut(width).enumerate();
    let seen = rows
        .map(|(row, pixels)| {
            let mut probe = P::default();
            let before = Decisions::of_this_thread();
            for (column, pixel) in pixels.iter_mut().enumerate() {
                *pixel = pixel_color(tracer, scene, column, row, &mut probe);
            }
            probe.decisions(Decisions::of_this_thread() - before);
            progress(done.fetch_add(1, Ordering::Relaxed) + 1);
            probe
        })
        .sum();
    Ok((film, seen))
}

/// The colour of the pixel in a column and a row, counted from the top left, from 0: the mean of its
/// samples, unclamped, summed in their order.
pub fn pixel_color(
    tracer: Tracer<'_>,
    scene: &Scene,
    column: usize,
    row: usize,
    probe: &mut impl Probe,
) -> Rgb {
    // The picture's rows are counted from the top, the camera's from the bottom.
    let from_bottom = scene.picture.height as usize - 1 - row;
    #[expect(
        clippy::cast_precision_loss,
        reason = "picture sides are far below 2^53"
    )]
    let (x, y) = (column as f64, from_bottom as f64);
    if scene.picture.samples == 1 {
        return tracer.sees(x, y, probe);
    }
    let mut sum = Rgb::BLACK;
    for (dx, dy) in samples(column, from_bottom, scene.picture.samples) {
        sum = (sum + tracer.sees(x + dx, y + dy, probe)).saturated();
    }
    sum / f64::from(scene.picture.samples)
}
