//! The boxes that a ray passes.

use glam::DVec3;

use crate::math::error_bounds::{GRAZING, SLAB};
use crate::math::{Bounds, Ray};

/// A ray prepared for tests against boxes, in coordinates from a tree's centre.
///
/// A box is the part of space between three pairs of faces, and a ray is between a pair from
/// `(low − o)/d` to `(high − o)/d` (Kay and Kajiya 1986, "Ray Tracing Complex Scenes").
#[derive(Debug, Clone, Copy)]
pub(super) struct RaySlabs {
    /// The origin as seen from the lower and from the higher faces, moved outward.
    origin: [DVec3; 2],
    /// One divided by the direction; never zero, infinite or undefined.
    slowness: DVec3,
    /// How far behind the start the ray begins: zero or less.
    start: f64,
}

impl RaySlabs {
    /// A ray among boxes none of which has a face further than `extent` from `center`.
    pub(super) fn new(ray: &Ray, center: DVec3, extent: f64, sharpness: f64) -> Self {
        // Each quotient is off by `SLAB`, in units of the sum of all lengths that went into it: the
        // numerator by its roundings, and the quotient by two more, which count as if the face were
        // moved by two roundings of the numerator. So both faces are moved outward by that much, and
        // the exact ray is between the exact faces only while the rounded one is between the rounded.
        // Sums, products and quotients are monotone under rounding, so a larger box is passed
        // earlier, for longer, and by all rays that pass the smaller one.
        //
        // A ray that leaves a surface may start as far from its exact origin as its `rounding`. So at
        // its very start it may hit a surface whose border is that far beside it, or further in a
        // sharp corner: all faces are moved outward by that, too. A surface that it has not crossed
        // yet may lie behind its start, by as much as the rounding divided by the slope at which it is
        // crossed, which is `GRAZING` or more: the ray begins that far behind. (Of a ray with less
        // slope, only surfaces ahead count.)
        let (origin, size) = ray.origin.seen_from(center);
        let rounding = ray.rounding();
        let doubt = SLAB * (size + extent);
        let pad = DVec3::splat(doubt + 2.0 * sharpness * rounding);
        let behind = if rounding > 0.0 {
            (doubt + 2.0 * rounding) / GRAZING
        } else {
            0.0
        };
        Self {
            origin: [origin + pad, origin - pad],
            // The largest number stands for infinity, of which zero times is not a number.
            slowness: ray.dir.recip().clamp(DVec3::MIN, DVec3::MAX),
            start: -behind,
        }
    }

    /// Where the ray enters a box; `None` if it passes by.
    #[inline(always)]
    pub(super) fn entry(&self, bounds: &Bounds) -> Option<f64> {
        let low = (bounds.min - self.origin[0]) * self.slowness;
        let high = (bounds.max - self.origin[1]) * self.slowness;
        let enters = low.min(high).max_element();
        let leaves = low.max(high).min_element();
        (enters <= leaves && leaves >= self.start).then_some(enters)
    }
}
