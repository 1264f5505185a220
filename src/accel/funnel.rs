//! Which boxes may hold something that stands before a lamp.

use glam::DVec3;

use super::shields::BLUR;
use crate::math::error_bounds::{GRAZING, SLAB};
use crate::math::{Bounds, Ray};

/// All rays from a place to a lamp, and on beyond it, made ready to be asked which boxes they pass, in
/// coordinates from a tree's centre.
///
/// They do not end at the lamp, for a ray that is nearly parallel to a surface may meet it anywhere by
/// rounding, even if what decides is exact. They begin as far behind the place, and pass a box at such
/// a distance, as [`Slabs`](super::slabs::Slabs) says of each.
///
/// The rays fill balls that are larger the further they are off: with `w` from a ball's centre to the place,
/// `d` from there to the lamp, and `ρ` and `r` for the radii of the ball around the lamp and of the other,
/// the squared distance beyond both is `f(t) = |w + t d|² − (r + t ρ)²`, and must be above zero for all
/// `t` from 0 on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Funnel {
    /// Where the place is.
    place: DVec3,
    /// The way to the lamp's middle.
    onward: DVec3,
    /// How far the lamp reaches from there.
    reach: f64,
    /// `|d|² − ρ²`.
    opens: f64,
    /// By how much the rays and the boxes together are taken to be wider than they are.
    pad: f64,
    /// The sum of all lengths that this is made of.
    size: f64,
}

impl Funnel {
    /// The rays from where a ray starts to a ball around a lamp, among boxes none of which has a face
    /// further than `extent` from `center`.
    pub(super) fn new(
        ray: &Ray,
        (lamp, reach): (DVec3, f64),
        center: DVec3,
        extent: f64,
        sharpness: f64,
    ) -> Self {
        let (place, far) = ray.origin.seen_from(center);
        let onward = -ray.origin.from(lamp);
        let between = (lamp - center).abs().element_sum();
        let size = far + extent + between + reach + ray.origin.size() + center.abs().element_sum();
        let (doubt, rounding) = (SLAB * size, ray.rounding());
        Self {
            place,
            onward,
            reach,
            opens: onward.length_squared() - reach * reach,
            pad: doubt + 2.0 * sharpness * rounding + (doubt + 2.0 * rounding) / GRAZING,
            size,
        }
    }

    /// Whether no ray passes a box, for certain.
    #[inline(always)]
    pub(super) fn misses(&self, bounds: &Bounds) -> bool {
        let way = self.place - bounds.min.midpoint(bounds.max);
        let radius = 0.5 * (bounds.max - bounds.min).length() + self.pad;
        let doubt = BLUR * self.size * self.size;
        let a = self.opens;
        let b = way.dot(self.onward) - radius * self.reach;
        let c = way.length_squared() - radius * radius;
        a > doubt && c > doubt && (b > doubt || a * c - b * b > doubt * (a + self.size * self.size))
    }
}
