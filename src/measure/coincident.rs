//! Surfaces that lie in the same place.

use glam::DVec3;

use super::check::{title, warning};
use crate::accel::{Overlaps, supports};
use crate::language::Diagnostic;
use crate::math::Bounds;
use crate::scene::Scene;
use crate::surface::Surface;

/// How much of its own size is taken for rounding when surfaces share a plane or an area.
///
/// Smaller, and tiles at rounded decimals are remarked on; larger, and a real overlap is not.
const SHARED_TOLERANCE: f64 = 1e-9;

/// Surfaces on one sheet, or nearly, that share an area.
pub(super) fn coincident(scene: &Scene) -> Vec<Diagnostic> {
    let supports = supports(&scene.surfaces);
    let boxes: Vec<_> = scene
        .surfaces
        .iter()
        .map(|surface| near(&**surface))
        .collect();
    let overlaps = Overlaps::new(&boxes);
    let endless: Vec<_> = (0..boxes.len())
        .filter(|index| boxes[*index].is_none())
        .collect();
    let mut problems = Vec::new();
    for (index, later) in scene.surfaces.iter().enumerate() {
        let same = |earlier: &usize| supports[*earlier] == supports[index];
        let meets = |earlier: &usize| {
            let other = &*scene.surfaces[*earlier];
            (same(earlier) || nearly_one_plane(other, &**later)) && overlap(other, &**later)
        };
        let first = match &boxes[index] {
            None => (0..index).find(meets),
            Some(bounds) => {
                let bounded = overlaps.first_before(index, bounds, |earlier| meets(&earlier));
                let before = endless
                    .iter()
                    .take_while(|earlier| **earlier < index)
                    .copied();
                before
                    .take_while(|earlier| bounded.is_none_or(|first| *earlier < first))
                    .find(meets)
                    .or(bounded)
            }
        };
        let Some(earlier) = first else { continue };
        let other = &scene.surfaces[earlier];
        let name = other.common().name.as_deref();
        let other_title = title(&other.describe(), name);
        let what = match later.flat() {
            Some(_) => format!("lies in the same plane as {other_title}"),
            None => format!("coincides with {other_title}"),
        };
        let label = if same(&earlier) {
            "where they overlap, the first in the file is seen"
        } else {
            "where they overlap, rounding decides which is seen"
        };
        let problem = warning(&**later, &what, label);
        let help = "move one of them a little if both are to be seen";
        problems.extend(problem.map(|problem| problem.help(help)));
    }
    problems
}

/// The box around a surface that has an end, and around all that nearly coincides with it.
fn near(surface: &dyn Surface) -> Option<Bounds> {
    let Bounds { min, max } = surface.bounds()?;
    // What is nearly in its plane is nearer than that times the distance of both.
    let margin = DVec3::splat(2.0 * SHARED_TOLERANCE * (max - min).element_sum());
    Some(Bounds {
        min: min - margin,
        max: max + margin,
    })
}

/// Whether two planes are the same but for rounding.
fn nearly_one_plane(a: &dyn Surface, b: &dyn Surface) -> bool {
    let (Some(a), Some(b)) = (a.flat(), b.flat()) else {
        return false;
    };
    let way = b.point - a.point;
    a.normal.cross(b.normal).length() <= SHARED_TOLERANCE
        && a.normal.dot(way).abs() <= SHARED_TOLERANCE * way.length()
}

/// Whether two surfaces in one plane share an area.
///
/// Two convex outlines are apart if one of their edges has one of them on either side (the
/// separating axis theorem).
fn overlap(a: &dyn Surface, b: &dyn Surface) -> bool {
    let Some(normal) = a.flat().map(|flat| flat.normal) else {
        // Round surfaces on one sheet are the same.
        return true;
    };
    let (a, b) = (a.outline(), b.outline());
    if a.is_empty() || b.is_empty() {
        // One of them has no end.
        return true;
    }
    let edges = |corners: &[DVec3]| {
        let next = corners.iter().cycle().skip(1);
        let edges = corners.iter().zip(next).map(|(from, to)| *to - *from);
        edges.collect::<Vec<_>>()
    };
    let all_edges = edges(&a).into_iter().chain(edges(&b));
    !all_edges
        .into_iter()
        .any(|edge| apart(&a, &b, normal.cross(edge)))
}

/// Whether the shadows of two outlines on an axis share no more than rounding.
fn apart(a: &[DVec3], b: &[DVec3], axis: DVec3) -> bool {
    let span = |corners: &[DVec3]| {
        let places = corners.iter().map(|corner| axis.dot(*corner));
        places.fold((f64::MAX, f64::MIN), |(low, high), place| {
            (low.min(place), high.max(place))
        })
    };
    let ((a_low, a_high), (b_low, b_high)) = (span(a), span(b));
    let shared = a_high.min(b_high) - a_low.max(b_low);
    shared <= SHARED_TOLERANCE * (a_high - a_low).min(b_high - b_low)
}
