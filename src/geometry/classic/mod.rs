//! The chapter's own intersection tests, in `f64` and in `f32`: a baseline.
//!
//! All tests use world coordinates. A ray is `P = o + t d`. A plane is hit at `t = n·(q − o) /
//! n·d`. A rectangle subtracts its corner from the hit, rotates the rest into its own axes and
//! compares it with width and height. A sphere is a quadratic. A triangle has barycentric
//! coordinates. Hits nearer than [`Scalar::OFFSET`] do not count, so that a ray misses the surface
//! that it leaves.
//!
//! Ray tracers commonly do so, and most pictures are right. The test module
//! `weaknesses` has the cases that go wrong.

mod flat;
mod round;
mod triangle;

use super::{Hit, Planar, Shape};
use crate::math::classic::{Scalar, Vector};
use crate::math::{Point, Ray, Segment, Span};

/// A ray in world coordinates: `P = o + t d`.
#[derive(Debug, Clone, Copy)]
struct ClassicRay<T> {
    origin: Vector<T>,
    dir: Vector<T>,
}

impl<T: Scalar> ClassicRay<T> {
    fn of(ray: &Ray) -> Self {
        Self {
            origin: Vector::of(ray.origin.world()),
            dir: Vector::of(ray.dir),
        }
    }

    fn at(&self, t: T) -> Vector<T> {
        self.origin + self.dir * t
    }
}

/// A hit in world coordinates.
#[derive(Debug, Clone, Copy)]
struct ClassicHit<T> {
    /// The distance along the ray.
    t: T,
    /// The chapter's `hitloc`.
    point: Vector<T>,
    /// The unit normal.
    normal: Vector<T>,
    /// The offset from a rectangle's corner, the chapter's `lasthit`; zero elsewhere.
    lasthit: [T; 2],
}

impl<T: Scalar> ClassicHit<T> {
    fn new(t: T, point: Vector<T>, normal: Vector<T>) -> Self {
        Self {
            t,
            point,
            normal,
            lasthit: [T::zero(); 2],
        }
    }

    /// The hit in the terms of the tracer.
    fn wide(self) -> Hit {
        // The classic algorithm has no error bounds: the computed values decide.
        let point = Point::exact(self.point.wide());
        let hit = Hit::new(self.t.wide(), 0.0, point, self.normal.wide());
        let uv = self.lasthit.map(T::wide).into();
        Hit { uv, ..hit }
    }
}

/// The nearest hit of a ray in a span of distances.
#[must_use]
#[inline]
pub fn intersect<T: Scalar>(shape: &Shape, ray: &Ray, span: Span) -> Option<Hit> {
    let counts = |t: T| t > T::OFFSET && span.contains(t.wide());
    nearest(shape, &ClassicRay::of(ray), counts).map(ClassicHit::wide)
}

/// Returns whether a shape stands between the ends of a segment.
#[must_use]
#[inline]
pub fn occludes<T: Scalar>(shape: &Shape, segment: &Segment) -> bool {
    let end = T::of(segment.length) - T::OFFSET;
    let span = segment.limits().span();
    let counts = |t: T| t > T::OFFSET && t < end && span.contains(t.wide());
    nearest(shape, &ClassicRay::of(&segment.ray), counts).is_some()
}

/// The nearest hit whose distance counts.
#[inline]
fn nearest<T: Scalar>(
    shape: &Shape,
    ray: &ClassicRay<T>,
    counts: impl Fn(T) -> bool,
) -> Option<ClassicHit<T>> {
    match shape {
        Shape::Plane(plane) => flat::plane(plane.carrier(), ray, counts),
        Shape::Rectangle(rectangle) => flat::rectangle(rectangle, ray, counts),
        Shape::Triangle(it) => triangle::triangle(it, ray, counts),
        Shape::Sphere(sphere) => round::sphere(sphere, ray, counts),
        Shape::Ellipsoid(ellipsoid) => round::ellipsoid(ellipsoid, ray, counts),
    }
}

#[cfg(test)]
mod tests;
