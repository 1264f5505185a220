//! What of a scene is simulated, and why: the plan in words.

use serde::Serialize;

use crate::language::{Location, Refusal, Sources};
use crate::math::{Decisions, Point, Side};
use crate::plan::{Cause, Decision, Effect, Plan, Scope, Unlit};
use crate::render::{Counts, Tracer, pixel_color, render};
use crate::scene::Scene;
use crate::surface::{Surface, classic};

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
    /// The lights in file order.
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

/// What a light does.
#[derive(Debug, Clone, Serialize)]
pub struct LightRow {
    /// The light.
    pub light: Thing,
    /// How many surfaces it may light.
    pub lights: usize,
    /// The others, by their places in the file, from 0, and why not.
    pub unlit: Vec<(usize, Unlit)>,
    /// What can cast a shadow, and on which of the surfaces.
    pub casters: Vec<(usize, Vec<usize>)>,
    /// What casts none, and why.
    pub casts_nothing: Vec<(usize, NoShadow)>,
}

/// Why a surface casts no shadow in the light of a light.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum NoShadow {
    /// The scene says so.
    Told,
    /// All that the light lights is on the light's own side of it.
    NothingBehind,
    /// Its shadow falls beside all that the light lights.
    FallsBeside,
}

/// A surface.
#[derive(Debug, Clone, Serialize)]
pub struct SurfaceRow {
    /// The surface.
    pub surface: Thing,
    /// Whether any ray can meet it.
    pub seen: bool,
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
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Work {
    /// How many pixels were traced to find out; all of them for an exact count.
    pub pixels: u64,
    /// Of how many.
    pub of: u64,
    /// The rays and tests of the whole picture; of fewer pixels, scaled up.
    pub counts: Counts,
}

/// The most surfaces of which it is told which casts shadows on which.
///
/// Beyond that all surfaces share a list of casters, and nobody reads it.
const MOST_PAIRS: usize = 128;

/// The most pixels that are traced for an estimate: enough for rays to be right within a few percent.
const MOST_PIXELS: usize = 4_096;

/// Explains a scene. With `measure` the work is counted, by tracing the whole picture; without, it is
/// estimated from some of its pixels.
///
/// # Errors
/// Refuses a camera that cannot exist.
pub fn explain(scene: &Scene, measure: bool) -> Result<Explanation, Refusal> {
    let classic = classic::surfaces(&scene.surfaces, scene.picture.numerics);
    let plan = Plan::new(scene, classic.as_deref(), Scope::CalledFor)?;
    let sources = &scene.sources;
    let surfaces = scene.surfaces.iter().zip(&plan.seen);
    let work = if measure {
        Work::counted(scene)?
    } else {
        Work::estimated(&plan)
    };
    let pixels = u64::from(scene.picture.width) * u64::from(scene.picture.height);
    Ok(Explanation {
        size: [scene.picture.width, scene.picture.height],
        samples: scene.picture.samples,
        numerics: scene.picture.numerics.word(),
        effects: plan
            .decisions()
            .into_iter()
            .map(|decision| EffectRow::of(decision, &work.counts, pixels, sources))
            .collect(),
        lights: (0..scene.lights.len())
            .map(|light| LightRow::of(&plan, light))
            .collect(),
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
        cut_off: scene.picture.cut_off,
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
                | Effect::TextureFilter => None,
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

impl LightRow {
    fn of(plan: &Plan<'_>, light: usize) -> Self {
        let scene = plan.scene;
        let (unlit, view) = (&plan.unlit[light], &plan.light_views[light]);
        let reasons = unlit.iter().enumerate();
        let mut row = Self {
            light: Thing::of(&Cause::of_light(&scene.lights[light]), &scene.sources),
            lights: unlit.iter().filter(|why| why.is_none()).count(),
            unlit: reasons
                .filter_map(|(surface, why)| Some((surface, (*why)?)))
                .collect(),
            casters: Vec::new(),
            casts_nothing: Vec::new(),
        };
        if scene.surfaces.len() > MOST_PAIRS {
            return row;
        }
        let mut onto = vec![Vec::new(); scene.surfaces.len()];
        let receivers = scene.surfaces.iter().enumerate();
        for (receiver, surface) in receivers {
            if !surface.common().shadows.receive {
                continue;
            }
            for caster in view.casters_of(receiver) {
                onto[caster].push(receiver);
            }
        }
        for (caster, onto) in onto.into_iter().enumerate() {
            if onto.is_empty() {
                row.casts_nothing
                    .push((caster, no_shadow(plan, light, caster)));
            } else {
                row.casters.push((caster, onto));
            }
        }
        row
    }
}

/// Why a surface casts no shadow, if it does not.
fn no_shadow(plan: &Plan<'_>, light: usize, caster: usize) -> NoShadow {
    let surface = &*plan.scene.surfaces[caster];
    if !surface.common().shadows.cast {
        return NoShadow::Told;
    }
    let Some(flat) = surface.flat() else {
        return NoShadow::FallsBeside;
    };
    let location = Point::exact(plan.scene.lights[light].location);
    let behind = surface.side(&location).opposite();
    let is_behind = |other: &dyn Surface| match other.hull() {
        Some(hull) => hull
            .iter()
            .any(|point| Some(Side::of(flat.exact_height(point).sign())) == behind),
        None => true,
    };
    let lit = plan.unlit[light]
        .iter()
        .zip(&plan.scene.surfaces)
        .enumerate();
    let mut lit = lit.filter(|(index, (unlit, _))| *index != caster && unlit.is_none());
    if lit.any(|(_, (_, other))| is_behind(&**other)) {
        NoShadow::FallsBeside
    } else {
        NoShadow::NothingBehind
    }
}

impl Work {
    /// Whether it was counted, not estimated.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.pixels == self.of
    }

    /// The work of the whole picture.
    fn counted(scene: &Scene) -> Result<Self, Refusal> {
        let (_, counts) = render(scene, &|_| ())?;
        let pixels = u64::from(scene.picture.width) * u64::from(scene.picture.height);
        Ok(Self {
            pixels,
            of: pixels,
            counts,
        })
    }

    /// The work of some pixels, which lie as far apart as they have to, scaled up to the picture.
    fn estimated(plan: &Plan<'_>) -> Self {
        let picture = &plan.scene.picture;
        let [width, height] = [picture.width, picture.height].map(|side| side as usize);
        let fits = |step: &usize| width.div_ceil(*step) * height.div_ceil(*step) <= MOST_PIXELS;
        let step = (1..).find(fits).unwrap_or(1);
        let places = |side: usize| ((step - 1).min(side - 1) / 2..side).step_by(step);
        let tracer = Tracer::new(plan);
        let (mut counts, mut pixels) = (Counts::default(), 0);
        let before = Decisions::of_this_thread();
        for row in places(height) {
            for column in places(width) {
                pixel_color(tracer, plan.scene, column, row, &mut counts);
                pixels += 1;
            }
        }
        counts.decisions = Decisions::of_this_thread() - before;
        let of = (width * height) as u64;
        Self {
            pixels,
            of,
            counts: counts.scaled(of, pixels),
        }
    }
}
