//! The way from a point to a light.

use glam::DVec3;

use super::{Crossing, Departure, Ray, Span, direction};

/// The straight way from a point on a surface to a scene point, such as a light.
#[derive(Debug, Clone, Copy)]
pub struct Segment<'a> {
    /// The ray from the start towards the end.
    pub ray: Ray<'a>,
    /// The scene point at the end.
    pub end: DVec3,
    /// The distance from start to end.
    pub length: f64,
    /// The distances at which something can stand in the way.
    pub span: Span,
}

impl<'a> Segment<'a> {
    /// The segment from a hit to a scene point; `None` if they coincide.
    #[must_use]
    pub fn new(departure: &'a Departure<'a>, end: DVec3) -> Option<Self> {
        let way = -departure.point.from(end);
        let length = way.length();
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        let ray = Ray::leaving(departure, direction(way));
        Some(Self {
            ray,
            end,
            length,
            span: Span::AHEAD,
        })
    }

    /// Whether a crossing that is known to lie between the ends counts.
    ///
    /// Of a segment that is nearly in the plane the distance of the crossing can be anything, even
    /// infinite; but it lies before the end.
    #[must_use]
    #[inline]
    pub fn holds(&self, crossing: &Crossing) -> bool {
        self.span.contains(crossing.distance().min(self.length))
    }
}
