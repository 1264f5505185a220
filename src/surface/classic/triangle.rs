//! Triangles by barycentric coordinates.

use glam::DVec3;

use super::Scalar;
use super::solid::{Meeting, Solid};
use super::vector::{Line, Vector};

/// A triangle as a corner and the two edges that leave it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Triangle<T> {
    corner: Vector<T>,
    edges: [Vector<T>; 2],
    normal: Vector<T>,
}

impl<T: Scalar> Triangle<T> {
    pub(super) fn of(vertices: [DVec3; 3], normal: DVec3) -> Self {
        let [corner, second, third] = vertices.map(Vector::of);
        Self {
            corner,
            edges: [second - corner, third - corner],
            normal: Vector::of(normal),
        }
    }
}

impl<T: Scalar> Solid<T> for Triangle<T> {
    /// Möller and Trumbore 1997, "Fast, minimum storage ray/triangle intersection", without
    /// culling.
    #[inline]
    fn meets(&self, line: &Line<T>, counts: impl Fn(T) -> bool) -> Option<Meeting<T>> {
        let [first, second] = self.edges;
        let across = line.dir.cross(second);
        let determinant = first.dot(across);
        if determinant.abs() < T::PARALLEL {
            return None;
        }
        let origin = line.origin - self.corner;
        let u = origin.dot(across) / determinant;
        if !(T::zero() <= u && u <= T::one()) {
            return None;
        }
        let upward = origin.cross(first);
        let v = line.dir.dot(upward) / determinant;
        if !(T::zero() <= v && u + v <= T::one()) {
            return None;
        }
        let t = second.dot(upward) / determinant;
        counts(t).then(|| Meeting {
            t,
            point: line.at(t),
            normal: self.normal,
            lasthit: [T::zero(); 2],
        })
    }
}
