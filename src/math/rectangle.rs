//! A rectangle in space: the shape of a finite plane and of a projector's slide.

use glam::{DVec2, DVec3};

use super::{Crossing, Flat, Frame, Point, Ray, Segment, Span};
use crate::language::Refusal;

/// A rectangle with its lower-left corner, its axes and its size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    /// The plane it lies in; its point is the lower-left corner.
    pub flat: Flat,
    /// Its axes.
    pub frame: Frame,
    /// Width along x and height along y, in world units.
    pub size: DVec2,
}

impl Rectangle {
    /// A rectangle from its corner, the direction it faces, the direction of its x, and its size.
    ///
    /// # Errors
    /// Refuses a zero normal, an `xdir` that is zero or parallel to it, a size not above zero.
    pub fn new(corner: DVec3, normal: DVec3, xdir: DVec3, size: DVec2) -> Result<Self, Refusal> {
        let flat = Flat::new(corner, normal)?;
        let frame = Frame::new(flat.normal, xdir)?;
        if !(size.is_finite() && size.min_element() > 0.0) {
            return Err(Refusal::new(
                "dimensions",
                "width and height must be above zero",
                "to turn a surface around, change its point, xdir or normal",
            ));
        }
        Ok(Self { flat, frame, size })
    }

    /// The distance of a hit and its offset from the corner along x and y, in world units.
    ///
    /// All four borders belong to the rectangle.
    #[must_use]
    pub fn hits(&self, ray: &Ray, span: Span) -> Option<(f64, DVec2)> {
        let crossing = self.flat.crossing(ray);
        if !crossing.is_ahead() {
            return None;
        }
        let scaled = self.inside(&crossing, ray)?;
        // Only a certain hit is divided.
        let t = crossing.distance();
        if !span.contains(t) {
            return None;
        }
        Some((t, (scaled / crossing.slope.abs()).min(self.size)))
    }

    /// Whether the rectangle stands between the ends of a segment.
    #[must_use]
    pub fn occludes(&self, segment: &Segment) -> bool {
        self.flat.separates(segment).is_some_and(|crossing| {
            self.inside(&crossing, &segment.ray).is_some()
                && segment.span.contains(crossing.distance())
        })
    }

    /// The offset from the corner times `|D|`, if the line of the ray passes inside.
    ///
    /// With `m = d × c`, `x D = y·m` and `y D = −x·m` (Binet–Cauchy), so the side of each border
    /// is decided by the line alone, before any division.
    fn inside(&self, crossing: &Crossing, ray: &Ray) -> Option<DVec2> {
        let moment = ray.dir.cross(crossing.origin);
        let scale = crossing.slope.abs();
        let sign = crossing.slope.signum();
        let x = self.frame.y.dot(moment) * sign;
        if !(x >= 0.0 && x <= self.size.x * scale) {
            return None;
        }
        let y = -self.frame.x.dot(moment) * sign;
        (y >= 0.0 && y <= self.size.y * scale).then(|| DVec2::new(x, y))
    }

    /// The point at an offset from the corner; it lies in the plane by construction.
    #[must_use]
    pub fn point(&self, offset: DVec2) -> Point {
        Point {
            anchor: self.flat.point,
            offset: self.frame.x * offset.x + self.frame.y * offset.y,
        }
    }

    /// The corners, counter-clockwise from the lower left as seen from the front.
    #[must_use]
    pub fn corners(&self) -> [DVec3; 4] {
        let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        corners.map(|corner| self.point(corner * self.size).world())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit_square() -> Rectangle {
        Rectangle::new(DVec3::ZERO, DVec3::Z, DVec3::X, DVec2::ONE).expect("a rectangle")
    }

    fn hits(x: f64, y: f64) -> Option<DVec2> {
        let ray = Ray::new(Point::exact(DVec3::new(x, y, 1.0)), DVec3::NEG_Z);
        unit_square()
            .hits(&ray, Span::AHEAD)
            .map(|(_, offset)| offset)
    }

    #[test]
    fn borders_and_corners_belong_to_a_rectangle() {
        for (x, y) in [
            (0.0, 0.5),
            (1.0, 0.5),
            (0.5, 0.0),
            (0.5, 1.0),
            (0.0, 0.0),
            (1.0, 1.0),
        ] {
            assert_eq!(hits(x, y), Some(DVec2::new(x, y)));
        }
    }

    #[test]
    fn the_next_number_outside_misses() {
        let (above, below) = (1.0 + f64::EPSILON, -5e-324);
        for (x, y) in [(below, 0.5), (above, 0.5), (0.5, below), (0.5, above)] {
            assert_eq!(hits(x, y), None, "{x} {y}");
        }
    }
}
