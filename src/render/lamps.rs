//! The light of lamps.

use glam::{DVec2, DVec3};
use sobol_burley::sample;

use crate::accel::{Between, Casters, Entry, LampView};
use crate::math::{Point, Ray, RayOrigin, Rgb, Segment};
use crate::surface::Hit;

use super::{Arrival, Probe, RayKind, Seed, Tracer};

/// A place that lamps light.
#[derive(Debug)]
struct Lit<'a> {
    /// By which one, as onlookers are told.
    lamp: usize,
    ray_origin: &'a RayOrigin<'a>,
    point: Point,
    normal: DVec3,
    /// What the points of the lamp are chosen by that rays are sent to.
    seed: Seed,
}

impl Tracer<'_> {
    /// What a surface sends back along a ray because of lamps: its own light if it is one, and what
    /// it answers to that of others.
    ///
    /// `seed` tells apart the places that are seen in a picture, and depends on nothing else.
    // Never inlined, as the stack then holds its part for every mirror on the way.
    #[inline(never)]
    pub(super) fn lamplight(
        &self,
        ray: &Ray,
        entry: &Entry<'_>,
        ray_origin: &RayOrigin<'_>,
        hit: &Hit,
        seed: Seed,
        probe: &mut impl Probe,
    ) -> Rgb {
        if let Some(lamp) = self.plan.scene.surfaces[entry.index].lamp() {
            return lamp.shows(ray);
        }
        let diffuse = entry.surface.getdiff(hit);
        let mut color = Rgb::BLACK;
        let lights = self.plan.scene.lights.len();
        for (number, view) in self.plan.lamp_views.iter().enumerate() {
            let lamp = lights + number;
            if diffuse.is_black() {
                probe.light(lamp, Arrival::Colorless);
                continue;
            }
            if !view.lights(entry) {
                probe.light(lamp, Arrival::Unplanned);
                continue;
            }
            let arriving = view.lamp.form_factor(&hit.point, hit.normal);
            if arriving == 0.0 {
                probe.light(lamp, Arrival::Behind);
                continue;
            }
            let passed = if entry.common.shadows.receive {
                let lit = Lit {
                    lamp,
                    ray_origin,
                    point: hit.point,
                    normal: hit.normal,
                    seed: seed.of_lamp(number),
                };
                self.share_of_lamp(entry, view, &lit, probe)
            } else {
                Rgb::WHITE
            };
            let emissivity = view.lamp.emissivity();
            let arrival = Arrival::Lamp {
                color: emissivity * arriving * passed,
                passed,
            };
            probe.light(lamp, arrival);
            color = (color + diffuse * emissivity * arriving * passed).saturated();
        }
        color
    }

    /// The share of a lamp's light that passes what stands in its way.
    fn share_of_lamp(
        &self,
        entry: &Entry<'_>,
        view: &LampView<'_>,
        lit: &Lit<'_>,
        probe: &mut impl Probe,
    ) -> Rgb {
        let ray = Ray::spawn(lit.ray_origin, lit.normal);
        let casters = match view.between(entry, &ray, self.plan.camera.screen().is_none()) {
            Between::Nothing => return Rgb::WHITE,
            Between::Wall => return Rgb::BLACK,
            Between::Some(casters) => casters,
        };
        let (mut sent, mut passed) = (0.0, Rgb::BLACK);
        for at in places(view.lamp.samples(), lit.seed) {
            let (end, weight) = view.lamp.sample(&lit.point, lit.normal, at);
            if weight > 0.0 {
                sent += weight;
                passed += self.passing(&casters, lit, end, probe) * weight;
            }
        }
        // Where all passes, both are the same sum, and the share is 1 without rounding.
        if sent > 0.0 {
            passed / sent
        } else {
            // So little of the lamp is above the horizon that no sample is; its highest point is.
            self.passing(&casters, lit, view.lamp.highest(lit.normal), probe)
        }
    }

    /// The share of light that passes on the way to one point of a lamp.
    fn passing(
        &self,
        casters: &Casters<'_, '_>,
        lit: &Lit<'_>,
        end: Point,
        probe: &mut impl Probe,
    ) -> Rgb {
        let Some(mut segment) = Segment::new(lit.ray_origin, end) else {
            return Rgb::WHITE;
        };
        segment.screen = self.plan.camera.screen();
        probe.ray(RayKind::Lamp, Rgb::WHITE);
        let mut tests = 0;
        let passed = casters.transmittance(&segment, &mut tests);
        probe.occlusion_tests(lit.lamp, tests);
        passed
    }
}

/// Places in a square of side 1: a Sobol sequence, of which any two halves, quarters and so on are
/// spread evenly (Sobol 1967), scrambled by the seed (Owen 1995, as hashes by Burley 2020,
/// "Practical Hash-based Owen Scrambling"). Paths of one stream take their places in turn from one
/// sequence, so that all places together are spread evenly, too.
fn places(count: u32, seed: Seed) -> impl Iterator<Item = DVec2> {
    let first = u64::from(seed.number) * u64::from(count);
    (first..first + u64::from(count)).map(move |index| {
        // The sequence has 2^16 places; then another one begins.
        #[expect(
            clippy::cast_possible_truncation,
            reason = "the low and the other bits"
        )]
        let (index, sequence) = ((index & 0xFFFF) as u32, (index >> 16) as u32);
        #[expect(clippy::cast_possible_truncation, reason = "half of the bits do")]
        let seed = (seed.stream as u32).wrapping_add(sequence);
        DVec2::new(
            f64::from(sample(index, 0, seed)),
            f64::from(sample(index, 1, seed)),
        )
    })
}
