//! Rays of one pixel, one by one.

use serde::Serialize;
use serde_json::Value;

use super::aliases;
use super::scene_item::SceneItem;
use crate::geometry::Hit;
use crate::language::ValueError;
use crate::math::Rgb;
use crate::plan::{Cause, Plan, Scope};
use crate::render::{Arrival, Event, Probe, RayKind, Tracer, Unfollowed, pixel_color};
use crate::scene::Scene;

/// Rays of one pixel and its colour.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct PixelReport {
    /// Column and row, counted from the top left, from 0.
    pub(crate) pixel: [u32; 2],
    pub(crate) color: [f64; 3],
    /// Rays from the eye, of which the colour is the mean.
    pub(crate) rays: Vec<RayReport>,
}

/// A ray, its hit, and the rays that it causes.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct RayReport {
    pub(crate) kind: &'static str,
    /// Share of its colour that the surface at its origin passes on.
    pub(crate) share: [f64; 3],
    pub(crate) hit: Option<HitReport>,
    /// Colour of the surface by ambient light, lights and lamps, as far as it counts beside mirrored
    /// and transmitted rays.
    pub(crate) own: [f64; 3],
    /// Part of it that is light of lamps, or the surface's own emission if it is a lamp.
    pub(crate) of_lamps: [f64; 3],
    /// Lights, then lamps.
    pub(crate) lights: Vec<LightReport>,
    pub(crate) causes: Vec<Self>,
    pub(crate) unfollowed: Vec<UnfollowedRay>,
    /// Colour of the ray.
    pub(crate) brings: [f64; 3],
}

/// Hit of a ray.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct HitReport {
    pub(crate) surface: SceneItem,
    /// Distance from the origin of the ray.
    pub(crate) distance: f64,
    pub(crate) place: [f64; 3],
    /// Colour of the texture there; white without one.
    pub(crate) texel: [f64; 3],
    /// True if the surface is a lamp.
    pub(crate) glows: bool,
}

/// A light or lamp at a hit.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct LightReport {
    pub(crate) light: SceneItem,
    /// Arrival or its obstacle in words.
    pub(crate) what: String,
    /// Light that arrives, of a light before angle and distance; `None` if nothing does.
    pub(crate) arrives: Option<[f64; 3]>,
    /// Transmittance of the way to a lamp; `None` for a light, and for a lamp that does not shine
    /// here.
    pub(crate) share: Option<[f64; 3]>,
    /// Shadow rays sent to it.
    pub(crate) rays: u64,
}

/// A ray that is not followed.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct UnfollowedRay {
    pub(crate) kind: &'static str,
    pub(crate) why: String,
}

impl PixelReport {
    /// The report as JSON, with former names of keys beside the current ones.
    pub(crate) fn json(&self) -> Value {
        aliases::json(self)
    }
}

/// Traces the pixel in a column and a row, counted from the top left, from 0.
///
/// # Errors
/// Refuses a camera that cannot exist, and a pixel outside of the picture.
pub(crate) fn transcript(
    scene: &Scene,
    [column, row]: [u32; 2],
) -> Result<PixelReport, ValueError> {
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
    Ok(PixelReport {
        pixel: [column, row],
        color: color.channels(),
        rays: listener.rays,
    })
}

/// Records rays as they are traced.
struct Listener<'p, 'a> {
    plan: &'p Plan<'a>,
    /// Rays without a colour yet, the outermost first.
    open: Vec<RayReport>,
    /// Finished rays from the eye.
    rays: Vec<RayReport>,
    /// Shadow rays sent to the light that is reported next.
    sent: u64,
}

impl Listener<'_, '_> {
    /// Changes the innermost open ray.
    fn note(&mut self, note: impl FnOnce(&mut RayReport)) {
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
            Event::Hit(surface, hit, _) => self.hit(surface, hit),
            Event::Light(light, arrival) => self.light(light, arrival),
            Event::OwnColor { color, of_lamps } => self.note(|ray| {
                ray.own = color.channels();
                ray.of_lamps = of_lamps.channels();
            }),
            Event::OwnShare(share) => self.note(|ray| {
                ray.own = ray.own.map(|own| own * share);
                ray.of_lamps = ray.of_lamps.map(|of_lamps| of_lamps * share);
            }),
            Event::Returned(color) => self.returned(color),
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
        self.open.push(RayReport {
            kind: word(kind),
            share: share.channels(),
            hit: None,
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
            Unfollowed::BeyondReach => "its path from the eye is longer than `reach`".to_owned(),
            Unfollowed::TooFaint(missed) => {
                format!("it adds at most {missed:.1e}, less than `cut-off` permits to lack")
            }
            Unfollowed::Capped(missed) => {
                format!("the limit of 1000 rays is reached; it adds at most {missed:.1e}")
            }
        };
        let kind = word(kind);
        self.note(|ray| ray.unfollowed.push(UnfollowedRay { kind, why }));
    }

    fn hit(&mut self, surface: usize, hit: &Hit) {
        let scene = self.plan.scene;
        let cause = Cause::of_surface(&*scene.surfaces[surface]);
        let report = HitReport {
            surface: SceneItem::of(&cause, &scene.sources),
            distance: hit.t,
            place: hit.point.world().to_array(),
            texel: hit.texel.channels(),
            glows: scene.surfaces[surface].lamp().is_some(),
        };
        self.note(|ray| ray.hit = Some(report));
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
        let report = LightReport {
            light: SceneItem::of(&cause, &scene.sources),
            what: what(arrival, rays),
            arrives: arrives.map(Rgb::channels),
            share: share.map(Rgb::channels),
            rays,
        };
        self.note(|ray| ray.lights.push(report));
    }

    fn returned(&mut self, color: Rgb) {
        let Some(mut ray) = self.open.pop() else {
            return;
        };
        ray.brings = color.channels();
        match self.open.last_mut() {
            Some(cause) => cause.causes.push(ray),
            None => self.rays.push(ray),
        }
    }
}

/// Arrival of a light or its obstacle, in words.
fn what(arrival: Arrival, rays: u64) -> String {
    let what = match arrival {
        Arrival::Unplanned => "cannot light this surface",
        Arrival::Here => "is at this very point, so that its light has no direction",
        Arrival::Behind => "is behind the surface",
        Arrival::Colorless => "finds no diffuse colour here",
        Arrival::OutsideBeam => "shines past this point",
        Arrival::Lamp { passed, .. } if rays == 0 && passed.is_black() => {
            "is hidden; no ray needed, an occluder covers all of it"
        }
        Arrival::Light { unasked: true, .. } | Arrival::Lamp { .. } if rays == 0 => {
            "arrives; no ray needed, nothing can block it here"
        }
        Arrival::Lamp { passed, .. } if passed.is_black() => "is hidden",
        Arrival::Hidden => "is hidden",
        Arrival::Light { .. } | Arrival::Lamp { .. } => "arrives",
    };
    match rays {
        0 => what.to_owned(),
        1 => format!("{what}; tested with 1 ray"),
        rays => format!("{what}; tested with {rays} rays"),
    }
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
