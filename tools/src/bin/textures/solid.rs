//! Measures bodies in space: approximate distances, negative inside, and ways to combine them.

use crate::vector::{Vector, vector};

/// The approximate distance to an ellipsoid.
pub(crate) fn ball(p: Vector, centre: Vector, radii: Vector) -> f64 {
    let inverse = vector(1.0 / radii.x, 1.0 / radii.y, 1.0 / radii.z);
    let reach = (p - centre).scale(inverse);
    let slope = reach.scale(inverse).length();
    if slope == 0.0 {
        -radii.x
    } else {
        reach.length() * (reach.length() - 1.0) / slope
    }
}

/// The distance to a round rod from `a` to `b` whose radius changes from `first` to `last`.
pub(crate) fn cone(p: Vector, a: Vector, b: Vector, first: f64, last: f64) -> f64 {
    let (to, axis) = (p - a, b - a);
    let share = (to.dot(axis) / axis.dot(axis)).clamp(0.0, 1.0);
    (to - axis * share).length() - first - (last - first) * share
}

/// Joins two bodies with a fillet of the given size.
pub(crate) fn join(a: f64, b: f64, fillet: f64) -> f64 {
    let overlap = (fillet - (a - b).abs()).max(0.0) / fillet;
    a.min(b) - overlap * overlap * fillet / 4.0
}

/// Takes the second body away from the first, with a rounded edge.
pub(crate) fn carve(a: f64, b: f64, fillet: f64) -> f64 {
    -join(-a, b, fillet)
}
