//! Slab tests of rays against boxes.

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
    /// The distance at which the ray begins, zero or less: behind its origin.
    start: f64,
}

impl RaySlabs {
    /// A ray among boxes whose faces all lie within `extent` of `center`.
    pub(super) fn new(ray: &Ray, center: DVec3, extent: f64, sharpness: f64) -> Self {
        // `SLAB` bounds the error of each quotient, in units of the sum of all lengths in it: the
        // roundings of the numerator, and two more of the quotient. The latter count as if the face
        // were moved by two roundings of the numerator. Both faces are moved outward by that much,
        // so the exact ray is between the exact faces only while the rounded one is between the
        // rounded. Sums, products and quotients are monotone under rounding, so a larger box is
        // passed earlier, for longer, and by all rays that pass the smaller one.
        //
        // The origin of a ray that leaves a surface may be off by its `rounding`. Near its origin
        // it may hit a surface whose border is that far off the ray, or further in a sharp corner.
        // So all faces are moved outward by that distance, too. A surface ahead of the exact origin
        // may lie behind the rounded one, by at most the rounding divided by the slope of the
        // crossing. That slope is at least `GRAZING`, so the ray begins that far behind. (A ray
        // with less slope hits only surfaces ahead.)
        let (origin, size) = ray.origin.seen_from(center);
        let rounding = ray.rounding();
        let error = SLAB * (size + extent);
        let pad = DVec3::splat(error + 2.0 * sharpness * rounding);
        let behind = if rounding > 0.0 {
            (error + 2.0 * rounding) / GRAZING
        } else {
            0.0
        };
        Self {
            origin: [origin + pad, origin - pad],
            // The largest finite number replaces infinity, because 0 · ∞ is not a number.
            slowness: ray.dir.recip().clamp(DVec3::MIN, DVec3::MAX),
            start: -behind,
        }
    }

    /// The distance at which the ray enters a box; `None` if it misses.
    #[inline(always)]
    pub(super) fn entry(&self, bounds: &Bounds) -> Option<f64> {
        let low = (bounds.min - self.origin[0]) * self.slowness;
        let high = (bounds.max - self.origin[1]) * self.slowness;
        let enters = low.min(high).max_element();
        let leaves = low.max(high).min_element();
        (enters <= leaves && leaves >= self.start).then_some(enters)
    }
}
