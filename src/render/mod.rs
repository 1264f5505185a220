//! Rendering: pixels in parallel, and the colour along each ray.

mod adaptive;
mod beams;
mod both;
mod budget;
mod certificate;
mod counts;
mod edge_detector;
mod errors;
mod lamps;
mod media;
mod probe;
mod rows;
mod sample_accumulator;
mod scattering;
mod seed;
mod shading;
mod thread_work;
mod tracer;

pub use adaptive::rays_at_a_border;
pub use both::Both;
pub use certificate::Certificate;
pub use counts::Counts;
pub use errors::Errors;
pub use probe::{Arrival, Event, Probe, RayKind, Unfollowed};
pub use scattering::Scattering;
pub use thread_work::ThreadWork;
pub use tracer::Tracer;

use adaptive::Adaptive;
use seed::Seed;
use std::iter::Sum;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::camera::{Pattern, SamplePositions};
use crate::film::{EncodedImage, Film, Format, Region};
use crate::language::ValueError;
use crate::math::Rgb;
use crate::plan::{Plan, Scope};
use crate::scene::Scene;

/// The stack size of a thread that renders, in bytes.
///
/// It has room for the longest path.
pub const STACK: usize = 16 << 20;

/// Renders a scene on the current thread pool, and counts the work.
///
/// `progress` is called with the number of finished rows, from any thread. The film does not depend
/// on the number of threads.
///
/// # Errors
/// Returns an error for a camera that cannot exist, and for a picture that memory cannot hold.
pub fn render(
    scene: &Scene,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<(Film, Counts), ValueError> {
    Render::new(scene).progress(progress).film()
}

/// A picture to be rendered: a scene, and the part and scope of it.
#[expect(
    missing_debug_implementations,
    reason = "a function has no form to show"
)]
#[derive(Clone, Copy)]
pub struct Render<'a> {
    scene: &'a Scene,
    scope: Scope,
    part: Region,
    progress: &'a (dyn Fn(usize) + Sync),
}

impl<'a> Render<'a> {
    /// The whole picture of a scene, with the effects that contribute to it.
    #[must_use]
    pub fn new(scene: &'a Scene) -> Self {
        Self {
            scene,
            scope: Scope::CalledFor,
            part: Region::whole([scene.settings.width, scene.settings.height]),
            progress: &|_| (),
        }
    }

    /// Sets the scope.
    #[must_use]
    pub fn scope(self, scope: Scope) -> Self {
        Self { scope, ..self }
    }

    /// Sets the part of the picture; its pixels are the same as in the whole picture.
    #[must_use]
    pub fn part(self, part: Region) -> Self {
        Self { part, ..self }
    }

    /// Calls a function with the number of finished rows, from any thread.
    #[must_use]
    pub fn progress(self, progress: &'a (dyn Fn(usize) + Sync)) -> Self {
        Self { progress, ..self }
    }

    /// Renders the picture with one probe for each group of rows, and sums the probes.
    ///
    /// Neither depends on the number of threads.
    ///
    /// # Errors
    /// Returns an error for a camera that cannot exist, for a part outside of the picture, and for a
    /// picture that memory cannot hold.
    pub fn film<P: Probe + Default + Send + Sum>(self) -> Result<(Film, P), ValueError> {
        self.planned(&self.plan()?)
    }

    /// Renders the picture like [`film`](Self::film), with a given plan of its scene.
    ///
    /// # Errors
    /// Returns an error for a picture that memory cannot hold.
    pub fn planned<P: Probe + Default + Send + Sum>(
        self,
        plan: &Plan<'_>,
    ) -> Result<(Film, P), ValueError> {
        let part = self.part;
        let mut film = Film::new(part.width, part.height).ok_or_else(|| no_memory(part))?;
        let painter = Painter::new(plan, part, self.progress);
        let pixels_per_task = part.width * painter.rows_per_task;
        let rows = film
            .pixels_mut()
            .par_chunks_mut(pixels_per_task)
            .enumerate();
        let observed = rows
            .map(|(number, pixels)| painter.paint(number * painter.rows_per_task, pixels))
            .sum();
        Ok((film, observed))
    }

    /// Renders like [`film`](Self::film), and keeps only the numbers of a file format.
    ///
    /// # Errors
    /// As [`film`](Self::film).
    pub fn encoded<P: Probe + Default + Send + Sum>(
        self,
        format: Format,
    ) -> Result<(EncodedImage, P), ValueError> {
        let (plan, part) = (self.plan()?, self.part);
        let encoding = self.scene.settings.encoding();
        let image = EncodedImage::new([part.width, part.height], format, encoding);
        let mut image = image.ok_or_else(|| no_memory(part))?;
        let painter = Painter::new(&plan, part, self.progress);
        let rows = image.rows().chunks(painter.rows_per_task).enumerate();
        let blank = || vec![Rgb::BLACK; part.width * painter.rows_per_task];
        let observed = rows.map_init(blank, |pixels, (number, encoded)| {
            let pixels = &mut pixels[..part.width * encoded.len()];
            let observed = painter.paint(number * painter.rows_per_task, pixels);
            for (mut row, pixels) in encoded.into_iter().zip(pixels.chunks(part.width)) {
                row.encode_row(pixels);
            }
            observed
        });
        let observed = observed.sum();
        Ok((image, observed))
    }

    /// The plan of the scene, if the part lies in its picture.
    fn plan(&self) -> Result<Plan<'a>, ValueError> {
        let settings = &self.scene.settings;
        self.part.check_within([settings.width, settings.height])?;
        Plan::new(self.scene, self.scope)
    }
}

/// The error for a picture that memory cannot hold.
#[must_use]
pub fn no_memory(part: Region) -> ValueError {
    let Region { width, height, .. } = part;
    let reason = format!("there is no memory for {width} by {height} pixels");
    ValueError::new("image", reason, "choose a smaller picture")
}

/// The renderer of the rows of a part of a picture.
struct Painter<'a> {
    plan: &'a Plan<'a>,
    part: Region,
    progress: &'a (dyn Fn(usize) + Sync),
    adaptive: Option<Adaptive<'a>>,
    /// The number of rows in one task.
    rows_per_task: usize,
    /// The number of finished rows.
    finished: AtomicUsize,
}

impl<'a> Painter<'a> {
    fn new(plan: &'a Plan<'a>, part: Region, progress: &'a (dyn Fn(usize) + Sync)) -> Self {
        // Adaptive pixels sample their neighbours too, so groups of rows share that work.
        const ROWS_PER_TASK: usize = 16;
        let adaptive = Adaptive::new(Tracer::new(plan), plan);
        Self {
            plan,
            part,
            progress,
            adaptive,
            rows_per_task: if adaptive.is_some() { ROWS_PER_TASK } else { 1 },
            finished: AtomicUsize::new(0),
        }
    }

    /// Renders the pixels of some rows of the part, and returns the probe.
    ///
    /// `row` is the first of them, counted in the part.
    fn paint<P: Probe + Default>(&self, row: usize, pixels: &mut [Rgb]) -> P {
        let (tracer, scene) = (Tracer::new(self.plan), self.plan.scene);
        let rows = Region {
            top: self.part.top + row,
            height: pixels.len() / self.part.width,
            ..self.part
        };
        let mut probe = P::default();
        let before = ThreadWork::until_now();
        match &self.adaptive {
            Some(adaptive) => adaptive.draw(rows, pixels, &mut probe),
            None if scene.settings.samples == 1 => tracer.draw(rows, pixels, &mut probe),
            None => {
                for ([column, row], pixel) in rows.pixels().zip(pixels) {
                    *pixel = uniform(tracer, scene, column, row, &mut probe);
                }
            }
        }
        before.tell(&mut probe);
        let done = self.finished.fetch_add(rows.height, Ordering::Relaxed);
        (self.progress)(done + rows.height);
        probe
    }
}

/// The colour of a pixel, counted from the top left, from 0.
///
/// It is the unclamped mean of the pixel's samples, summed in order.
pub fn pixel_color(
    tracer: Tracer<'_>,
    scene: &Scene,
    column: usize,
    row: usize,
    probe: &mut impl Probe,
) -> Rgb {
    if let Some(adaptive) = Adaptive::new(tracer, tracer.plan) {
        return adaptive.color([column, row], probe);
    }
    uniform(tracer, scene, column, row, probe)
}

/// The colour of a pixel with a fixed number of rays.
fn uniform(
    tracer: Tracer<'_>,
    scene: &Scene,
    column: usize,
    row: usize,
    probe: &mut impl Probe,
) -> Rgb {
    // The picture's rows are counted from the top, the camera's from the bottom.
    let from_bottom = scene.settings.height as usize - 1 - row;
    #[expect(
        clippy::cast_precision_loss,
        reason = "picture sides are far below 2^53"
    )]
    let (x, y) = (column as f64, from_bottom as f64);
    let (pattern, count) = (scene.settings.pattern, scene.settings.samples);
    if count == 1 {
        return tracer.sees(x, y, probe);
    }
    let places = SamplePositions::new(pattern, column, from_bottom, count);
    let mut sum = Rgb::BLACK;
    for number in 0..count {
        let [dx, dy] = places.at(number);
        let (x, y) = (x + dx, y + dy);
        let color = match pattern {
            Pattern::Sobol => tracer.sees_as(x, y, Seed::shared(places.seed, number), probe),
            _ => tracer.sees(x, y, probe),
        };
        sum = (sum + color).saturated();
    }
    sum / f64::from(count)
}
