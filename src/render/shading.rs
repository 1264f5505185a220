//! What a surface sends back of the light that falls on it.

use crate::accel::{Entry, LightView};
use crate::light::Light;
use crate::math::{Departure, Ray, Rgb, Segment};
use crate::surface::Hit;

use super::{Probe, Tracer};

impl Tracer<'_> {
    /// What the surface itself sends back along a ray: ambient, and the light of every light.
    pub(super) fn local_color(
        &self,
        ray: &Ray,
        entry: &Entry<'_>,
        departure: &Departure<'_>,
        hit: &Hit,
        probe: &mut impl Probe,
    ) -> Rgb {
        let surface = entry.surface;
        let mut color = surface.getamb(hit);
        if self.plan.scene.lights.is_empty() {
            return color;
        }
        let diffuse = surface.getdiff(hit);
        for (light, view) in self.plan.scene.lights.iter().zip(&self.plan.light_views) {
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
            segment.span = self.plan.camera.span(&segment.ray);
            let Some(arriving) = self.arriving(entry, light, view, &segment, probe) else {
                continue;
            };
            let divisor = self.plan.scene.lighting.falloff.divisor(segment.length);
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
