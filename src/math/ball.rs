//! Bounding spheres, and the cones that certainly miss them.

use glam::DVec3;

use super::error_bounds::{APART, POSITION};
use super::{Bounds, Point};

/// A bounding sphere; its contents may lie outside by a few roundings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    center: DVec3,
    radius: f64,
}

impl Ball {
    /// The sphere through the corners of a box.
    #[must_use]
    pub fn around(bounds: &Bounds) -> Self {
        let center = bounds.min.midpoint(bounds.max);
        Self {
            center,
            radius: (bounds.max - center).length(),
        }
    }

    /// The radius.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The narrowest cone around it from an apex: unit axis, half-angle in radians.
    ///
    /// `None` if the apex is so near that the angle changes fast or that rounding counts.
    #[must_use]
    pub fn cone_from(&self, place: DVec3) -> Option<(DVec3, f64)> {
        let way = self.center - place;
        let distance = way.length();
        let is_clear = self.radius < 0.9 * distance && is_clear(self.center, place, distance);
        is_clear.then(|| (way / distance, libm::asin(self.radius / distance)))
    }

    /// Returns whether the sphere certainly lies outside of a cone.
    ///
    /// The axis is a unit vector, the half-angle is in radians.
    #[must_use]
    pub fn is_outside(&self, top: DVec3, axis: DVec3, half_angle: f64) -> bool {
        self.cone_from(top).is_some_and(|(direction, own)| {
            let cosine = axis.dot(direction).clamp(-1.0, 1.0);
            libm::acos(cosine) - own > half_angle + APART
        })
    }

    /// Returns whether rounding leaves the two spheres' cones from `place` apart.
    ///
    /// The rounding of a segment from the other sphere is that of its whole length.
    #[must_use]
    pub fn is_told_from(&self, place: DVec3, other: &Self) -> bool {
        is_clear(other.center, place, (self.center - place).length())
    }
}

/// Returns whether rounding turns the vector between two points by ≤ `APART` / 16.
#[must_use]
pub fn is_clear(a: DVec3, b: DVec3, distance: f64) -> bool {
    let size = Point::exact(a).size() + Point::exact(b).size();
    POSITION * size < APART / 16.0 * distance
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ball(center: DVec3, radius: f64) -> Ball {
        Ball { center, radius }
    }

    #[test]
    fn a_ball_beside_a_cone_is_outside_and_one_that_touches_it_is_not() {
        let angle = 0.25_f64;
        // The centre is 45° off the axis; a touching sphere fills the remaining angle.
        let center = DVec3::new(1.0, 0.0, 1.0) * 3.0;
        let touching = center.length() * libm::sin(std::f64::consts::FRAC_PI_4 - angle);
        let is_outside = |radius| ball(center, radius).is_outside(DVec3::ZERO, DVec3::Z, angle);
        assert!(is_outside(touching * 0.99999));
        assert!(!is_outside(touching));
        // Within the margin it is undecided.
        assert!(!is_outside(touching * (1.0 - 1e-7)));
    }

    #[test]
    fn nothing_is_said_of_what_is_near_or_lost_in_rounding() {
        let is_outside = |center, top| ball(center, 1.0).is_outside(top, DVec3::NEG_Z, 0.1);
        assert!(is_outside(DVec3::new(0.0, 0.0, 2.0), DVec3::ZERO));
        assert!(!is_outside(DVec3::new(0.0, 0.0, 1.1), DVec3::ZERO));
        let far = DVec3::new(1e10, 0.0, 0.0);
        assert!(!is_outside(far + DVec3::new(0.0, 0.0, 2.0), far));
    }

    #[test]
    fn the_box_of_a_ball_has_its_corners_on_it() {
        let bounds = Bounds {
            min: DVec3::new(0.0, 0.0, 0.0),
            max: DVec3::new(2.0, 4.0, 4.0),
        };
        let around = ball(DVec3::new(1.0, 2.0, 2.0), 3.0);
        assert_eq!(Ball::around(&bounds), around);
        let (axis, angle) = around.cone_from(DVec3::new(-5.0, 2.0, 2.0)).expect("far");
        assert_eq!((axis, angle), (DVec3::X, libm::asin(0.5)));
    }
}
