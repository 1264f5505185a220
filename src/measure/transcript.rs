//! How one pixel came by its colour.

use serde::Serialize;

use super::Thing;
use crate::geometry::Hit;
use crate::language::ValueError;
use crate::math::Rgb;
use crate::plan::{Cause, Plan, Scope};
use crate::render::{Arrival, Event, Probe, RayKind, Tracer, Unfollowed, pixel_color};
use crate::scene::Scene;

/// How one pixel came by its colour: everything that the tracer did for it.
#[derive(Debug, Clone, Serialize)]
pub struct PixelStory {
    /// Column and row, counted from the top left, from 0.
    pub pixel: [u32; 2],
    /// Its colour: the mean of all rays from the eye.
    pub color: [f64; 3],
    /// What each ray from the eye met and caused.
    pub rays: Vec<Step>,
}

/// A ray, what it met, and what came of it.
#[derive(Debug, Clone, Serialize)]
pub struct Step {
    /// Where it comes from.
    pub kind: &'static str,
    /// The share of what it brings back that its surface passes on.
    pub share: [f64; 3],
    /// What it met; `None` for nothing.
    pub met: Option<Met>,
    /// What the surface itself sends back: ambient and the light of all lights and lamps, faded, and
    /// as much of it as counts beside what the surface mirrors and lets through.
    pub own: [f64; 3],
    /// What of that is the light of lamps, or its own glow if it is one.
    pub of_lamps: [f64; 3],
    /// What each light did there, and after the lights each lamp.
    pub lights: Vec<LightStep>,
    /// The rays that it caused.
    pub causes: Vec<Self>,
    /// The rays that it did not cause, and why.
    pub unfollowed: Vec<UnfollowedStep>,
    /// What it brings back.
    pub brings: [f64; 3],
}

/// Where a ray met a surface.
#[derive(Debug, Clone, Serialize)]
pub struct Met {
    /// The surface.
    pub surface: Thing,
    /// The distance from where the ray set out.
    pub distance: f64,
    /// The place.
    pub place: [f64; 3],
    /// The colour of the surface's image there; white without one.
    pub texel: [f64; 3],
    /// Whether it is a lamp, whose own light is its glow.
    pub glows: bool,
}

/// What a light or a lamp does where a ray has met a surface.
#[derive(Debug, Clone, Serialize)]
pub struct LightStep {
    /// The light, or the lamp.
    pub light: Thing,
    /// What became of its light, in words.
    pub what: String,
    /// What arrives of a light, before angle and distance, or of a lamp; `None` if nothing does.
    pub arrives: Option<[f64; 3]>,
    /// The share of a lamp's light that passes what stands in its way; `None` for a light, and for a
    /// lamp that does not shine here.
    pub share: Option<[f64; 3]>,
    /// How many rays were sent to find that out.
    pub rays: u64,
}

/// A ray that did not set out.
#[derive(Debug, Clone, Serialize)]
pub struct UnfollowedStep {
    /// Where it would have come from.
    pub kind: &'static str,
    /// Why it did not set out.
    pub why: String,
}

/// How the pixel in a column and a row, counted from the top left, from 0, comes by its colour.
///
/// # Errors
/// Refuses a camera that cannot exist, and a pixel outside of the picture.
pub fn transcript(scene: &Scene, [column, row]: [u32; 2]) -> Result<PixelStory, ValueError> {
    let (width, height) = (scene.settings.width, scene.settings.height);
    if column >= width || row >= height {
        let reason =
            format!("there is no pixel {column},{row} in a picture of {width} by {height}");
        let help = "columns and rows are counted from the top left, from 0";
        return Err(ValueError::new("image", reason, help));
    }
    let plan = Plan::new(scene, Scope::CalledFor)?;
    let mut listener = Listener {
        plan: &plan,
        open: Vec::new(),
        rays: Vec::new(),
        sent: 0,
    };
    let place = [column, row].map(|place| place as usize);
    let tracer = Tracer::new(&plan);
    let color = pixel_color(tracer, scene, place[0], place[1], &mut listener);
    Ok(PixelStory {
        pixel: [column, row],
        color: color.channels(),
        rays: listener.rays,
    })
}

/// Writes down what the tracer does.
struct Listener<'p, 'a> {
    plan: &'p Plan<'a>,
    /// The rays that have set out and not come back, the first one first.
    open: Vec<Step>,
    /// The rays from the eye that have come back.
    rays: Vec<Step>,
    /// How many rays were sent to the light that is told of next.
    sent: u64,
}

impl Listener<'_, '_> {
    /// Notes something about the ray that set out last.
    fn note(&mut self, note: impl FnOnce(&mut Step)) {
        if let Some(step) = self.open.last_mut() {
            note(step);
        }
    }
}

impl Probe for Listener<'_, '_> {
    fn on(&mut self, event: Event<'_>) {
        match event {
            Event::Ray(kind, share) => self.ray(kind, share),
            Event::NotFollowed(kind, why) => self.not_followed(kind, why),
            Event::Hit(surface, hit, _) => self.met(surface, hit),
            Event::Light(light, arrival) => self.light(light, arrival),
            Event::OwnColor { color, of_lamps } => self.note(|step| {
                step.own = color.channels();
                step.of_lamps = of_lamps.channels();
            }),
            Event::OwnShare(share) => self.note(|step| {
                step.own = step.own.map(|own| own * share);
                step.of_lamps = step.of_lamps.map(|of_lamps| of_lamps * share);
            }),
            Event::Returned(color) => self.came_back(color),
            _ => {}
        }
    }
}

impl Listener<'_, '_> {
    fn ray(&mut self, kind: RayKind, share: Rgb) {
        if matches!(kind, RayKind::Shadow | RayKind::Lamp) {
            self.sent += 1;
            return;
        }
        self.open.push(Step {
            kind: word(kind),
            share: share.channels(),
            met: None,
            own: [0.0; 3],
            of_lamps: [0.0; 3],
            lights: Vec::new(),
            causes: Vec::new(),
            unfollowed: Vec::new(),
            brings: [0.0; 3],
        });
    }

    fn not_followed(&mut self, kind: RayKind, why: Unfollowed) {
        let why = match why {
            Unfollowed::BeyondReach => "the way from the eye is longer than `reach`".to_owned(),
            Unfollowed::TooFaint(missed) => {
                format!("it could add {missed:.1e} at most, and `cut-off` lets that go")
            }
            Unfollowed::Capped(missed) => {
                format!("a thousand rays are enough; it could have added up to {missed:.1e}")
            }
        };
        let kind = word(kind);
        self.note(|step| step.unfollowed.push(UnfollowedStep { kind, why }));
    }

    fn met(&mut self, surface: usize, hit: &Hit) {
        let scene = self.plan.scene;
        let cause = Cause::of_surface(&*scene.surfaces[surface]);
        let met = Met {
            surface: Thing::of(&cause, &scene.sources),
            distance: hit.t,
            place: hit.point.world().to_array(),
            texel: hit.texel.channels(),
            glows: scene.surfaces[surface].lamp().is_some(),
        };
        self.note(|step| step.met = Some(met));
    }

    fn light(&mut self, light: usize, arrival: Arrival) {
        let rays = std::mem::take(&mut self.sent);
        let scene = self.plan.scene;
        let cause = match light.checked_sub(scene.lights.len()) {
            Some(lamp) => match self.plan.lamps[lamp].view.lamp() {
                Some(lamp) => Cause::of_surface(lamp),
                None => return,
            },
            None => Cause::of_light(&scene.lights[light]),
        };
        let (arrives, share) = match arrival {
            Arrival::Light { color, .. } => (Some(color), None),
            Arrival::Lamp { color, passed } => {
                (Some(color).filter(|_| !passed.is_black()), Some(passed))
            }
            _ => (None, None),
        };
        let step = LightStep {
            light: Thing::of(&cause, &scene.sources),
            what: what(arrival, rays),
            arrives: arrives.map(Rgb::channels),
            share: share.map(Rgb::channels),
            rays,
        };
        self.note(|open| open.lights.push(step));
    }

    fn came_back(&mut self, color: Rgb) {
        let Some(mut step) = self.open.pop() else {
            return;
        };
        step.brings = color.channels();
        match self.open.last_mut() {
            Some(cause) => cause.causes.push(step),
            None => self.rays.push(step),
        }
    }
}

/// What became of a light's light, in words.
fn what(arrival: Arrival, rays: u64) -> String {
    let found_out = match rays {
        1 => "as a ray found out".to_owned(),
        rays => format!("as {rays} rays found out"),
    };
    let what = match arrival {
        Arrival::Unplanned => "cannot light this surface",
        Arrival::Here => "is in this very place, so that its light has no direction",
        Arrival::Behind => "behind the surface",
        Arrival::Colorless => "finds no diffuse colour here",
        Arrival::OutsideBeam => "its beam passes by",
        Arrival::Lamp { passed, .. } if rays == 0 && passed.is_black() => {
            "hidden; no ray was sent, for something hides all of it here"
        }
        Arrival::Light { unasked: true, .. } | Arrival::Lamp { .. } if rays == 0 => {
            "arrives; no ray was sent, for nothing can stand in its way here"
        }
        Arrival::Lamp { passed, .. } if passed.is_black() => return format!("hidden, {found_out}"),
        Arrival::Hidden => return format!("hidden, {found_out}"),
        Arrival::Light { .. } | Arrival::Lamp { .. } => return format!("arrives, {found_out}"),
    };
    what.to_owned()
}

fn word(kind: RayKind) -> &'static str {
    match kind {
        RayKind::Camera => "from the eye",
        RayKind::Shadow => "to a light",
        RayKind::Lamp => "to a lamp",
        RayKind::Mirror => "mirrored",
        RayKind::Transmitted => "transmitted",
    }
}
