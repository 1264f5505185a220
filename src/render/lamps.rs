//! The light of lamps.

use glam::DVec2;
use sobol_burley::sample;

use crate::math::{Point, Ray, Rgb, Segment};
use crate::surface::Lamp;
use crate::visibility::{Occluders, Occlusion, Receiver};

use super::tracer::Interaction;
use super::{Arrival, Event, Probe, RayKind, Seed, Tracer};

impl Tracer<'_> {
    /// The colour of a surface from lamps: its emission, or reflected light.
    // Never inlined, because the recursion would hold its stack frame for every reflection.
    #[inline(never)]
    pub(super) fn lamplight(&self, at: &Interaction<'_, '_>, probe: &mut impl Probe) -> Rgb {
        let Interaction { primitive, hit, .. } = *at;
        if let Some(lamp) = primitive.surface.lamp() {
            return lamp.shows(at.ray);
        }
        let diffuse = primitive.surface.getdiff(hit);
        let mut color = Rgb::BLACK;
        let lights = self.plan.scene.lights.len();
        for (number, planned) in self.plan.lamps.iter().enumerate() {
            let (index, view) = (lights + number, &planned.view);
            let Some(lamp) = view.lamp() else { continue };
            if diffuse.is_black() {
                probe.on(Event::Light(index, Arrival::Colorless));
                continue;
            }
            let Some(receiver) = view.receiver(primitive) else {
                probe.on(Event::Light(index, Arrival::Unplanned));
                continue;
            };
            let arriving = lamp.form_factor(&hit.point, hit.normal);
            if arriving == 0.0 {
                probe.on(Event::Light(index, Arrival::Behind));
                continue;
            }
            let passed = if receiver.is_shadowed() {
                let seed = at.path.seed.of_lamp(number);
                self.share_of_lamp(at, receiver, LampSamples { lamp, index, seed }, probe)
            } else {
                Rgb::WHITE
            };
            let emissivity = lamp.emissivity();
            let arrival = Arrival::Lamp {
                color: emissivity * arriving * passed,
                passed,
            };
            probe.on(Event::Light(index, arrival));
            color = (color + diffuse * emissivity * arriving * passed).saturated();
        }
        color
    }

    /// The share of a lamp's light that passes the occluders in front of it.
    fn share_of_lamp(
        &self,
        at: &Interaction<'_, '_>,
        receiver: Receiver<'_, '_>,
        samples: LampSamples<'_>,
        probe: &mut impl Probe,
    ) -> Rgb {
        let LampSamples { lamp, index, seed } = samples;
        let (point, normal) = (&at.hit.point, at.hit.normal);
        let ray = Ray::spawn(at.ray_origin, normal);
        let occluders = match receiver.occlusion(at.hit, &ray) {
            Occlusion::None => return Rgb::WHITE,
            Occlusion::Full => return Rgb::BLACK,
            Occlusion::Partial(occluders) => occluders,
        };
        let (mut sent, mut passed) = (0.0, Rgb::BLACK);
        for place in places(lamp.samples(), seed) {
            let (end, weight) = lamp.sample(point, normal, place);
            if weight > 0.0 {
                sent += weight;
                passed += self.passing(at, &occluders, (index, end), probe) * weight;
            }
        }
        // If all passes, both are the same sum, and the share is 1 without rounding.
        if sent > 0.0 {
            passed / sent
        } else {
            // No sample is above the horizon, but the lamp's highest point is.
            self.passing(at, &occluders, (index, lamp.highest(normal)), probe)
        }
    }

    /// The transmittance on the segment to a point of a lamp.
    fn passing(
        &self,
        at: &Interaction<'_, '_>,
        occluders: &Occluders<'_, '_>,
        (lamp, end): (usize, Point),
        probe: &mut impl Probe,
    ) -> Rgb {
        let Some(mut segment) = Segment::new(at.ray_origin, end) else {
            return Rgb::WHITE;
        };
        segment.screen = self.plan.camera.screen();
        probe.on(Event::Ray(RayKind::Lamp, Rgb::WHITE));
        let mut tests = 0;
        let passed = occluders.transmittance(&segment, &mut tests);
        probe.on(Event::OcclusionTests(lamp, tests));
        passed
    }
}

/// The points of a lamp that shadow rays go to.
#[derive(Debug, Clone, Copy)]
struct LampSamples<'a> {
    lamp: &'a Lamp,
    /// The lamp's number in events.
    index: usize,
    /// The seed that chooses the points.
    seed: Seed,
}

/// Points in the unit square: a Sobol sequence (Sobol 1967), scrambled by the seed.
///
/// Its halves, quarters and so on are well distributed. The scrambling is Owen's (1995), computed
/// by hashes (Burley 2020, "Practical Hash-based Owen Scrambling"). Paths of one stream take
/// consecutive points of one sequence, so the points of all paths together are well distributed,
/// too.
fn places(count: u32, seed: Seed) -> impl Iterator<Item = DVec2> {
    let first = u64::from(seed.number) * u64::from(count);
    (first..first + u64::from(count)).map(move |index| {
        // The sequence has 2^16 points; then another one begins.
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
