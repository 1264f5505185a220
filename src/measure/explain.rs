//! Effects, lights and surfaces that are simulated, each with its reason.

use serde::Serialize;

use super::light_row::LightRow;
use super::light_tests::LightTests;
use super::scene_item::SceneItem;
use crate::language::{Sources, ValueError};
use crate::plan::{Cause, Decision, Effect, Plan, Reachability, Scope};
use crate::render::{Counts, ThreadWork, Tracer, pixel_color, render};
use crate::scene::Scene;

/// Plan of a scene in words.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct Explanation {
    /// Width and height in pixels.
    pub(crate) size: [u32; 2],
    pub(crate) samples: u32,
    pub(crate) numerics: &'static str,
    /// All effects, simulated or not.
    pub(crate) effects: Vec<EffectRow>,
    /// Lights in file order, then lamps.
    pub(crate) lights: Vec<LightRow>,
    pub(crate) surfaces: Vec<SurfaceRow>,
    /// Search for the nearest hit: a `list` of all surfaces, or a `tree` of bounds.
    pub(crate) accelerator: &'static str,
    pub(crate) textures: Vec<TextureRow>,
    /// Intensity that a pixel may lack because of rays that are not followed.
    pub(crate) cut_off: f64,
    pub(crate) work: Work,
}

/// An effect and its cost.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct EffectRow {
    pub(crate) effect: Effect,
    pub(crate) on: bool,
    pub(crate) why: String,
    /// Rays that it causes, counted or estimated like [`work`](Explanation::work); `None` for effects
    /// without rays of their own.
    pub(crate) rays: Option<u64>,
    /// Surfaces and lights that call for it.
    pub(crate) because_of: Vec<SceneItem>,
}

/// A surface.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct SurfaceRow {
    pub(crate) surface: SceneItem,
    /// Rays that can reach it.
    pub(crate) seen: Reachability,
}

/// An image in use.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct TextureRow {
    pub(crate) name: String,
    /// Width and height in texels.
    pub(crate) size: [usize; 2],
    pub(crate) bytes: usize,
}

/// Work of a picture, counted or estimated.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct Work {
    /// Pixels traced for it; all of them for an exact count.
    pub(crate) pixels: u64,
    /// Pixels of the picture.
    pub(crate) of: u64,
    /// Rays and tests of the whole picture, scaled up from the traced pixels.
    pub(crate) counts: Counts,
    /// Occlusion tests of each light, then of each lamp.
    pub(crate) by_light: Vec<LightTests>,
}

/// Most pixels traced for an estimate; the counts of rays are then right within a few percent.
const MOST_PIXELS: usize = 4_096;

/// Explains a scene; `measure` counts the work by tracing the whole picture instead of some pixels.
///
/// # Errors
/// Refuses a camera that cannot exist.
pub(crate) fn explain(scene: &Scene, measure: bool) -> Result<Explanation, ValueError> {
    let plan = Plan::new(scene, Scope::CalledFor)?;
    let settings = &scene.settings;
    let all = u64::from(settings.width) * u64::from(settings.height);
    let (pixels, counts) = if measure {
        (all, render(scene, &|_| ())?.1)
    } else {
        let (pixels, counts) = traced(&plan);
        (pixels, counts.scaled(all, pixels))
    };
    let effect = |decision| EffectRow::of(decision, &counts, all, &scene.sources);
    let effects = plan.decisions().into_iter().map(effect);
    let surfaces = scene.surfaces.iter().zip(&plan.reachability);
    let surfaces = surfaces.map(|(surface, seen)| SurfaceRow {
        surface: SceneItem::of(&Cause::of_surface(&**surface), &scene.sources),
        seen: *seen,
    });
    let textures = scene.textures.iter().map(|texture| TextureRow {
        name: texture.name.clone(),
        size: [texture.texels.width, texture.texels.height],
        bytes: size_of_val(texture.texels.channels.as_slice()),
    });
    Ok(Explanation {
        size: [settings.width, settings.height],
        samples: settings.samples,
        numerics: settings.numerics.word(),
        effects: effects.collect(),
        lights: LightRow::all(&plan),
        surfaces: surfaces.collect(),
        textures: textures.collect(),
        accelerator: plan.surfaces.accelerator().word(),
        cut_off: settings.cut_off,
        work: Work {
            pixels,
            of: all,
            by_light: LightTests::all(scene, &counts),
            counts,
        },
    })
}

/// Traces a grid of at most [`MOST_PIXELS`] pixels and returns their number and work.
fn traced(plan: &Plan<'_>) -> (u64, Counts) {
    let settings = &plan.scene.settings;
    let [width, height] = [settings.width, settings.height].map(|side| side as usize);
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
    (pixels, counts)
}

/// Effects simulated in a scene.
///
/// # Errors
/// Refuses a camera that cannot exist.
pub fn effects_of(scene: &Scene) -> Result<Vec<Effect>, ValueError> {
    let plan = Plan::new(scene, Scope::CalledFor)?;
    let on = plan.decisions().into_iter().filter(|decision| decision.on);
    Ok(on.map(|decision| decision.effect).collect())
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
            because_of: causes.map(|cause| SceneItem::of(cause, sources)).collect(),
        }
    }
}

impl Work {
    /// True if it was counted, not estimated.
    pub(crate) fn is_exact(&self) -> bool {
        self.pixels == self.of
    }
}
