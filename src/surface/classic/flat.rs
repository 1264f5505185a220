//! Planes and rectangles, as the chapter has them.

use glam::{DVec2, DVec3};

use super::Scalar;
use super::solid::{Meeting, Solid};
use super::vector::{Line, Vector};

/// An unbounded plane: the chapter's `plane_t`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plane<T> {
    point: Vector<T>,
    normal: Vector<T>,
}

impl<T: Scalar> Plane<T> {
    pub(super) fn of(point: DVec3, normal: DVec3) -> Self {
        Self {
            point: Vector::of(point),
            normal: Vector::of(normal),
        }
    }
}

impl<T: Scalar> Solid<T> for Plane<T> {
    /// `t = n·(q − o) / n·d`.
    #[inline]
    fn meets(&self, line: &Line<T>, counts: impl Fn(T) -> bool) -> Option<Meeting<T>> {
        let slope = self.normal.dot(line.dir);
        if slope == T::zero() {
            return None;
        }
        let t = self.normal.dot(self.point - line.origin) / slope;
        counts(t).then(|| Meeting {
            t,
            point: line.at(t),
            normal: self.normal,
            lasthit: [T::zero(); 2],
        })
    }
}

/// A finite plane: the chapter's `fplane_t`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rectangle<T> {
    plane: Plane<T>,
    /// The rotation that turns the plane's x-direction into the x-axis and its normal into the
    /// z-axis; these are its rows.
    rotation: [Vector<T>; 3],
    width: T,
    height: T,
}

impl<T: Scalar> Rectangle<T> {
    pub(super) fn of(corner: DVec3, axes: [DVec3; 3], size: DVec2) -> Self {
        Self {
            plane: Plane::of(corner, axes[2]),
            rotation: axes.map(Vector::of),
            width: T::of(size.x),
            height: T::of(size.y),
        }
    }
}

impl<T: Scalar> Solid<T> for Rectangle<T> {
    /// The hit on the plane, less the corner, rotated into the plane's axes; then `0 ≤ x ≤ width`
    /// and `0 ≤ y ≤ height`.
    #[inline]
    fn meets(&self, line: &Line<T>, counts: impl Fn(T) -> bool) -> Option<Meeting<T>> {
        let meeting = self.plane.meets(line, counts)?;
        let testhit = meeting.point - self.plane.point;
        let [x, y, _] = self.rotation.map(|row| row.dot(testhit));
        let inside = T::zero() <= x && x <= self.width && T::zero() <= y && y <= self.height;
        inside.then_some(Meeting {
            lasthit: [x, y],
            ..meeting
        })
    }
}
