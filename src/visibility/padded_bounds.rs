//! Boxes outside of which a surface is certainly not hit.

use glam::DVec3;

use super::primitive::Primitive;
use crate::math::error_bounds::{GRAZING, SLAB, WIDEN};
use crate::math::{Bounds, Flat};
use crate::surface::Surface;

/// The largest sharpness of a surface with a box, 2²⁰.
///
/// With a larger limit, one sliver pads every ray by as much as its length. With a smaller one, the
/// slivers of a mesh are tested one by one.
const SHARPEST: f64 = 1_048_576.0;

/// A box outside of which a bounded surface is certainly not hit.
#[derive(Debug, Clone, Copy)]
pub(super) struct PaddedBounds {
    /// The box, in world coordinates.
    pub(super) bounds: Bounds,
    /// The distance by which a corner moves outward if all borders move outward by one.
    pub(super) sharpness: f64,
}

impl PaddedBounds {
    /// The box of a surface; `None` if it is unbounded, a sliver, or overflows.
    pub(super) fn of(primitive: &Primitive<'_>) -> Option<Self> {
        let shape = primitive.surface.shape();
        let bounds = shape.bounds()?;
        let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
        let mut padded = Self {
            bounds,
            sharpness: 1.0,
        };
        let mut margin = SLAB * largest;
        if let Some(plane) = primitive.plane {
            padded.sharpness = sharpness(&shape.outline());
            // The exact hit lies inside the deciding borders, projected to the deciding plane.
            // Their distance from the surface's own is `error`. For a ray of slope `GRAZING` the
            // distance along the plane is `error / GRAZING`. In a corner it is divided by the sine
            // of the angle. `WIDEN` covers the rounding of borders that are not shared.
            let error = shape.border_error() + plane.slack();
            margin += WIDEN * (bounds.max - bounds.min).element_sum()
                + 2.0 * error / GRAZING * padded.sharpness;
        }
        padded.bounds.min -= DVec3::splat(margin);
        padded.bounds.max += DVec3::splat(margin);
        let known = padded.bounds.min.is_finite() && padded.bounds.max.is_finite();
        (known && padded.sharpness <= SHARPEST).then_some(padded)
    }
}

/// A bound of the distance at which a surface can be hit outside of its corners.
///
/// For shared planes and borders, the numbers of one surface decide for all. The bound holds for
/// rays that do not graze the surface.
#[must_use]
pub fn shared_border_error(surface: &dyn Surface) -> f64 {
    let shape = surface.shape();
    let error = shape.border_error() + shape.carrier().map_or(0.0, Flat::slack);
    if error > 0.0 {
        error * sharpness(&shape.outline())
    } else {
        0.0
    }
}

/// An upper bound of 1 / sin(α/2) for the sharpest angle α of an outline.
fn sharpness(outline: &[DVec3]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    let sides: Vec<_> = outline
        .iter()
        .zip(next)
        .map(|(a, b)| (*b - *a).normalize_or_zero())
        .collect();
    let turns = sides.iter().zip(sides.iter().cycle().skip(1));
    let sines = turns.map(|(a, b)| a.cross(*b).length());
    2.0 / sines.fold(1.0, f64::min)
}
