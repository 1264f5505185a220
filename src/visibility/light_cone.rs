//! The boxes that rays to a lamp may pass.

use glam::DVec3;

use crate::math::error_bounds::{GRAZING, OCCLUSION, SLAB};
use crate::math::{Bounds, Ray};

/// All rays from a point to a ball around a lamp, and beyond it, in coordinates from a tree's centre.
#[derive(Debug, Clone, Copy)]
pub(super) struct LightCone {
    /// The point that the rays start from.
    place: DVec3,
    /// The vector to the lamp's centre.
    onward: DVec3,
    /// The radius of the ball around the lamp.
    radius: f64,
    /// `|d|² − ρ²`.
    opens: f64,
    /// The width that is added for the errors of rays and boxes.
    pad: f64,
    /// The sum of all lengths that this is made of.
    size: f64,
}

impl LightCone {
    /// The rays from a ray's origin to a ball around a lamp.
    ///
    /// No box has a face further than `extent` from `center`.
    pub(super) fn new(
        ray: &Ray,
        (lamp, lamp_radius): (DVec3, f64),
        center: DVec3,
        extent: f64,
        sharpness: f64,
    ) -> Self {
        let (place, far) = ray.origin.seen_from(center);
        let onward = -ray.origin.from(lamp);
        let between = (lamp - center).abs().element_sum();
        let size =
            far + extent + between + lamp_radius + ray.origin.size() + center.abs().element_sum();
        let (doubt, rounding) = (SLAB * size, ray.rounding());
        Self {
            place,
            onward,
            radius: lamp_radius,
            opens: onward.length_squared() - lamp_radius * lamp_radius,
            pad: doubt + 2.0 * sharpness * rounding + (doubt + 2.0 * rounding) / GRAZING,
            size,
        }
    }

    /// Returns whether certainly no ray passes a box.
    #[inline(always)]
    pub(super) fn misses(&self, bounds: &Bounds) -> bool {
        // The rays fill balls that grow with their distance: with w from the box's centre to the point, d
        // from there to the lamp, and ρ and r for the radii of the balls around lamp and box, the squared
        // distance beyond both is f(t) = |w + t d|² − (r + t ρ)², and must be above zero for all t from 0 on.
        // Rays do not end at the lamp, for rounding may let a ray nearly parallel to a surface hit it
        // anywhere. They begin behind the point, and pass a box at a distance, as `RaySlabs` allows.
        let way = self.place - bounds.min.midpoint(bounds.max);
        let radius = 0.5 * (bounds.max - bounds.min).length() + self.pad;
        let doubt = OCCLUSION * self.size * self.size;
        let a = self.opens;
        let b = way.dot(self.onward) - radius * self.radius;
        let c = way.length_squared() - radius * radius;
        a > doubt && c > doubt && (b > doubt || a * c - b * b > doubt * (a + self.size * self.size))
    }
}
