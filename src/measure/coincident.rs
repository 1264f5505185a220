//! Pairs of surfaces that share an area.

use glam::DVec3;

use crate::math::Bounds;
use crate::scene::Scene;
use crate::surface::Surface;
use crate::visibility::{Overlaps, carriers};

/// Relative tolerance within which surfaces share a plane or an area.
///
/// Smaller, and tiles at rounded decimals are reported; larger, and a real overlap is not.
const SHARED_TOLERANCE: f64 = 1e-9;

/// Two surfaces that share an area, by their places in the scene file.
#[derive(Debug, Clone, Copy)]
pub(super) struct Coincidence {
    pub(super) earlier: usize,
    pub(super) later: usize,
    /// True if they share one carrier; otherwise their planes are equal but for rounding.
    pub(super) is_exact: bool,
}

/// For each surface, the first one before it that shares an area with it.
pub(super) fn coincidences(scene: &Scene) -> Vec<Coincidence> {
    let surfaces = &scene.surfaces;
    let carriers = carriers(surfaces);
    let boxes: Vec<_> = surfaces.iter().map(|it| padded_bounds(&**it)).collect();
    let overlaps = Overlaps::new(&boxes);
    let unbounded: Vec<_> = (0..boxes.len()).filter(|it| boxes[*it].is_none()).collect();
    let first = |later: usize| {
        let is_exact = |earlier: usize| carriers[earlier] == carriers[later];
        let coincide = |earlier: &usize| {
            let [one, other] = [*earlier, later].map(|it| &*surfaces[it]);
            (is_exact(*earlier) || nearly_one_plane(one, other)) && overlap(one, other)
        };
        let earlier = match &boxes[later] {
            None => (0..later).find(coincide),
            Some(bounds) => {
                let bounded = overlaps.first_before(later, bounds, |earlier| coincide(&earlier));
                let end = bounded.unwrap_or(later);
                let before = unbounded.iter().copied().take_while(|it| *it < end);
                before.into_iter().find(coincide).or(bounded)
            }
        }?;
        Some(Coincidence {
            earlier,
            later,
            is_exact: is_exact(earlier),
        })
    };
    (0..surfaces.len()).filter_map(first).collect()
}

/// Bounds of a surface and of all that nearly coincides with it; `None` if it is unbounded.
fn padded_bounds(surface: &dyn Surface) -> Option<Bounds> {
    let Bounds { min, max } = surface.shape().bounds()?;
    // A point nearly in its plane is closer than the tolerance times the distance of both.
    let margin = DVec3::splat(2.0 * SHARED_TOLERANCE * (max - min).element_sum());
    Some(Bounds {
        min: min - margin,
        max: max + margin,
    })
}

/// True if two planes are equal but for rounding.
fn nearly_one_plane(a: &dyn Surface, b: &dyn Surface) -> bool {
    let (Some(a), Some(b)) = (a.shape().carrier(), b.shape().carrier()) else {
        return false;
    };
    let way = b.point - a.point;
    a.normal.cross(b.normal).length() <= SHARED_TOLERANCE
        && a.normal.dot(way).abs() <= SHARED_TOLERANCE * way.length()
}

/// True if two surfaces on one carrier share an area.
fn overlap(a: &dyn Surface, b: &dyn Surface) -> bool {
    let Some(normal) = a.shape().carrier().map(|plane| plane.normal) else {
        // Round surfaces on one carrier are equal.
        return true;
    };
    let (a, b) = (a.shape().outline(), b.shape().outline());
    if a.is_empty() || b.is_empty() {
        // One of them is unbounded.
        return true;
    }
    let edges = |corners: &[DVec3]| -> Vec<_> {
        let next = corners.iter().cycle().skip(1);
        corners
            .iter()
            .zip(next)
            .map(|(from, to)| *to - *from)
            .collect()
    };
    // Separating axis theorem: two convex outlines are apart if an edge separates them.
    let mut edges = edges(&a).into_iter().chain(edges(&b));
    !edges.any(|edge| apart(&a, &b, normal.cross(edge)))
}

/// True if the projections of two outlines on an axis share no more than rounding.
fn apart(a: &[DVec3], b: &[DVec3], axis: DVec3) -> bool {
    let [(a_low, a_high), (b_low, b_high)] = [a, b].map(|corners| {
        let places = corners.iter().map(|corner| axis.dot(*corner));
        places.fold((f64::MAX, f64::MIN), |(low, high), place| {
            (low.min(place), high.max(place))
        })
    });
    let shared = a_high.min(b_high) - a_low.max(b_low);
    shared <= SHARED_TOLERANCE * (a_high - a_low).min(b_high - b_low)
}
