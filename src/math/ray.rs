//! Rays, and the hits that they start from.

use glam::DVec3;

use super::error_bounds::{FOOT, HEIGHT, SLIDE, UNIT};
use super::vector::reflected;
use super::{Flat, Point};

/// The plane, sphere or other surface sheet that a hit lies on. Coplanar surfaces share one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CarrierId(pub u32);

/// A half-line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray<'a> {
    /// Where it starts.
    pub origin: Point,
    /// Where it goes; of unit length, so that `t` is a distance.
    pub dir: DVec3,
    /// The hit that it starts from, if it does not start in free space.
    pub spawned_from: Option<&'a RayOrigin<'a>>,
    /// The ray's share in what a height above a plane can be off by when the way to the plane's
    /// point is computed.
    pub(crate) doubt: f64,
    /// A bound of how far its origin lies from where it ought to.
    pub(crate) astray: f64,
}

/// A hit from which other rays start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RayOrigin<'a> {
    /// The surface's sheet, which the rays cannot meet again: a line meets a plane once. `None` if
    /// they can.
    pub carrier: Option<CarrierId>,
    /// The surface's plane, if it is flat.
    pub flat: Option<&'a Flat>,
    /// The hit.
    pub point: Point,
    /// What the hit is on, if the rays that go to its inside meet it again.
    pub curve: Option<Curve>,
    /// The ray that arrived there.
    pub arriving: &'a Ray<'a>,
    /// How far at most the point lies from where it ought to.
    rounding: f64,
    /// That of the rays that start there, as is the next.
    doubt: f64,
    astray: f64,
}

/// The place on a round thing that rays can be inside of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curve {
    /// The centre and the half axes.
    pub round: [DVec3; 2],
    /// The unit normal, outward.
    pub normal: DVec3,
}

impl<'a> RayOrigin<'a> {
    /// The hit of a ray at this point of a surface on this sheet.
    ///
    /// `slip` is how far it may be off because its distance is.
    #[must_use]
    #[inline]
    pub fn new(
        (carrier, flat): (Option<CarrierId>, Option<&'a Flat>),
        arriving: &'a Ray<'a>,
        point: Point,
        slip: f64,
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
            rounding: arriving.rounding() + FOOT * length + slip.min(SLIDE * length),
            doubt: HEIGHT * size,
            astray: arriving.astray + (FOOT / HEIGHT) * arriving.doubt + FOOT * size + slip,
        }
    }

    /// Whether the surface is known to lie in this plane.
    #[must_use]
    pub fn is_in(&self, flat: &Flat) -> bool {
        self.flat
            .is_some_and(|own| own.decisive() == flat.decisive())
    }

    /// How far at most the point lies from where it ought to: beyond a plane that was not crossed.
    ///
    /// That is how far it lies from where the ray that arrived met the surface, and how far that
    /// ray's own origin was off, since a ray that starts beyond a plane and runs along it ends as
    /// far beyond.
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

    /// A bound of the sum of all lengths that its origin is made of.
    #[must_use]
    pub(crate) fn size(&self) -> f64 {
        const SIZE: f64 = (1.0 + 4.0 * UNIT) / HEIGHT;
        self.doubt * SIZE
    }

    /// How far at most its origin lies from where it ought to.
    #[must_use]
    pub fn rounding(&self) -> f64 {
        self.spawned_from
            .map_or(0.0, |ray_origin| ray_origin.rounding())
    }

    /// The sheet that it starts from.
    #[must_use]
    pub fn leaves(&self) -> Option<CarrierId> {
        self.spawned_from.and_then(|ray_origin| ray_origin.carrier)
    }

    /// Whether it goes to the inside of this round thing, if it starts from its surface.
    ///
    /// That is the side for which the direction was made, whatever the rounded point says.
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

    /// The direction of the mirrored ray at a surface with this unit normal, from either side.
    #[must_use]
    pub fn mirrored(&self, normal: DVec3) -> DVec3 {
        reflected(self.dir, normal)
    }
}

fn is_unit(dir: DVec3) -> bool {
    (dir.length_squared() - 1.0).abs() < 16.0 * f64::EPSILON
}
