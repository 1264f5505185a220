//! How much of what a small piece of a surface sees is a shape that shines: the share of the light
//! that a sky as bright as the shape would give it.
//!
//! Everything is seen from the piece, which lies at the origin with the unit `normal`; what is
//! below its horizon does not count. Factors are continuous, so no sign on the way needs to be
//! exact: what lies within rounding of the horizon gives as little as rounding.

use std::f64::consts::PI;

use glam::DVec3;

/// The form factor of a flat convex shape with these corners, which run counter-clockwise as seen
/// from its shining side; from 0 to 1.
///
/// The sum over the borders (Lambert 1760, "Photometria", and in vectors: Baum, Rushmeier and Winget
/// 1989, "Improving Radiosity Solutions Through the Use of Analytically Determined Form-Factors"),
/// each cut off at the horizon; a border along the horizon, where the cut is, gives nothing.
#[must_use]
pub fn of_polygon(corners: &[DVec3], normal: DVec3) -> f64 {
    let next = corners.iter().cycle().skip(1);
    let borders = corners.iter().zip(next);
    let parts = borders.filter_map(|(from, to)| {
        let (from, to) = above(*from, *to, normal)?;
        let across = from.cross(to);
        let sine = across.length();
        // A border that is seen from its own line has no width.
        (sine > 0.0).then(|| libm::atan2(sine, from.dot(to)) * (normal.dot(across) / sine))
    });
    // Seen from its shining side a shape runs clockwise around who looks along its light.
    let sum: f64 = parts.sum();
    (-sum / (2.0 * PI)).clamp(0.0, 1.0)
}

/// The part of a border above the horizon.
fn above(from: DVec3, to: DVec3, normal: DVec3) -> Option<(DVec3, DVec3)> {
    let (at_from, at_to) = (normal.dot(from), normal.dot(to));
    if at_from <= 0.0 && at_to <= 0.0 {
        return None;
    }
    // Where the border meets the horizon; divided only if the heights differ in sign.
    let horizon = || from + (to - from) * (at_from / (at_from - at_to));
    Some(if at_from < 0.0 {
        (horizon(), to)
    } else if at_to < 0.0 {
        (from, horizon())
    } else {
        (from, to)
    })
}

/// The form factor of a ball around `center`, seen from outside; from 0 to 1.
///
/// `(r/d)² cos θ` where the horizon does not cut it, and the integral over the part above it
/// otherwise (Hamilton and Morgan 1952, "Radiant-Interchange Configuration Factors", NACA TN 2836).
/// With `c = cos θ`, `s = r/d`, `q² = 1 − s²`, `x = c/s` and `k² = 1 − x²` that is
/// `(c s² acos(−c q / (s √(1 − c²))) − k q s + atan(k s / q)) / π`.
#[must_use]
pub fn of_ball(center: DVec3, radius: f64, normal: DVec3) -> f64 {
    let distance = center.length();
    let sine = (radius / distance).min(1.0);
    let cosine = normal.dot(center) / distance;
    let height = cosine / sine;
    if height <= -1.0 {
        return 0.0;
    }
    if height >= 1.0 {
        return (sine * sine * cosine).min(1.0);
    }
    let edge = ((distance - radius).max(0.0) * (distance + radius)).sqrt() / distance;
    let cut = ((1.0 - height) * (1.0 + height)).sqrt();
    let below = (-height * edge / ((1.0 - cosine) * (1.0 + cosine)).sqrt()).clamp(-1.0, 1.0);
    let cap = cosine * sine * sine * libm::acos(below);
    let rim = libm::atan2(cut * sine, edge) - cut * edge * sine;
    ((cap + rim) / PI).clamp(0.0, 1.0)
}

/// The form factor of a shape that looks as large as `area` from far away, where it is seen in the
/// direction of `center`.
#[must_use]
pub fn of_speck(center: DVec3, area: f64, normal: DVec3) -> f64 {
    let distance = center.length();
    let cosine = normal.dot(center) / distance;
    (cosine.max(0.0) * (area / distance / distance / PI)).min(1.0)
}
