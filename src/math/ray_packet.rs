//! Many rays from one point to neighbouring places.

use glam::DVec3;

use super::{Flat, Ray};

/// Rays from a point in free space whose directions lie on a straight line between two, before they
/// are made unit.
#[derive(Debug, Clone, Copy)]
pub struct RayPacket {
    /// One of them, in any direction.
    pub ray: Ray<'static>,
    /// The outermost directions, not made unit.
    pub ends: [DVec3; 2],
    /// The sum of all lengths that the directions are made of; none of them is longer.
    pub size: f64,
}

/// Where the rays of a fan cross a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Crossings {
    /// Nowhere.
    Never,
    /// All do, ahead and beyond the screen, if there is one.
    Always,
    /// Each has to be asked.
    Unknown,
}

/// How many times a value has to be larger than what puts it in doubt, for a whole fan to be decided by
/// it at once; half as many are enough. Smaller, and roundings would matter; larger, and fewer fans are
/// decided.
const CLEARLY: f64 = 1_048_576.0;

/// How much further than a limit all rays of a fan have to cross a plane to be decided at once: by far
/// more than the distances can be off by, which `CLEARLY` sees to.
const BEYOND: f64 = 1.0 + 1.0 / 512.0;

impl Flat {
    /// Where the rays of a fan cross the plane; what is not below a `screen` across the z axis does not
    /// count.
    ///
    /// For a direction `w` that is not made unit, `n·w` is linear, so along the fan it lies between its
    /// values at the ends. If both have one sign and are no smaller than a share of all that went into
    /// them, then every ray rises, or every ray falls, at no small angle, and rounded values are enough.
    ///
    /// The way to the plane, as a multiple of that to the screen, is a quotient of two such linear
    /// values, neither of which changes its sign; so it is monotone along the fan, and lies between its
    /// values at the ends, too.
    #[must_use]
    pub fn crossings(&self, fan: &RayPacket, screen: Option<&Self>) -> Crossings {
        let height = -self.normal.dot(fan.ray.origin.from(self.point));
        let is_clear = height.abs() > CLEARLY * (self.doubt + fan.ray.doubt);
        let slopes = fan.ends.map(|way| self.normal.dot(way));
        let steep = |slope: f64| CLEARLY * slope.abs() > fan.size;
        let is_decided = is_clear && slopes.iter().all(|slope| steep(*slope));
        if !is_decided || (slopes[0] > 0.0) != (slopes[1] > 0.0) {
            return Crossings::Unknown;
        }
        if (slopes[0] > 0.0) != (height > 0.0) {
            return Crossings::Never;
        }
        // No distance is too large for a number.
        let mut counts = (2.0 * CLEARLY * height).is_finite();
        if let Some(screen) = screen {
            let above = fan.ray.origin.from(screen.point).z;
            counts &= above > 0.0;
            for (way, slope) in fan.ends.iter().zip(slopes) {
                let falls = -way.z;
                // The second is false of a way that rises, too.
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
            // Some eyes and some fans lie in the plane, but for rounding.
            let into_plane = |way: DVec3| way.reject_from(normal);
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
            let fan = RayPacket {
                ray: Ray::new(eye, DVec3::Z),
                ends: [way(0.0), way(1.0)],
                size: first.abs().element_sum() + across.abs().element_sum(),
            };
            let crossings = flat.crossings(&fan, screen);
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
                    Crossings::Always => assert!(met.is_some(), "{flat:?} {fan:?}"),
                    Crossings::Never => assert_eq!(met, None, "{flat:?} {fan:?}"),
                    Crossings::Unknown => {}
                }
            }
        }
        assert!(always > 6000 && never > 6000, "{always} {never} {unknown}");
    }

    #[test]
    fn nothing_is_decided_by_how_far_ways_fall_that_is_made_of_rounding() {
        const STEP: f64 = 2.0 * crate::math::UNIT;
        // Their heights are differences of numbers near 1, so they come in steps of 2⁻⁵².
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
        // Seen from both ends the wall is beyond the screen, and in between it is not.
        assert_eq!([0.0, 0.4, 1.0].map(counts), [true, false, true]);
        let fan = RayPacket {
            ray: Ray::new(eye, DVec3::Z),
            ends: [way(0.0), way(1.0)],
            size: 5.0,
        };
        assert_eq!(wall.crossings(&fan, Some(&screen)), Crossings::Unknown);
        assert_ne!(wall.crossings(&fan, None), Crossings::Unknown);
    }
}
