//! Triangles by barycentric coordinates.

use super::{ClassicHit, ClassicRay};
use crate::geometry::{Planar, Triangle};
use crate::math::classic::{Scalar, Vector};

/// The hit on a triangle, from either side.
///
/// Möller and Trumbore 1997, "Fast, minimum storage ray/triangle intersection", without culling.
#[inline]
pub(super) fn triangle<T: Scalar>(
    triangle: &Triangle,
    ray: &ClassicRay<T>,
    counts: impl Fn(T) -> bool,
) -> Option<ClassicHit<T>> {
    let [corner, second, third] = triangle.vertices().map(Vector::of);
    let [first, second] = [second - corner, third - corner];
    let across = ray.dir.cross(second);
    let determinant: T = first.dot(across);
    if determinant.abs() < T::PARALLEL {
        return None;
    }
    let origin = ray.origin - corner;
    let u = origin.dot(across) / determinant;
    if !(T::zero() <= u && u <= T::one()) {
        return None;
    }
    let upward = origin.cross(first);
    let v = ray.dir.dot(upward) / determinant;
    if !(T::zero() <= v && u + v <= T::one()) {
        return None;
    }
    let t = second.dot(upward) / determinant;
    let normal = Vector::of(triangle.carrier().normal);
    counts(t).then(|| ClassicHit::new(t, ray.at(t), normal))
}
