//! The carrier plane of flat surfaces, and its crossings with lines.

use glam::DVec3;

use super::error_bounds::{HEIGHT, OWN_NORMAL, UNDERFLOW};
use super::exact::{Distance, Exact, ExactVector, RationalVector, Sign};
use super::{Crossing, Decisions, Point, Ray, Side, Span};
use crate::language::ValueError;

/// A plane through a point, with a unit normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flat {
    /// A point in the plane, from which heights are computed.
    pub point: DVec3,
    /// The unit normal, on the front side.
    pub normal: DVec3,
    /// The normal that *decides*, equal up to its sign for all surfaces in this plane.
    ///
    /// It differs from `normal` by no more than rounding.
    pub(super) decisive: DVec3,
    /// The point that *decides* heights, equal for all surfaces in this plane.
    pub(super) base: DVec3,
    /// A bound of the height of `point` above the deciding plane, underflow included.
    pub(super) slack: f64,
    /// The plane's share of the error of a height above it; [`Ray`] has the other.
    pub(super) doubt: f64,
}

impl Flat {
    /// A plane through `point` with a normal of any length but zero.
    ///
    /// The normal is made unit exactly and rounded once.
    ///
    /// # Errors
    /// Returns an error if the normal is zero.
    pub fn new(point: DVec3, normal: DVec3) -> Result<Self, ValueError> {
        let unit = RationalVector::of_decimals(normal).unit();
        if unit == DVec3::ZERO {
            return Err(ValueError::new(
                "normal",
                "the normal is zero",
                "a normal is the direction that the surface faces, such as 0 1 0 for a floor",
            )
            .expected("expected a direction of any length but zero"));
        }
        Ok(Self::with_unit_normal(point, unit))
    }

    /// A plane through `point` with a unit normal.
    #[must_use]
    pub fn with_unit_normal(point: DVec3, normal: DVec3) -> Self {
        Self {
            point,
            normal,
            decisive: normal,
            base: point,
            slack: UNDERFLOW,
            doubt: HEIGHT * Point::exact(point).size() + UNDERFLOW,
        }
    }

    /// The same plane and point, with the deciding numbers of another surface.
    #[must_use]
    pub fn welded(&self, to: &Self) -> Self {
        let turned = self.normal.dot(to.decisive) < 0.0;
        let decisive = if turned { -to.decisive } else { to.decisive };
        // Within one rounding of each component, the surface keeps its own normal.
        let same = (self.normal - decisive).abs().max_element() <= OWN_NORMAL;
        let normal = if same { self.normal } else { decisive };
        let way = Point::exact(self.point).exactly_from(to.base);
        // The exact height was rounded once.
        let apart = way.dot(&decisive.into()).to_f64().abs().next_up();
        let unwelded = Self::with_unit_normal(self.point, normal);
        Self {
            decisive,
            base: to.base,
            slack: unwelded.slack + apart,
            doubt: unwelded.doubt + apart,
            ..unwelded
        }
    }

    /// A plane whose point is moved near the eye if it is very far away.
    ///
    /// From far away, rounding the normal would move the plane at the eye. The new point is the
    /// foot of the eye's perpendicular.
    ///
    /// # Errors
    /// Returns an error if the normal is zero.
    pub fn near(eye: DVec3, point: DVec3, normal: DVec3) -> Result<Self, ValueError> {
        // Half of a double's digits.
        const FAR: f64 = 67_108_864.0; // 2^26
        let plane = Self::new(point, normal)?;
        if (point - eye).length() <= FAR * plane.normal.dot(point - eye).abs() {
            return Ok(plane);
        }
        let given = RationalVector::of_decimals(normal);
        let way = &RationalVector::of_decimals(point) - &RationalVector::of_decimals(eye);
        let share = given.dot(&way) / given.dot(&given);
        let foot = &RationalVector::of_decimals(eye) + &given.times(&share);
        let base = foot.rounded();
        let is_far = (point - eye).length() > FAR * (base - eye).length();
        Ok(if is_far {
            Self::with_unit_normal(base, plane.normal)
        } else {
            plane
        })
    }

    /// A bound of the height of its point above the deciding plane, underflow included.
    #[must_use]
    pub(crate) fn slack(&self) -> f64 {
        self.slack
    }

    /// The normal that decides heights.
    #[must_use]
    pub fn decisive_normal(&self) -> DVec3 {
        self.decisive
    }

    /// The point and normal that decide, equal for all surfaces on both sides.
    #[must_use]
    pub fn decisive(&self) -> [DVec3; 2] {
        let [x, y, z] = self.decisive.to_array();
        let turned = x < 0.0 || x == 0.0 && (y < 0.0 || y == 0.0 && z < 0.0);
        // Adding zero turns −0 into +0, which is the same plane.
        let normal = if turned {
            -self.decisive
        } else {
            self.decisive
        };
        let normal = normal + DVec3::ZERO;
        [self.base + DVec3::ZERO, normal]
    }

    /// The exact side of a point.
    #[must_use]
    pub fn side(&self, point: &Point) -> Side {
        let (way, size) = point.seen_from(self.point);
        let height = self.normal.dot(way);
        if height.abs() > HEIGHT * size + self.slack {
            return Side::of(Sign::of(height));
        }
        Side::of(self.exact_side(point))
    }

    /// The side of an exactly known point, which is also given rounded.
    #[must_use]
    pub fn side_of(&self, exact: &ExactVector, rounded: DVec3) -> Side {
        let height = self.normal.dot(rounded - self.point);
        // Rounding the point has the same error as rounding an offset.
        let point = Point::exact(rounded);
        if height.abs() > 2.0 * HEIGHT * point.size() + self.doubt {
            return Side::of(Sign::of(height));
        }
        Side::of(self.exact_height(exact).sign())
    }

    /// Returns whether a part of an ellipsoid lies strictly on a side.
    ///
    /// Along the normal `n` it extends `√Σ (aᵢ nᵢ)²` from its centre, for the half axes `aᵢ`.
    #[must_use]
    pub fn has_some_of(&self, [center, axes]: [DVec3; 2], side: Side) -> bool {
        let toward = match side {
            Side::Front => 1.0,
            Side::Back => -1.0,
            Side::On => return false,
        };
        let extent = (axes * self.normal).length();
        let height = toward * self.normal.dot(center - self.point) + extent;
        let size = Point::exact(center).size() + axes.element_sum();
        if height.abs() > 2.0 * HEIGHT * size + self.doubt {
            return height > 0.0;
        }
        let height = &self.exact_height(&center.into()) * &toward.into();
        let extent = ExactVector::from(axes).scaled(&self.decisive.into());
        height.sign() == Sign::Positive
            || (&extent.dot(&extent) - &height.squared()).sign() == Sign::Positive
    }

    /// The exact height of a point above the plane.
    #[must_use]
    pub fn exact_height(&self, point: &ExactVector) -> Exact {
        (point - &self.base.into()).dot(&self.decisive.into())
    }

    /// The exact rise of a direction along the plane's normal.
    #[must_use]
    pub fn exact_slope(&self, dir: DVec3) -> Exact {
        ExactVector::from(dir).dot(&self.decisive.into())
    }

    /// Returns whether another plane has this normal or the opposite one.
    #[must_use]
    pub fn is_parallel(&self, other: &Self) -> bool {
        self.decisive == other.decisive || self.decisive == -other.decisive
    }

    /// Returns whether this plane lies on this side of a parallel one.
    #[must_use]
    pub fn lies_on(&self, other: &Self, side: Side) -> bool {
        other.side(&Point::exact(self.base)) == side
    }

    /// The exact crossing of a ray: a vector from a scene point, and its divisor.
    pub(super) fn exact_place(&self, ray: &Ray, from: DVec3) -> (ExactVector, Exact) {
        let (normal, dir) = (ExactVector::from(self.decisive), ExactVector::from(ray.dir));
        let slope = normal.dot(&dir);
        let height = ray.origin.exactly_from(self.base).dot(&normal);
        let place = &ray.origin.exactly_from(from).times(&slope) - &dir.times(&height);
        (place, slope)
    }

    /// The exact sign of the height of a point above the plane.
    pub(super) fn exact_side(&self, point: &Point) -> Sign {
        let height = point.exactly_from(self.base).dot(&self.decisive.into());
        Decisions::note(height.sign() == Sign::Zero);
        height.sign()
    }

    /// The exact distance of a ray's crossing; `None` for a ray along the plane.
    #[must_use]
    pub fn exact_distance(&self, ray: &Ray) -> Option<Distance> {
        let normal = ExactVector::from(self.decisive);
        let slope = normal.dot(&ray.dir.into());
        let height = -&ray.origin.exactly_from(self.base).dot(&normal);
        (slope.sign() != Sign::Zero).then(|| Distance::quotient(height, slope))
    }

    /// The distance of a ray's crossing and its error bound.
    ///
    /// `None` if the crossing is not ahead or not in the span.
    #[must_use]
    #[inline]
    pub fn hits(&self, ray: &Ray, span: Span) -> Option<(f64, f64)> {
        let crossing = self.crossing(ray)?;
        let t = crossing.distance();
        let error = crossing.error(t);
        span.admits(t, error).then_some((t, error))
    }

    /// An error bound of a crossing's distance, from the point-to-origin vector.
    #[must_use]
    pub fn error(&self, ray: &Ray, t: f64) -> f64 {
        let (origin, size) = ray.origin.seen_from(self.point);
        let crossing = Crossing {
            origin,
            height: -self.normal.dot(origin),
            slope: self.normal.dot(ray.dir),
            rises: true,
            doubt: HEIGHT * size + self.slack,
            at_start: None,
            grazing: None,
        };
        crossing.error(t)
    }

    /// The point of the plane at distance `t` on a ray that crosses it there.
    ///
    /// The part along the normal is rounding and is removed.
    #[must_use]
    #[inline]
    pub fn foot(&self, ray: &Ray, t: f64) -> Point {
        let offset = ray.origin.from(self.point) + ray.dir * t;
        Point {
            anchor: self.point,
            offset: offset - self.normal * self.normal.dot(offset),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{RayOrigin, unit};

    fn floor() -> Flat {
        Flat::new(DVec3::ZERO, DVec3::new(0.0, 3.0, 0.0)).expect("a plane")
    }

    fn hits(origin: [f64; 3], dir: [f64; 3]) -> Option<f64> {
        let ray = Ray::new(
            Point::exact(origin.into()),
            unit(dir.into()).expect("a direction"),
        );
        floor().hits(&ray, Span::AHEAD).map(|(t, _)| t)
    }

    #[test]
    fn a_plane_is_met_from_both_sides() {
        assert_eq!(hits([0.0, 2.0, 0.0], [0.0, -1.0, 0.0]), Some(2.0));
        assert_eq!(hits([0.0, -2.0, 0.0], [0.0, 1.0, 0.0]), Some(2.0));
        assert_eq!(hits([0.0, 2.0, 0.0], [0.0, 1.0, 0.0]), None);
    }

    #[test]
    fn a_ray_along_or_in_the_plane_misses() {
        assert_eq!(hits([0.0, 1.0, 0.0], [1.0, 0.0, 0.0]), None);
        assert_eq!(hits([0.0, 1.0, 0.0], [1.0, -0.0, 0.0]), None);
        assert_eq!(hits([0.0, 0.0, 0.0], [1.0, 0.0, 0.0]), None);
    }

    #[test]
    fn a_ray_from_the_plane_misses_it_and_one_from_a_denormal_below_hits() {
        assert_eq!(hits([0.0, 0.0, 0.0], [0.0, 1.0, 0.0]), None);
        assert_eq!(hits([0.0, -5e-324, 0.0], [0.0, 1.0, 0.0]), Some(5e-324));
    }

    #[test]
    fn a_plane_that_is_welded_decides_by_the_other_however_far_it_is_apart() {
        let own = Flat::new(DVec3::new(0.0, 1e-10, 0.0), DVec3::Y).expect("a plane");
        let welded = own.welded(&floor());
        let between = Point::exact(DVec3::new(0.0, 5e-11, 0.0));
        assert_eq!(
            (own.side(&between), welded.side(&between)),
            (Side::Back, Side::Front)
        );
        let down = Ray::new(between, DVec3::NEG_Y);
        assert!(own.crossing(&down).is_none() && welded.crossing(&down).is_some());
    }

    #[test]
    fn a_ray_that_has_passed_a_pane_next_to_a_wall_does_not_meet_it_again() {
        let (pane, wall) = (floor(), Flat::new(DVec3::ZERO, DVec3::X).expect("a wall"));
        let down = unit(DVec3::new(-1.0, -1.0, 0.0)).expect("a direction");
        let eye = Ray::new(Point::exact(DVec3::new(1.0, 1.0, 0.0)), down);
        let met = |x, y| Point {
            anchor: DVec3::ZERO,
            offset: DVec3::new(x, y, 0.0),
        };
        // Both points are within rounding of the edge.
        let passed = RayOrigin::new((None, Some(&pane)), &eye, met(1e-17, 0.0), 1e-16);
        let behind = Ray::spawn(&passed, down);
        let mirrored = RayOrigin::new((None, Some(&wall)), &behind, met(0.0, -1e-17), 1e-16);
        let away = Ray::spawn(&mirrored, behind.mirrored(wall.normal));
        assert!(pane.crossing(&away).is_none());
    }
}
