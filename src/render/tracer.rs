//! The colour along one ray.

use crate::accel::{Accelerator, Entry, LightView, Sight, SurfaceList};
use crate::camera::Camera;
use crate::language::Refusal;
use crate::light::Light;
use crate::math::{Departure, Ray, Rgb, Segment};
use crate::scene::Scene;
use crate::surface::{Hit, Surface};

use super::{Errors, Probe};

/// The most mirrored and transmitted rays that one ray from the eye may cause.
///
/// Two facing perfect mirrors would go on for ever; smaller, and long rows of mirror images end
/// too early; larger, and a path needs more stack than a thread has.
const MOST_BOUNCES: u32 = 1000;

/// A scene made ready for tracing.
#[derive(Debug)]
pub struct Tracer<'a> {
    scene: &'a Scene,
    camera: Camera,
    surfaces: SurfaceList<'a>,
    /// What the camera sees where; `None` if the numerics cannot prove that it does not see more, or if a
    /// tree knows better.
    sight: Option<Sight<'a>>,
    /// What each light has before it, in the order of the scene's lights.
    light_views: Vec<LightView<'a>>,
}

/// How a ray came to be where it is.
#[derive(Debug)]
struct Path {
    /// Distance from the eye to the ray's origin, along all mirrors.
    travelled: f64,
    /// The largest share of the ray's colour that reaches the pixel.
    weight: f64,
    /// What rounding may have done to it.
    errors: Errors,
}

impl<'a> Tracer<'a> {
    /// A tracer for this scene; `classic` are its surfaces made for other numerics than their own,
    /// if the scene asks for that ([`crate::surface::classic::surfaces`]).
    ///
    /// # Errors
    /// Refuses a camera that cannot exist.
    pub fn new(
        scene: &'a Scene,
        classic: Option<&'a [Box<dyn Surface + 'a>]>,
    ) -> Result<Self, Refusal> {
        let camera = scene
            .view
            .camera(scene.picture.width, scene.picture.height)?;
        let surfaces = match classic {
            None => SurfaceList::new(&scene.surfaces),
            Some(classic) => SurfaceList::without_sheets(classic),
        };
        let lights = scene.lights.iter().map(|light| light.location);
        let all_asked = surfaces.accelerator() == Accelerator::List;
        let sight = (classic.is_none() && all_asked).then(|| Sight::new(&surfaces, &camera));
        Ok(Self {
            scene,
            camera,
            sight,
            light_views: LightView::all(&surfaces, lights),
            surfaces,
        })
    }

    /// The colour at a place of the picture, counted in pixels from the lower-left pixel's centre.
    pub fn sees(&self, x: f64, y: f64, probe: &mut impl Probe) -> Rgb {
        probe.camera_ray();
        let mut bounces = MOST_BOUNCES;
        let path = Path {
            travelled: 0.0,
            weight: 1.0,
            errors: Errors::default(),
        };
        let (ray, mut tests) = (self.camera.ray(x, y), 0);
        let span = self.camera.span(&ray);
        let met = match &self.sight {
            Some(sight) => sight.nearest([x, y], &ray, span, &mut tests),
            None => self.surfaces.nearest(&ray, span, &mut tests),
        };
        probe.hit_tests(tests);
        let color = self.color_of(met, &ray, &path, &mut bounces, probe);
        // Adding zero turns −0 into +0, which is the same colour.
        color + Rgb::BLACK
    }

    /// The colour that comes back along a ray; black where there is nothing.
    fn trace(&self, ray: &Ray, path: &Path, bounces: &mut u32, probe: &mut impl Probe) -> Rgb {
        let mut tests = 0;
        let span = self.camera.span(ray);
        let met = self.surfaces.nearest(ray, span, &mut tests);
        probe.hit_tests(tests);
        self.color_of(met, ray, path, bounces, probe)
    }

    /// The colour that comes back along a ray from what it met.
    fn color_of(
        &self,
        met: Option<(&Entry<'a>, Hit)>,
        ray: &Ray,
        path: &Path,
        bounces: &mut u32,
        probe: &mut impl Probe,
    ) -> Rgb {
        let Some((entry, hit)) = met else {
            return Rgb::BLACK;
        };
        let errors = path.errors.at(&hit);
        probe.hit(errors);
        let surface = entry.surface;
        let departure = Departure::new(entry.sheet(), ray, hit.point, hit.error);
        let travelled = path.travelled + hit.t;
        let local = self.local_color(ray, entry, &departure, &hit, probe);
        let divisor = self.scene.lighting.view_falloff.divisor(travelled);
        let mut color = (local / divisor).saturated();

        let material = &surface.common().material;
        let mut follow = |share: Rgb, dir, probe: &mut _, count: fn(&mut _)| {
            let path = Path {
                travelled,
                weight: path.weight * share.max_channel(),
                errors: errors.behind(surface),
            };
            let spent = path.weight <= self.scene.picture.cut_off
                || travelled > self.scene.lighting.reach
                || *bounces == 0;
            if spent {
                return Rgb::BLACK;
            }
            *bounces -= 1;
            count(probe);
            let next = Ray::leaving(&departure, dir);
            share * self.trace(&next, &path, bounces, probe)
        };
        if material.transparency > 0.0 {
            let through = follow(
                surface.transmits(&hit),
                ray.dir,
                probe,
                Probe::transmitted_ray,
            );
            color = (color * (1.0 - material.transparency) + through).saturated();
        }
        if !material.specular.is_black() {
            let direction = ray.mirrored(hit.normal);
            let mirrored = follow(material.specular, direction, probe, Probe::mirror_ray);
            color = (color + mirrored).saturated();
        }
        color
    }

    /// What the surface itself sends back along a ray: ambient, and the light of every light.
    fn local_color(
        &self,
        ray: &Ray,
        entry: &Entry<'_>,
        departure: &Departure<'_>,
        hit: &Hit,
        probe: &mut impl Probe,
    ) -> Rgb {
        let surface = entry.surface;
        let mut color = surface.getamb(hit);
        if self.scene.lights.is_empty() {
            return color;
        }
        let diffuse = surface.getdiff(hit);
        for (light, view) in self.scene.lights.iter().zip(&self.light_views) {
            if !view.lights(entry) {
                continue;
            }
            let Some(mut segment) = Segment::new(departure, light.location) else {
                continue;
            };
            let cosine = segment.ray.dir.dot(hit.normal);
            if cosine <= 0.0 {
                // The surface hides itself.
                continue;
            }
            segment.span = self.camera.span(&segment.ray);
            let Some(arriving) = self.arriving(entry, light, view, &segment, probe) else {
                continue;
            };
            let divisor = self.scene.lighting.falloff.divisor(segment.length);
            color = (color + diffuse * arriving * (cosine / divisor)).saturated();

            let material = &surface.common().material;
            if material.shininess > 0.0 {
                // Halfway between the directions to the eye and to the light (Blinn 1977,
                // "Models of light reflection for computer synthesized pictures").
                let halfway = (segment.ray.dir - ray.dir).normalize_or_zero();
                let alignment = halfway.dot(hit.normal).clamp(0.0, 1.0);
                let glint = libm::pow(alignment, material.shininess);
                color = (color + arriving * material.specular * glint).saturated();
            }
        }
        color
    }

    /// The light of a light that arrives at the start of a segment to it; `None` if the beam
    /// passes by or something stands in the way.
    fn arriving(
        &self,
        entry: &Entry<'_>,
        light: &Light,
        view: &LightView<'_>,
        segment: &Segment,
        probe: &mut impl Probe,
    ) -> Option<Rgb> {
        let leaving = light.towards(segment)?;
        if !entry.surface.common().shadows.receive {
            return Some(leaving);
        }
        probe.shadow_ray();
        let mut tests = 0;
        let passed = view.transmittance(entry, segment, &mut tests);
        probe.occlusion_tests(tests);
        (!passed.is_black()).then(|| leaving * passed)
    }
}
