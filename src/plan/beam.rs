//! Tests whether the beam of a light certainly misses a surface.

use glam::DVec3;

use crate::geometry::Rectangle;
use crate::light::Cone;
use crate::math::error_bounds::{APART, BEAM_NORMAL};
use crate::math::{Ball, Bounds, Point, is_clear};

/// Returns whether a cone of light certainly misses a box.
pub(super) fn cone_misses(location: DVec3, cone: &Cone, bounds: &Bounds) -> bool {
    Ball::around(bounds).is_outside(location, cone.axis(), cone.angle())
}

/// Returns whether light through a slide certainly misses a box.
///
/// True if a plane through the light and a border of the slide separates the slide from the box, by
/// more than the rounding error of the plane and the points.
pub(super) fn slide_misses(location: DVec3, slide: &Rectangle, bounds: &Bounds) -> bool {
    let corners = slide.corners();
    let next = corners.iter().cycle().skip(1);
    let inner = corners.iter().cycle().skip(2);
    let mut borders = corners.iter().zip(next).zip(inner);
    borders.any(|((from, to), inner)| {
        let Some(normal) = normal(location, *from, *to) else {
            return false;
        };
        let sine = |point: DVec3| {
            let offset = point - location;
            let distance = offset.length();
            is_clear(location, point, distance).then(|| normal.dot(offset) / distance)
        };
        let Some(inside) = sine(*inner).filter(|sine| sine.abs() > APART) else {
            return false;
        };
        let is_outside =
            |corner: &DVec3| sine(*corner).is_some_and(|sine| sine * inside.signum() < -APART);
        bounds.corners().iter().all(is_outside)
    })
}

/// The unit normal of the plane through a light and a border.
///
/// `None` if its error may exceed a sixteenth of [`APART`], as for a border in line with the light.
fn normal(light: DVec3, from: DVec3, to: DVec3) -> Option<DVec3> {
    let [to_start, to_end] = [from, to].map(|corner| corner - light);
    let normal = to_start.cross(to_end);
    let length = normal.length();
    let size: f64 = [light, from, to]
        .map(|it| Point::exact(it).size())
        .iter()
        .sum();
    let bound = BEAM_NORMAL * size * (to_start.length() + to_end.length());
    (bound < APART / 16.0 * length).then(|| normal / length)
}
