//! The way from a point to a light.

use glam::DVec3;

use super::{Departure, Point, Ray, Span, direction};

/// The straight way from a point on a surface to a scene point, such as a light.
#[derive(Debug, Clone, Copy)]
pub struct Segment {
    /// The ray from the start towards the end.
    pub ray: Ray,
    /// The scene point at the end.
    pub end: DVec3,
    /// The distance from start to end.
    pub length: f64,
    /// The distances at which something can stand in the way.
    pub span: Span,
}

impl Segment {
    /// The segment from a point on a surface to a scene point; `None` if they coincide.
    #[must_use]
    pub fn new(departure: Option<Departure>, start: Point, end: DVec3) -> Option<Self> {
        let way = -start.from(end);
        let length = way.length();
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        let ray = Ray::leaving(departure, start, direction(way));
        Some(Self {
            ray,
            end,
            length,
            span: Span::AHEAD,
        })
    }
}
