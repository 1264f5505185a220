//! Ray packets: rays from one point in neighbouring directions.

use glam::DVec3;

use super::{Flat, Ray};

/// Rays from one point in free space, with directions between two vectors.
///
/// The directions are made unit after they are interpolated.
#[derive(Debug, Clone, Copy)]
pub struct RayPacket {
    /// A ray from the common origin, in any direction.
    pub ray: Ray<'static>,
    /// The two outermost directions, not made unit.
    pub ends: [DVec3; 2],
    /// The sum of all lengths that the directions are made of; no direction is longer.
    pub size: f64,
}

/// The rays of a packet that cross a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Crossings {
    /// No ray.
    Never,
    /// Every ray, ahead of the origin and beyond the screen, if there is one.
    Always,
    /// Undecided: each ray is tested by itself.
    Unknown,
}

/// The least ratio of a value to its error bound that decides for a whole packet.
///
/// Half of it would be enough. A larger ratio decides fewer packets.
const CLEARLY: f64 = 1_048_576.0;

/// The least ratio of plane and screen distance that decides for a whole packet.
///
/// It exceeds 1 by far more than the error of the distances, which [`CLEARLY`] bounds.
const BEYOND: f64 = 1.0 + 1.0 / 512.0;

impl Flat {
    /// Classifies the rays of a packet by whether they cross the plane.
    ///
    /// Crossings above a `screen` across the z axis do not count.
    #[must_use]
    pub fn crossings(&self, packet: &RayPacket, screen: Option<&Self>) -> Crossings {
        // For a direction w that is not made unit, n·w is linear. Along the packet it lies between
        // its values at the ends. If both have one sign and exceed a share of all lengths in them,
        // every ray rises or every ray falls, at no small angle, and rounded values decide.
        //
        // The distance to the plane, as a multiple of that to the screen, is a quotient of two such
        // values. Neither changes its sign, so the quotient is monotone and lies between its values
        // at the ends.
        let height = -self.normal.dot(packet.ray.origin.from(self.point));
        let is_clear = height.abs() > CLEARLY * (self.doubt + packet.ray.doubt);
        let slopes = packet.ends.map(|end| self.normal.dot(end));
        let steep = |slope: f64| CLEARLY * slope.abs() > packet.size;
        let is_decided = is_clear && slopes.iter().all(|slope| steep(*slope));
        if !is_decided || (slopes[0] > 0.0) != (slopes[1] > 0.0) {
            return Crossings::Unknown;
        }
        if (slopes[0] > 0.0) != (height > 0.0) {
            return Crossings::Never;
        }
        // The largest distance is finite.
        let mut counts = (2.0 * CLEARLY * height).is_finite();
        if let Some(screen) = screen {
            let above = packet.ray.origin.from(screen.point).z;
            counts &= above > 0.0;
            for (end, slope) in packet.ends.iter().zip(slopes) {
                let falls = -end.z;
                // The second is false for a direction that rises.
                counts &= steep(falls) && height.abs() * falls > BEYOND * (above * slope.abs());
            }
        }
        if !counts {
            return Crossings::Unknown;
        }
        Crossings::Always
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Limits, Point, direction, scramble};

    /// Numbers from −1 up to 1, the same on every run.
    fn numbers() -> impl FnMut() -> f64 {
        let mut drawn = 0;
        move || {
            drawn += 1;
            let bits = u32::try_from(scramble(drawn) >> 32).expect("32 bits");
            f64::from(bits) / f64::from(1u32 << 31) - 1.0
        }
    }

    #[test]
    fn what_is_decided_for_a_fan_is_what_each_of_its_rays_does() {
        let mut number = numbers();
        let mut vector = |size: f64| DVec3::new(number(), number(), number()) * size;
        let (mut always, mut never, mut unknown) = (0, 0, 0);
        for round in 0..40_000 {
            let eye = Point::exact(vector(3.0) + DVec3::Z * 4.0);
            let (mut first, mut across) = (vector(1.0) - DVec3::Z * 1.5, vector(0.2));
            let (mut point, normal) = (vector(2.0), vector(1.0));
            // Some eyes and some packets lie in the plane, up to rounding.
            let into_plane = |vector: DVec3| vector.reject_from(normal);
            if round % 8 == 1 {
                point = eye.world() + into_plane(point);
            }
            if round % 8 == 3 {
                (first, across) = (into_plane(first), into_plane(across));
            }
            let flat = Flat::new(point, normal).expect("a plane");
            let screen = Flat::with_unit_normal(vector(1.0), DVec3::Z);
            let screen = (round % 2 == 0).then_some(&screen);
            let way = |share: f64| first + across * share;
            let packet = RayPacket {
                ray: Ray::new(eye, DVec3::Z),
                ends: [way(0.0), way(1.0)],
                size: first.abs().element_sum() + across.abs().element_sum(),
            };
            let crossings = flat.crossings(&packet, screen);
            match crossings {
                Crossings::Always => always += 1,
                Crossings::Never => never += 1,
                Crossings::Unknown => unknown += 1,
            }
            for step in 0..=8 {
                let ray = Ray::new(eye, direction(way(f64::from(step) / 8.0)));
                let limits = screen.map_or(Limits::AHEAD, |screen| Limits::below(screen, &ray));
                let met = flat.hits(&ray, limits.span());
                let met = met.filter(|(t, error)| limits.hold(*t, *error, Some(&flat)));
                match crossings {
                    Crossings::Always => assert!(met.is_some(), "{flat:?} {packet:?}"),
                    Crossings::Never => assert_eq!(met, None, "{flat:?} {packet:?}"),
                    Crossings::Unknown => {}
                }
            }
        }
        assert!(always > 6000 && never > 6000, "{always} {never} {unknown}");
    }

    #[test]
    fn nothing_is_decided_by_how_far_ways_fall_that_is_made_of_rounding() {
        const STEP: f64 = 2.0 * crate::math::UNIT;
        // The heights are differences of numbers near 1, so they come in steps of 2⁻⁵².
        let way = |share: f64| DVec3::new(1.0 + share, 0.0, 1.0 - (1.0 + (1.0 + share) * STEP));
        let screen = Flat::with_unit_normal(DVec3::ZERO, DVec3::Z);
        let wall = Flat::with_unit_normal(DVec3::X, DVec3::X);
        let eye = Point::exact(DVec3::new(0.0, 0.0, STEP / 1.01));
        let counts = |share: f64| {
            let ray = Ray::new(eye, direction(way(share)));
            let limits = Limits::below(&screen, &ray);
            let met = wall.hits(&ray, limits.span());
            met.is_some_and(|(t, error)| limits.hold(t, error, Some(&wall)))
        };
        // The wall is beyond the screen for the directions at both ends, and not for those between.
        assert_eq!([0.0, 0.4, 1.0].map(counts), [true, false, true]);
        let packet = RayPacket {
            ray: Ray::new(eye, DVec3::Z),
            ends: [way(0.0), way(1.0)],
            size: 5.0,
        };
        assert_eq!(wall.crossings(&packet, Some(&screen)), Crossings::Unknown);
        assert_ne!(wall.crossings(&packet, None), Crossings::Unknown);
    }
}
