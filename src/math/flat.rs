//! The unbounded plane in which flat surfaces lie, and where lines cross it.

use glam::DVec3;

use super::{Point, Ray, Segment, Span, unit};
use crate::language::Refusal;

/// A plane through a point, with a unit normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flat {
    /// A point in the plane.
    pub point: DVec3,
    /// The unit normal, on the plane's front side.
    pub normal: DVec3,
    equation: [f64; 4],
}

/// The side of a surface that a point is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Where the normal points: the side that is lit.
    Front,
    /// Exactly on the surface.
    On,
    /// Behind, or inside of a closed surface.
    Back,
}

/// Where a line crosses a plane, not yet divided: `t = height / slope`.
#[derive(Debug, Clone, Copy)]
pub struct Crossing {
    /// From the plane's point to the ray's origin.
    pub origin: DVec3,
    /// How far the origin lies behind the plane, along the normal: `N = −n·c`.
    pub height: f64,
    /// How much the ray rises along the normal per unit of `t`: `D = n·d`.
    pub slope: f64,
}

impl Flat {
    /// A plane through `point` with a normal of any length but zero.
    ///
    /// # Errors
    /// Refuses a zero normal.
    pub fn new(point: DVec3, normal: DVec3) -> Result<Self, Refusal> {
        let equation = equation(point, normal);
        let normal = unit(normal).ok_or_else(|| {
            Refusal::new(
                "normal",
                "the normal is zero",
                "a normal is the direction that the surface faces, such as 0 1 0 for a floor",
            )
            .expected("expected a direction of any length but zero")
        })?;
        Ok(Self {
            point,
            normal,
            equation,
        })
    }

    /// The plane's equation: the same four numbers for both of its sides, and for any of its points
    /// and normals as long as their products are exact, as those of whole numbers are.
    #[must_use]
    pub fn equation(&self) -> [f64; 4] {
        self.equation
    }

    /// The side a point is on.
    #[must_use]
    pub fn side(&self, point: &Point) -> Side {
        Side::of(self.normal.dot(point.from(self.point)))
    }

    /// Where a segment crosses the plane, if its ends lie strictly on opposite sides; only then
    /// can a surface in this plane stand between them.
    #[must_use]
    pub fn separates(&self, segment: &Segment) -> Option<Crossing> {
        let origin = segment.ray.origin.from(self.point);
        let height = -self.normal.dot(origin);
        let end = self.normal.dot(segment.end - self.point);
        let opposite = (height > 0.0 && end > 0.0) || (height < 0.0 && end < 0.0);
        opposite.then(|| Crossing {
            origin,
            height,
            slope: self.normal.dot(segment.ray.dir),
        })
    }

    /// Where the line of a ray crosses the plane.
    #[must_use]
    pub fn crossing(&self, ray: &Ray) -> Crossing {
        let origin = ray.origin.from(self.point);
        Crossing {
            origin,
            height: -self.normal.dot(origin),
            slope: self.normal.dot(ray.dir),
        }
    }

    /// The distance at which a ray meets the plane, if it does so ahead and in the span.
    #[must_use]
    pub fn hits(&self, ray: &Ray, span: Span) -> Option<f64> {
        let crossing = self.crossing(ray);
        crossing
            .is_ahead()
            .then(|| crossing.distance())
            .filter(|t| span.contains(*t))
    }

    /// The point of the plane at distance `t` on a ray that meets it there.
    ///
    /// The part along the normal is rounding and is taken off.
    #[must_use]
    pub fn foot(&self, ray: &Ray, t: f64) -> Point {
        let offset = ray.origin.from(self.point) + ray.dir * t;
        Point {
            anchor: self.point,
            offset: offset - self.normal * self.normal.dot(offset),
        }
    }
}

/// The coefficients of `n·x = n·p`, divided by the largest one of `n`.
///
/// Quotients of equal numbers are equal, so multiples of `n` give the same equation; a unit normal
/// would not, since its length is rounded.
fn equation(point: DVec3, normal: DVec3) -> [f64; 4] {
    let largest = normal.abs().max_element();
    let (_, exponent) = libm::frexp(largest);
    // Scaled by a power of two, which is exact and keeps the products in range.
    let normal = normal * libm::ldexp(1.0, -exponent);
    let largest = normal.abs().max_element();
    let [x, y, z] = normal.to_array();
    let mut components = [x, y, z].into_iter();
    let pivot = components.find(|component| component.abs() == largest);
    // Adding zero turns −0 into +0, which is the same plane.
    [x, y, z, normal.dot(point)].map(|number| number / pivot.unwrap_or(1.0) + 0.0)
}

impl Side {
    /// The side that a signed height above a surface stands for.
    #[must_use]
    pub fn of(height: f64) -> Self {
        if height > 0.0 {
            Self::Front
        } else if height < 0.0 {
            Self::Back
        } else {
            Self::On
        }
    }
}

impl Crossing {
    /// Whether the crossing lies ahead of the ray's origin; a ray along the plane never crosses.
    #[must_use]
    pub fn is_ahead(&self) -> bool {
        (self.height > 0.0 && self.slope > 0.0) || (self.height < 0.0 && self.slope < 0.0)
    }

    /// The distance of the crossing.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.height / self.slope
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn floor() -> Flat {
        Flat::new(DVec3::ZERO, DVec3::new(0.0, 3.0, 0.0)).expect("a plane")
    }

    fn hits(origin: [f64; 3], dir: [f64; 3]) -> Option<f64> {
        let ray = Ray::new(
            Point::exact(origin.into()),
            unit(dir.into()).expect("a direction"),
        );
        floor().hits(&ray, Span::AHEAD)
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
}
