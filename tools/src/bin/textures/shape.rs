//! Measures flat shapes: soft steps, and signed distances that are negative inside.

/// A point of the plane.
pub(crate) type Point = (f64, f64);

/// A soft step that rises from 0 at `from` to 1 at `to`, flat at both ends.
pub(crate) fn smooth(from: f64, to: f64, value: f64) -> f64 {
    let share = ((value - from) / (to - from)).clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// The part of a number after the point; from 0 to 1 for negative numbers too.
pub(crate) fn fraction(value: f64) -> f64 {
    value - value.floor()
}

/// A bump of height 1 at 0 that fades to nothing at the given reach.
pub(crate) fn bump(value: f64, reach: f64) -> f64 {
    1.0 - smooth(0.0, reach, value.abs())
}

/// The length of a vector.
pub(crate) fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// The distance from a point to a line segment.
pub(crate) fn segment(p: Point, a: Point, b: Point) -> f64 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let along = ((p.0 - a.0) * dx + (p.1 - a.1) * dy) / (dx * dx + dy * dy);
    let along = along.clamp(0.0, 1.0);
    length(p.0 - a.0 - along * dx, p.1 - a.1 - along * dy)
}

/// The signed distance to an upright ellipse, close enough for soft edges.
pub(crate) fn ellipse(p: Point, centre: Point, radii: Point) -> f64 {
    let (x, y) = ((p.0 - centre.0) / radii.0, (p.1 - centre.1) / radii.1);
    let reach = length(x, y);
    let slope = length(x / radii.0, y / radii.1);
    if slope == 0.0 {
        -radii.0.min(radii.1)
    } else {
        reach * (reach - 1.0) / slope
    }
}

/// The signed distance to an upright rectangle with rounded corners.
pub(crate) fn rectangle(p: Point, centre: Point, half: Point, rounding: f64) -> f64 {
    let x = (p.0 - centre.0).abs() - half.0 + rounding;
    let y = (p.1 - centre.1).abs() - half.1 + rounding;
    length(x.max(0.0), y.max(0.0)) + x.max(y).min(0.0) - rounding
}

/// The signed distance to a polygon without crossing sides.
pub(crate) fn polygon(p: Point, corners: &[Point]) -> f64 {
    let mut inside = false;
    let mut nearest = f64::INFINITY;
    for (index, &b) in corners.iter().enumerate() {
        let a = corners[(index + corners.len() - 1) % corners.len()];
        nearest = nearest.min(segment(p, a, b));
        if (a.1 > p.1) != (b.1 > p.1) && p.0 < (b.0 - a.0) * (p.1 - a.1) / (b.1 - a.1) + a.0 {
            inside = !inside;
        }
    }
    if inside { -nearest } else { nearest }
}

/// The distance to the nearest of some circles.
pub(crate) fn circles(p: Point, list: &[(f64, f64, f64)]) -> f64 {
    list.iter()
        .map(|c| length(p.0 - c.0, p.1 - c.1) - c.2)
        .fold(f64::INFINITY, f64::min)
}
