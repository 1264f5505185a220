//! Segments: shadow rays from a point to a light.

use glam::DVec3;

use super::{Crossing, Flat, Limits, Point, Ray, RayOrigin, Span, direction};

/// A line segment from a point on a surface to another point, such as a light.
#[derive(Debug, Clone, Copy)]
pub struct Segment<'a> {
    /// The ray from the start towards the end.
    pub ray: Ray<'a>,
    /// The point at the end.
    pub end: Point,
    /// The distance from start to end.
    pub length: f64,
    /// A plane across the z axis; nothing above it occludes.
    pub screen: Option<&'a Flat>,
}

impl<'a> Segment<'a> {
    /// The segment from a hit to a point; `None` if they coincide.
    #[must_use]
    #[inline]
    pub fn new(ray_origin: &'a RayOrigin<'a>, end: impl Into<Point>) -> Option<Self> {
        Self::along(ray_origin.point, end.into(), |dir| {
            Ray::spawn(ray_origin, dir)
        })
    }

    /// The segment from a point in free space to another; `None` if they coincide.
    #[must_use]
    pub fn free(start: Point, end: impl Into<Point>) -> Option<Self> {
        Self::along(start, end.into(), |dir| Ray::new(start, dir))
    }

    #[inline]
    fn along(start: Point, end: Point, ray: impl FnOnce(DVec3) -> Ray<'a>) -> Option<Self> {
        let way = end.way_from(&start);
        let length = way.length();
        (length > 0.0 && length.is_finite()).then(|| Self {
            ray: ray(direction(way)),
            end,
            length,
            screen: None,
        })
    }

    /// Returns whether a crossing that lies between the ends counts.
    ///
    /// The rounded distance of a crossing nearly in the plane can have any value, even infinity. It
    /// is therefore limited to the length of the segment.
    #[must_use]
    #[inline]
    pub fn holds(&self, crossing: &Crossing, flat: &Flat) -> bool {
        let t = crossing.distance();
        let error = || crossing.error(t);
        self.admits(t.min(self.length), error, Some(flat))
    }

    /// Returns whether a hit between the ends, at distance `t`, counts.
    ///
    /// `flat` is the plane of the surface, if it has one.
    #[must_use]
    #[inline]
    pub fn admits(&self, t: f64, error: impl FnOnce() -> f64, flat: Option<&Flat>) -> bool {
        let Some(screen) = self.screen else {
            return Span::AHEAD.contains(t);
        };
        let (limits, error) = (Limits::below(screen, &self.ray), error());
        limits.span().admits(t, error) && limits.hold(t, error, flat)
    }

    /// The distances at which an occluder counts.
    #[must_use]
    pub fn limits(&self) -> Limits<'a> {
        self.screen
            .map_or(Limits::AHEAD, |screen| Limits::below(screen, &self.ray))
    }
}
