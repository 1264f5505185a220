//! Planes and rectangles, as the chapter has them.

use super::{ClassicHit, ClassicRay};
use crate::geometry::Rectangle;
use crate::math::Flat;
use crate::math::classic::{Scalar, Vector};

/// The hit on an unbounded plane, the chapter's `plane_t`: `t = n·(q − o) / n·d`.
#[inline]
pub(super) fn plane<T: Scalar>(
    plane: &Flat,
    ray: &ClassicRay<T>,
    counts: impl Fn(T) -> bool,
) -> Option<ClassicHit<T>> {
    let normal = Vector::of(plane.normal);
    let slope = normal.dot(ray.dir);
    if slope == T::zero() {
        return None;
    }
    let t = normal.dot(Vector::of(plane.point) - ray.origin) / slope;
    counts(t).then(|| ClassicHit::new(t, ray.at(t), normal))
}

/// The hit on a finite plane, the chapter's `fplane_t`.
///
/// The hit on the plane, less the corner, is rotated so that the plane's x-direction becomes the
/// x-axis and its normal the z-axis. It counts if `0 ≤ x ≤ width` and `0 ≤ y ≤ height`.
#[inline]
pub(super) fn rectangle<T: Scalar>(
    rectangle: &Rectangle,
    ray: &ClassicRay<T>,
    counts: impl Fn(T) -> bool,
) -> Option<ClassicHit<T>> {
    let hit = plane(&rectangle.flat, ray, counts)?;
    let testhit = hit.point - Vector::of(rectangle.flat.point);
    let rotation = [rectangle.frame.x, rectangle.frame.y].map(Vector::of);
    let [x, y] = rotation.map(|row: Vector<T>| row.dot(testhit));
    let [width, height] = rectangle.size.to_array().map(T::of);
    let inside = T::zero() <= x && x <= width && T::zero() <= y && y <= height;
    inside.then_some(ClassicHit {
        lasthit: [x, y],
        ..hit
    })
}
