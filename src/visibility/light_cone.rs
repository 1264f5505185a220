//! The cone of rays from a point to a lamp, and the boxes that it misses.

use glam::DVec3;

use crate::math::error_bounds::{GRAZING, OCCLUSION, SLAB};
use crate::math::{Bounds, Ray};

/// All rays from a point to and beyond a ball around a lamp.
///
/// Coordinates are relative to a tree's centre.
#[derive(Debug, Clone, Copy)]
pub(super) struct LightCone {
    /// The origin of the rays.
    origin: DVec3,
    /// The vector to the lamp's centre.
    to_lamp: DVec3,
    /// The radius of the ball around the lamp.
    radius: f64,
    /// `|d|² − ρ²`, positive if the origin is outside of the ball.
    spread: f64,
    /// The padding for the errors of rays and boxes.
    pad: f64,
    /// The sum of all lengths in the test, the scale of its rounding errors.
    size: f64,
}

impl LightCone {
    /// The rays from a ray's origin to a ball around a lamp.
    ///
    /// All faces of the boxes lie within `extent` of `center`.
    pub(super) fn new(
        ray: &Ray,
        (lamp, lamp_radius): (DVec3, f64),
        center: DVec3,
        extent: f64,
        sharpness: f64,
    ) -> Self {
        let (origin, far) = ray.origin.seen_from(center);
        let to_lamp = -ray.origin.from(lamp);
        let between = (lamp - center).abs().element_sum();
        let size =
            far + extent + between + lamp_radius + ray.origin.size() + center.abs().element_sum();
        let (bound, rounding) = (SLAB * size, ray.rounding());
        Self {
            origin,
            to_lamp,
            radius: lamp_radius,
            spread: to_lamp.length_squared() - lamp_radius * lamp_radius,
            pad: bound + 2.0 * sharpness * rounding + (bound + 2.0 * rounding) / GRAZING,
            size,
        }
    }

    /// Returns whether all rays certainly miss a box.
    #[inline(always)]
    pub(super) fn misses(&self, bounds: &Bounds) -> bool {
        // The rays fill balls whose radii grow linearly with distance. Let w be the vector from the
        // box's centre to the origin, d the vector from there to the lamp, ρ and r the radii of the
        // balls around lamp and box. The rays miss the box if f(t) = |w + t d|² − (r + t ρ)² > 0
        // for all t ≥ 0. Rays do not end at the lamp, because rounding may let a ray nearly
        // parallel to a surface hit it anywhere. `pad` covers origins and boxes that are off by as
        // much as `RaySlabs` allows.
        let offset = self.origin - bounds.min.midpoint(bounds.max);
        let radius = 0.5 * (bounds.max - bounds.min).length() + self.pad;
        let bound = OCCLUSION * self.size * self.size;
        let a = self.spread;
        let b = offset.dot(self.to_lamp) - radius * self.radius;
        let c = offset.length_squared() - radius * radius;
        a > bound && c > bound && (b > bound || a * c - b * b > bound * (a + self.size * self.size))
    }
}
