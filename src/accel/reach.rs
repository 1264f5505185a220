//! Where in space a surface can be met.

use glam::DVec3;

use super::Entry;
use crate::math::error_bounds::{GRAZING, SLAB, WIDEN};
use crate::math::{Bounds, Flat};
use crate::surface::Surface;

/// The sharpness up to which a surface has a box, 2²⁰. Larger, and one sliver makes every ray as wide as
/// it is long; smaller, and slivers of a mesh are asked one by one.
const SHARPEST: f64 = 1_048_576.0;

/// A box outside of which a bounded surface is not met for certain.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reach {
    /// The box, in world coordinates.
    pub(super) bounds: Bounds,
    /// By how much a corner of the surface lies further out than its borders, when all of them are
    /// moved outward by one.
    pub(super) sharpness: f64,
}

impl Reach {
    /// The reach of a surface; `None` if it has no end, or is a sliver, or its box has no numbers.
    ///
    /// The exact place at which a flat surface is met lies inside the lines that decide, brought into
    /// the plane that decides. Those are off its own by a *slack*, known since it was welded; seen by a
    /// ray that rises by as little as [`GRAZING`] that is `slack / GRAZING`, and in a corner it is
    /// divided by the sine of its angle. What rounding puts between an unwelded rectangle and its
    /// lines is within [`WIDEN`]. Round surfaces are met exactly where they are.
    pub(super) fn of(entry: &Entry<'_>) -> Option<Self> {
        let surface = entry.surface;
        let bounds = surface.bounds()?;
        let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
        let mut reach = Self {
            bounds,
            sharpness: 1.0,
        };
        let mut margin = SLAB * largest;
        if let Some(flat) = entry.flat {
            reach.sharpness = sharpness(&surface.outline());
            let slack = surface.slack() + flat.slack();
            margin += WIDEN * (bounds.max - bounds.min).element_sum()
                + 2.0 * slack / GRAZING * reach.sharpness;
        }
        reach.bounds.min -= DVec3::splat(margin);
        reach.bounds.max += DVec3::splat(margin);
        let known = reach.bounds.min.is_finite() && reach.bounds.max.is_finite();
        (known && reach.sharpness <= SHARPEST).then_some(reach)
    }
}

/// How far at most a surface can be met beside the box around its corners, because borders that it shares
/// with others, and its plane, are decided by numbers of theirs; of rays at no small angle to it.
pub fn overhang(surface: &dyn Surface) -> f64 {
    let slack = surface.slack() + surface.flat().map_or(0.0, Flat::slack);
    if slack > 0.0 {
        slack * sharpness(&surface.outline())
    } else {
        0.0
    }
}

/// One divided by the sine of half of the sharpest angle between the sides of an outline, or a little
/// more.
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
