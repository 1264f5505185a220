//! What of a scene is simulated, and why: the plan in words.

use serde::Serialize;

use super::{LightRow, LightTests};
use crate::language::{Location, Sources, ValueError};
use crate::plan::{Cause, Decision, Effect, Plan, Reachability, Scope};
use crate::render::{Counts, ThreadWork, Tracer, pixel_color, render};
use crate::scene::Scene;

/// What of a scene is simulated, and why.
#[derive(Debug, Clone, Serialize)]
pub struct Explanation {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Rays through each pixel.
    pub samples: u32,
    /// What decides where rays meet surfaces.
    pub numerics: &'static str,
    /// Every effect, called for or not.
    pub effects: Vec<EffectRow>,
    /// The lights in file order, and after them the lamps.
    pub lights: Vec<LightRow>,
    /// The surfaces in file order.
    pub surfaces: Vec<SurfaceRow>,
    /// How the surfaces that a ray may meet are found: by asking those of a `list`, or of a `tree` of
    /// boxes.
    pub accelerator: &'static str,
    /// The images in use.
    pub textures: Vec<TextureRow>,
    /// How much intensity a pixel may lack because rays are not followed for ever.
    pub cut_off: f64,
    /// The work.
    pub work: Work,
}

/// Whether an effect is simulated.
#[derive(Debug, Clone, Serialize)]
pub struct EffectRow {
    /// Which.
    pub effect: Effect,
    /// Whether it is simulated.
    pub on: bool,
    /// Why, in words.
    pub why: String,
    /// How many rays it causes, counted or estimated like the [`work`](Explanation::work); `None` for
    /// effects that cause none of their own.
    pub rays: Option<u64>,
    /// What calls for it.
    pub because_of: Vec<Thing>,
}

/// A thing of the scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Thing {
    /// Its kind and name.
    pub title: String,
    /// `file:line:column`, if it was read from a text.
    pub place: Option<String>,
}

/// A surface.
#[derive(Debug, Clone, Serialize)]
pub struct SurfaceRow {
    /// The surface.
    pub surface: Thing,
    /// How rays can meet it.
    pub seen: Reachability,
}

/// An image in use.
#[derive(Debug, Clone, Serialize)]
pub struct TextureRow {
    /// Its name.
    pub name: String,
    /// Width and height in texels.
    pub size: [usize; 2],
    /// What it takes in memory.
    pub bytes: usize,
}

/// How much work a picture is.
#[derive(Debug, Clone, Serialize)]
pub struct Work {
    /// How many pixels were traced to find out; all of them for an exact count.
    pub pixels: u64,
    /// Of how many.
    pub of: u64,
    /// The rays and tests of the whole picture; of fewer pixels, scaled up.
    pub counts: Counts,
    /// How many of the tests each light and each lamp takes.
    pub by_light: Vec<LightTests>,
}

/// The most pixels that are traced for an estimate: enough for rays to be right within a few percent.
const MOST_PIXELS: usize = 4_096;

/// Explains a scene. With `measure` the work is counted, by tracing the whole picture; without, it is
/// estimated from some of its pixels.
///
/// # Errors
/// Refuses a camera that cannot exist.
pub fn explain(scene: &Scene, measure: bool) -> Result<Explanation, ValueError> {
    let plan = Plan::new(scene, Scope::CalledFor)?;
    let sources = &scene.sources;
    let surfaces = scene.surfaces.iter().zip(&plan.reachability);
    let work = if measure {
        Work::counted(scene)?
    } else {
        Work::estimated(&plan)
    };
    let pixels = u64::from(scene.settings.width) * u64::from(scene.settings.height);
    Ok(Explanation {
        size: [scene.settings.width, scene.settings.height],
        samples: scene.settings.samples,
        numerics: scene.settings.numerics.word(),
        effects: plan
            .decisions()
            .into_iter()
            .map(|decision| EffectRow::of(decision, &work.counts, pixels, sources))
            .collect(),
        lights: LightRow::all(&plan),
        surfaces: surfaces
            .map(|(surface, seen)| SurfaceRow {
                surface: Thing::of(&Cause::of_surface(&**surface), sources),
                seen: *seen,
            })
            .collect(),
        textures: scene
            .textures
            .iter()
            .map(|texture| TextureRow {
                name: texture.name.clone(),
                size: [texture.texels.width, texture.texels.height],
                bytes: size_of_val(texture.texels.channels.as_slice()),
            })
            .collect(),
        accelerator: plan.surfaces.accelerator().word(),
        cut_off: scene.settings.cut_off,
        work,
    })
}

impl EffectRow {
    fn of(decision: Decision, counts: &Counts, pixels: u64, sources: &Sources) -> Self {
        let causes = decision.causes.iter();
        Self {
            rays: match decision.effect {
                Effect::Shadows => Some(counts.shadow_rays),
                Effect::SoftShadows => Some(counts.lamp_rays),
                Effect::Mirrors => Some(counts.mirror_rays),
                Effect::Transparency => Some(counts.transmitted_rays),
                Effect::Antialiasing => Some(counts.camera_rays - pixels),
                Effect::Refraction
                | Effect::Glints
                | Effect::SpotCones
                | Effect::Projectors
                | Effect::Textures
                | Effect::TextureFilter
                | Effect::TransferCurve => None,
            },
            effect: decision.effect,
            on: decision.on,
            why: decision.why,
            because_of: causes.map(|cause| Thing::of(cause, sources)).collect(),
        }
    }
}

impl Thing {
    /// The thing that a cause is, with its place in words.
    pub(super) fn of(cause: &Cause, sources: &Sources) -> Self {
        let place = |at: Location| sources.position(at);
        Self {
            title: cause.title.clone(),
            place: cause.location.map(place),
        }
    }
}

impl Work {
    /// Whether it was counted, not estimated.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.pixels == self.of
    }

    /// The work of the whole picture.
    fn counted(scene: &Scene) -> Result<Self, ValueError> {
        let (_, counts) = render(scene, &|_| ())?;
        let pixels = u64::from(scene.settings.width) * u64::from(scene.settings.height);
        Ok(Self {
            pixels,
            of: pixels,
            by_light: LightTests::all(scene, &counts),
            counts,
        })
    }

    /// The work of some pixels, which lie as far apart as they have to, scaled up to the picture.
    fn estimated(plan: &Plan<'_>) -> Self {
        let picture = &plan.scene.settings;
        let [width, height] = [picture.width, picture.height].map(|side| side as usize);
        let fits = |step: &usize| width.div_ceil(*step) * height.div_ceil(*step) <= MOST_PIXELS;
        let step = (1..).find(fits).unwrap_or(1);
        let places = |side: usize| ((step - 1).min(side - 1) / 2..side).step_by(step);
        let tracer = Tracer::new(plan);
        let (mut counts, mut pixels) = (Counts::default(), 0);
        let before = ThreadWork::until_now();
        for row in places(height) {
            for column in places(width) {
                pixel_color(tracer, plan.scene, column, row, &mut counts);
                pixels += 1;
            }
        }
        before.tell(&mut counts);
        let of = (width * height) as u64;
        let counts = counts.scaled(of, pixels);
        Self {
            pixels,
            of,
            by_light: LightTests::all(plan.scene, &counts),
            counts,
        }
    }
}
