//! The light that a surface reflects diffusely, and the specular highlights of lights.

use crate::geometry::Hit;
use crate::light::Light;
use crate::math::{Rgb, Segment};
use crate::plan::Scope;
use crate::visibility::{Occlusion, Receiver};

use super::tracer::Interaction;
use super::{Arrival, Event, Probe, RayKind, Tracer};

impl Tracer<'_> {
    /// The surface's own colour, faded: ambient, and the light of every light and lamp.
    // Never inlined, because the recursion would hold its stack frame for every reflection.
    #[inline(never)]
    pub(super) fn own_color(&self, at: &Interaction<'_, '_>, probe: &mut impl Probe) -> Rgb {
        let mut color = self.color_of_lights(at, probe);
        let mut of_lamps = Rgb::BLACK;
        if !self.plan.lamps.is_empty() {
            of_lamps = self.lamplight(at, probe);
            color = (color + of_lamps).saturated();
        }
        let color = (color / at.divisor).saturated();
        let of_lamps = of_lamps / at.divisor;
        probe.on(Event::OwnColor { color, of_lamps });
        color
    }

    /// The ambient colour, and the light of every point light.
    #[inline(always)]
    fn color_of_lights(&self, at: &Interaction<'_, '_>, probe: &mut impl Probe) -> Rgb {
        let Interaction { primitive, hit, .. } = *at;
        // A sum stays in registers, while the result of a virtual call is in memory.
        let mut color = primitive.surface.getamb(hit) + Rgb::BLACK;
        if self.plan.scene.lights.is_empty() {
            return color;
        }
        let diffuse = primitive.surface.getdiff(hit);
        let lights = self.plan.scene.lights.iter().zip(&self.plan.lights);
        for (index, (light, planned)) in lights.enumerate() {
            let Some(receiver) = planned.view.receiver(primitive) else {
                probe.on(Event::Light(index, Arrival::Unplanned));
                continue;
            };
            let Some(segment) = Segment::new(at.ray_origin, light.location) else {
                probe.on(Event::Light(index, Arrival::Here));
                continue;
            };
            let cosine = segment.ray.dir.dot(hit.normal);
            if cosine <= 0.0 {
                probe.on(Event::Light(index, Arrival::Behind));
                continue;
            }
            let arrival = self.arrival(at.hit, (index, light), receiver, &segment, probe);
            probe.on(Event::Light(index, arrival));
            let Arrival::Light {
                color: arriving, ..
            } = arrival
            else {
                continue;
            };
            let divisor = self.plan.scene.lighting.falloff.divisor(segment.length);
            color = (color + diffuse * arriving * (cosine / divisor)).saturated();

            let material = &primitive.common.material;
            let everything = self.plan.scope == Scope::Everything;
            if material.has_highlights() || everything && material.shininess > 0.0 {
                // Halfway between the directions to the eye and to the light (Blinn 1977,
                // "Models of light reflection for computer synthesized pictures").
                let halfway = (segment.ray.dir - at.ray.dir).normalize_or_zero();
                let alignment = halfway.dot(hit.normal).clamp(0.0, 1.0);
                let highlight = libm::pow(alignment, material.shininess);
                color = (color + arriving * material.specular * highlight).saturated();
            }
        }
        color
    }

    /// The light that arrives from a light at the start of a segment to it.
    #[inline(always)]
    fn arrival(
        &self,
        hit: &Hit,
        (index, light): (usize, &Light),
        receiver: Receiver<'_, '_>,
        segment: &Segment,
        probe: &mut impl Probe,
    ) -> Arrival {
        let Some(leaving) = light.incident(segment.ray.dir) else {
            return Arrival::OutsideBeam;
        };
        let occlusion = if receiver.is_shadowed() {
            receiver.occlusion(hit, &segment.ray)
        } else {
            Occlusion::None
        };
        let passed = match occlusion {
            Occlusion::None => {
                return Arrival::Light {
                    color: leaving,
                    unasked: true,
                };
            }
            Occlusion::Full => Rgb::BLACK,
            Occlusion::Partial(occluders) => {
                probe.on(Event::Ray(RayKind::Shadow, Rgb::WHITE));
                let mut tests = 0;
                let segment = Segment {
                    screen: self.plan.camera.screen(),
                    ..*segment
                };
                let passed = occluders.transmittance(&segment, &mut tests);
                probe.on(Event::OcclusionTests(index, tests));
                passed
            }
        };
        if passed.is_black() {
            return Arrival::Hidden;
        }
        Arrival::Light {
            color: leaving * passed,
            unasked: false,
        }
    }
}
