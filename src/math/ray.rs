//! Rays, and the hits that they leave.

use glam::DVec3;

use super::error_bounds::{FOOT, HEIGHT, SIZE, SLIDE};
use super::vector::reflected;
use super::{Flat, Point};

/// The identifier of a carrier: a plane, shared if coplanar, or a round surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CarrierId(pub u32);

/// A half-line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray<'a> {
    /// The origin.
    pub origin: Point,
    /// The direction; of unit length, so that `t` is a distance.
    pub dir: DVec3,
    /// The hit that the ray leaves; `None` for a ray from free space.
    pub spawned_from: Option<&'a RayOrigin<'a>>,
    /// The ray's share of the error of its origin's height above a plane.
    pub(crate) doubt: f64,
    /// An error bound of the origin that needs no walk along the path.
    pub(crate) astray: f64,
}

/// A hit that other rays leave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RayOrigin<'a> {
    /// The carrier, which the rays cannot hit again: a line crosses a plane once.
    ///
    /// `None` if they can.
    pub carrier: Option<CarrierId>,
    /// The surface's plane, if it is flat.
    pub flat: Option<&'a Flat>,
    /// The hit.
    pub point: Point,
    /// The position on a round surface, if rays inside can hit it again.
    pub curve: Option<Curve>,
    /// The ray that arrived.
    pub arriving: &'a Ray<'a>,
    /// The error bound of the point.
    rounding: f64,
    /// The errors of the rays that start there, as in [`Ray`].
    doubt: f64,
    astray: f64,
}

/// A position on a round surface that rays can be inside of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curve {
    /// The centre and the half axes.
    pub round: [DVec3; 2],
    /// The unit normal, outward.
    pub normal: DVec3,
}

impl<'a> RayOrigin<'a> {
    /// The hit of a ray at a point of a surface on this carrier.
    ///
    /// `point_error` is the part of its error that the error of the distance causes.
    #[must_use]
    #[inline]
    pub fn new(
        (carrier, flat): (Option<CarrierId>, Option<&'a Flat>),
        arriving: &'a Ray<'a>,
        point: Point,
        point_error: f64,
    ) -> Self {
        let size = point.size();
        let (_, before) = arriving.origin.seen_from(point.anchor);
        let length = before + point.offset.abs().element_sum();
        Self {
            carrier,
            flat,
            point,
            curve: None,
            arriving,
            rounding: arriving.rounding() + FOOT * length + point_error.min(SLIDE * length),
            doubt: HEIGHT * size,
            astray: arriving.astray + (FOOT / HEIGHT) * arriving.doubt + FOOT * size + point_error,
        }
    }

    /// Returns whether the surface certainly lies in this plane.
    #[must_use]
    pub fn is_in(&self, flat: &Flat) -> bool {
        self.flat
            .is_some_and(|own| own.decisive() == flat.decisive())
    }

    /// The error bound of the point, also beyond a plane that was not crossed.
    // That is its distance from the true hit of the arriving ray, and the error of that ray's own
    // origin: a ray that starts beyond a plane and runs along it ends as far beyond.
    #[must_use]
    pub fn rounding(&self) -> f64 {
        self.rounding
    }
}

impl<'a> Ray<'a> {
    /// A ray that starts in free space.
    #[must_use]
    pub fn new(origin: Point, dir: DVec3) -> Self {
        debug_assert!(is_unit(dir), "{dir} is not unit");
        Self {
            origin,
            dir,
            spawned_from: None,
            doubt: HEIGHT * origin.size(),
            astray: 0.0,
        }
    }

    /// A ray that starts from a hit.
    #[must_use]
    pub fn spawn(ray_origin: &'a RayOrigin<'a>, dir: DVec3) -> Self {
        debug_assert!(is_unit(dir), "{dir} is not unit");
        Self {
            origin: ray_origin.point,
            dir,
            spawned_from: Some(ray_origin),
            doubt: ray_origin.doubt,
            astray: ray_origin.astray,
        }
    }

    /// A bound of the sum of all lengths that the origin is made of.
    #[must_use]
    pub(crate) fn size(&self) -> f64 {
        const PER_ERROR: f64 = (1.0 + SIZE) / HEIGHT;
        self.doubt * PER_ERROR
    }

    /// The error bound of the origin.
    #[must_use]
    pub fn rounding(&self) -> f64 {
        self.spawned_from
            .map_or(0.0, |ray_origin| ray_origin.rounding())
    }

    /// The carrier that the ray leaves.
    #[must_use]
    pub fn leaves(&self) -> Option<CarrierId> {
        self.spawned_from.and_then(|ray_origin| ray_origin.carrier)
    }

    /// Returns whether the ray goes inside this round surface, if it starts on it.
    ///
    /// The side is the one for which the direction was made, whatever the rounded origin is.
    #[must_use]
    pub fn goes_inside(&self, round: [DVec3; 2]) -> Option<bool> {
        let curve = self.spawned_from?.curve?;
        (curve.round == round).then(|| self.dir.dot(curve.normal) < 0.0)
    }

    /// The point at distance `t`.
    #[must_use]
    pub fn at(&self, t: f64) -> Point {
        Point {
            anchor: self.origin.anchor,
            offset: self.origin.offset + self.dir * t,
        }
    }

    /// The reflected direction at a surface with this unit normal, from either side.
    #[must_use]
    pub fn mirrored(&self, normal: DVec3) -> DVec3 {
        reflected(self.dir, normal)
    }
}

fn is_unit(dir: DVec3) -> bool {
    (dir.length_squared() - 1.0).abs() < 16.0 * f64::EPSILON
}
