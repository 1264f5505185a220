//! What a surface sends back of the light that falls on it.

use crate::accel::{Before, Entry};
use crate::light::Light;
use crate::math::{Ray, RayOrigin, Rgb, Segment};
use crate::plan::Scope;
use crate::surface::Hit;

use super::{Arrival, Probe, RayKind, Seed, Tracer};

impl Tracer<'_> {
    /// What the surface itself sends back along a ray, faded by a divisor: ambient, and the light of
    /// every light and lamp.
    // Never inlined, as the stack then holds its part for every mirror on the way.
    #[inline(never)]
    pub(super) fn own_color(
        &self,
        ray: &Ray,
        (entry, hit): (&Entry<'_>, &Hit),
        (ray_origin, divisor, seed): (&RayOrigin<'_>, f64, Seed),
        probe: &mut impl Probe,
    ) -> Rgb {
        let mut color = self.color_of_lights(ray, (entry, hit), ray_origin, probe);
        let mut of_lamps = Rgb::BLACK;
        if !self.plan.lamp_views.is_empty() {
            of_lamps = self.lamplight(ray, entry, ray_origin, hit, seed, probe);
            color = (color + of_lamps).saturated();
        }
        color = (color / divisor).saturated();
        probe.own_color(color, of_lamps / divisor);
        color
    }

    /// What the surface itself sends back along a ray: ambient, and the light of every light.
    #[inline(always)]
    fn color_of_lights(
        &self,
        ray: &Ray,
        (entry, hit): (&Entry<'_>, &Hit),
        ray_origin: &RayOrigin<'_>,
        probe: &mut impl Probe,
    ) -> Rgb {
        let surface = entry.surface;
        // A sum, which is kept where sums are made, and not where the answer was written.
        let mut color = surface.getamb(hit) + Rgb::BLACK;
        if self.plan.scene.lights.is_empty() {
            return color;
        }
        let diffuse = surface.getdiff(hit);
        let lights = self.plan.scene.lights.iter().zip(&self.plan.light_views);
        for (index, (light, view)) in lights.enumerate() {
            let Some(before) = view.before(entry) else {
                probe.light(index, Arrival::Unplanned);
                continue;
            };
            let Some(segment) = Segment::new(ray_origin, light.location) else {
                probe.light(index, Arrival::Here);
                continue;
            };
            let cosine = segment.ray.dir.dot(hit.normal);
            if cosine <= 0.0 {
                probe.light(index, Arrival::Behind);
                continue;
            }
            let arrival = self.arrival((entry, hit), (index, light), &before, &segment, probe);
            probe.light(index, arrival);
            let Arrival::Light {
                color: arriving, ..
            } = arrival
            else {
                continue;
            };
            let divisor = self.plan.scene.lighting.falloff.divisor(segment.length);
            color = (color + diffuse * arriving * (cosine / divisor)).saturated();

            let material = &entry.common.material;
            let everything = self.plan.scope == Scope::Everything;
            if material.has_highlights() || everything && material.shininess > 0.0 {
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

    /// What arrives from a light at the start of a segment to it.
    #[inline(always)]
    fn arrival(
        &self,
        (entry, hit): (&Entry<'_>, &Hit),
        (index, light): (usize, &Light),
        before: &Before<'_, '_>,
        segment: &Segment,
        probe: &mut impl Probe,
    ) -> Arrival {
        let Some(spawn) = light.incident(segment.ray.dir) else {
            return Arrival::OutsideBeam;
        };
        let receives = entry.common.shadows.receive;
        let blockers = receives.then(|| before.blockers(hit, &segment.ray));
        let Some(blockers) = blockers.flatten() else {
            return Arrival::Light {
                color: spawn,
                unasked: true,
            };
        };
        probe.ray(RayKind::Shadow, Rgb::WHITE);
        let segment = Segment {
            screen: self.plan.camera.screen(),
            ..*segment
        };
        let mut tests = 0;
        let passed = blockers.transmittance(&segment, &mut tests);
        probe.occlusion_tests(index, tests);
        if passed.is_black() {
            return Arrival::Hidden;
        }
        Arrival::Light {
            color: spawn * passed,
            unasked: false,
        }
    }
}
