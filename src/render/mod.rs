//! Scene to film: pixels in parallel, the colour along one ray.

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
pub use probe::{Arrival, Probe, RayKind, Unfollowed};
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
use crate::scene::{RenderSettings, Scene};
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
pub fn render(
    scene: &Scene,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<(Film, Counts), ValueError> {
    observed(scene, Scope::CalledFor, progress)
}

/// Renders a scene like [`render`], and finds out how right the picture is.
///
/// # Errors
/// As [`render`].
pub fn certify(
    scene: &Scene,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<(Film, Both<Counts, Certificate>), ValueError> {
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
) -> Result<(Film, P), ValueError> {
    observed_part(scene, scope, whole(&scene.settings), progress)
}

/// Renders a part of a scene's picture, of which every pixel is as in the whole; for the rest as
/// [`observed`].
///
/// # Errors
/// As [`render`]; and refuses a part that is not one.
pub fn observed_part<P: Probe + Default + Send + Sum>(
    scene: &Scene,
    scope: Scope,
    part: Region,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<(Film, P), ValueError> {
    part.check_within([scene.settings.width, scene.settings.height])?;
    let classic = classic::surfaces(&scene.surfaces, scene.settings.numerics);
    drawn_part(
        &Plan::new(scene, classic.as_deref(), scope)?,
        part,
        progress,
    )
}

/// Renders a scene as it is planned; for the rest as [`observed`].
///
/// # Errors
/// Refuses a picture that memory cannot hold.
pub fn drawn<P: Probe + Default + Send + Sum>(
    plan: &Plan<'_>,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<(Film, P), ValueError> {
    drawn_part(plan, whole(&plan.scene.settings), progress)
}

fn drawn_part<P: Probe + Default + Send + Sum>(
    plan: &Plan<'_>,
    part: Region,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<(Film, P), ValueError> {
    let mut film = Film::new(part.width, part.height).ok_or_else(|| no_memory(part))?;
    let painter = Painter::new(plan, part, progress);
    let together = part.width * painter.together;
    let rows = film.pixels_mut().par_chunks_mut(together).enumerate();
    let seen = rows
        .map(|(number, pixels)| painter.paint(number * painter.together, pixels))
        .sum();
    Ok((film, seen))
}

/// Renders a part of a scene's picture like [`observed_part`], but keeps nothing but what a file of this
/// format holds.
///
/// # Errors
/// As [`observed_part`].
pub fn printed_part<P: Probe + Default + Send + Sum>(
    scene: &Scene,
    scope: Scope,
    part: Region,
    format: Format,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<(EncodedImage, P), ValueError> {
    part.check_within([scene.settings.width, scene.settings.height])?;
    let classic = classic::surfaces(&scene.surfaces, scene.settings.numerics);
    let plan = Plan::new(scene, classic.as_deref(), scope)?;
    let encoding = scene.settings.encoding();
    let print = EncodedImage::new([part.width, part.height], format, encoding);
    let mut print = print.ok_or_else(|| no_memory(part))?;
    let painter = Painter::new(&plan, part, progress);
    let rows = print.rows().chunks(painter.together).enumerate();
    let paper = || vec![Rgb::BLACK; part.width * painter.together];
    let seen = rows.map_init(paper, |pixels, (number, kept)| {
        let pixels = &mut pixels[..part.width * kept.len()];
        let seen = painter.paint(number * painter.together, pixels);
        for (mut kept, pixels) in kept.into_iter().zip(pixels.chunks(part.width)) {
            kept.encode_row(pixels);
        }
        seen
    });
    let seen = seen.sum();
    Ok((print, seen))
}

fn whole(picture: &RenderSettings) -> Region {
    Region::whole([picture.width, picture.height])
}

/// The refusal of a picture that memory cannot hold.
#[must_use]
pub fn no_memory(part: Region) -> ValueError {
    let Region { width, height, .. } = part;
    let reason = format!("there is no memory for {width} by {height} pixels");
    ValueError::new("image", reason, "choose a smaller picture")
}

/// What draws the rows of a part of a picture.
struct Painter<'a> {
    plan: &'a Plan<'a>,
    part: Region,
    progress: &'a (dyn Fn(usize) + Sync),
    adaptive: Option<Adaptive<'a>>,
    /// How many rows are drawn by one thread at once.
    together: usize,
    /// The number of rows that are done.
    done: AtomicUsize,
}

impl<'a> Painter<'a> {
    fn new(plan: &'a Plan<'a>, part: Region, progress: &'a (dyn Fn(usize) + Sync)) -> Self {
        // Pixels look at those around them, so rows are best drawn together then.
        const TOGETHER: usize = 16;
        let adaptive = Adaptive::new(Tracer::new(plan), plan);
        Self {
            plan,
            part,
            progress,
            adaptive,
            together: if adaptive.is_some() { TOGETHER } else { 1 },
            done: AtomicUsize::new(0),
        }
    }

    /// Gives the pixels of some rows of the part, from this one on, their colours, and tells what was
    /// seen.
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
        let done = self.done.fetch_add(rows.height, Ordering::Relaxed);
        (self.progress)(done + rows.height);
        probe
    }
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
    if let Some(adaptive) = Adaptive::new(tracer, tracer.plan) {
        return adaptive.color([column, row], probe);
    }
    uniform(tracer, scene, column, row, probe)
}

/// The colour of a pixel of a picture that asks for the same number of rays everywhere.
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
