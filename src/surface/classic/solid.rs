//! What a shape answers.

use std::fmt::Debug;

use glam::DVec2;

use super::Scalar;
use super::vector::{Line, Vector};
use crate::math::{Point, Rgb};
use crate::surface::Hit;

/// A shape that a ray can meet.
pub(super) trait Solid<T>: Debug + Send + Sync {
    /// The nearest meeting, if its distance counts.
    fn meets(&self, line: &Line<T>, counts: impl Fn(T) -> bool) -> Option<Meeting<T>>;
}

/// Where a ray met a shape.
#[derive(Debug, Clone, Copy)]
pub(super) struct Meeting<T> {
    /// The distance along the ray.
    pub(super) t: T,
    /// The place in world coordinates: the chapter's `hitloc`.
    pub(super) point: Vector<T>,
    /// The unit normal.
    pub(super) normal: Vector<T>,
    /// The offset from a rectangle's corner: the chapter's `lasthit`. Zero on other shapes.
    pub(super) lasthit: [T; 2],
}

impl<T: Scalar> Meeting<T> {
    /// The meeting in the terms of the tracer.
    pub(super) fn hit(self) -> Hit {
        let [x, y] = self.lasthit;
        Hit {
            t: self.t.wide(),
            // The classic algorithm does not know its errors: what is computed decides.
            error: 0.0,
            point: Point::exact(self.point.wide()),
            normal: self.normal.wide(),
            uv: DVec2::new(x.wide(), y.wide()),
            texel: Rgb::WHITE,
        }
    }
}
