//! A rectangle in space: the shape of a finite plane and of a projector's slide.

use glam::{DVec2, DVec3};

use super::crossing::InDoubt;
use super::error_bounds::{EXTENT, MOMENT_PER_HEIGHT, UNDERFLOW};
use super::exact::ExactVector;
use super::line::inside_all;
use super::{
    Crossing, ExactFrame, ExactGeometry, Flat, Frame, Line, Point, Ray, Segment, Side, Span,
};
use crate::language::ValueError;

/// A rectangle with its lower-left corner, its axes and its size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    /// The plane it lies in; its point is the lower-left corner.
    pub flat: Flat,
    /// Its axes.
    pub frame: Frame,
    /// Width along x and height along y, in world units.
    pub size: DVec2,
    /// How far at most its own borders lie from the lines that decide, with what rounding of
    /// the size adds.
    slack: f64,
    /// The lines that decide: left, right, bottom and top.
    borders: [Line; 4],
}

impl Rectangle {
    /// A rectangle from its corner, the direction it faces, the direction of its x, and its size.
    ///
    /// # Errors
    /// Refuses a zero normal, an `xdir` that is zero or nearly parallel to it, a size not above
    /// zero.
    pub fn new(corner: DVec3, normal: DVec3, xdir: DVec3, size: DVec2) -> Result<Self, ValueError> {
        let flat = Flat::new(corner, normal)?;
        let exact = ExactFrame::new(normal, xdir);
        let frame = Frame::of(xdir, &exact)?;
        if !(size.is_finite() && size.min_element() > 0.0) {
            return Err(ValueError::new(
                "dimensions",
                "width and height must be above zero",
                "to turn a surface around, change its point, xdir or normal",
            ));
        }
        let mut borders = [
            Line::new(corner, frame.y, 0.0),
            Line::new(corner, -frame.y, size.x),
            Line::new(corner, -frame.x, 0.0),
            Line::new(corner, frame.x, size.y),
        ];
        let exact_geometry = ExactGeometry::framed(corner, exact, size);
        for (border, exact) in borders.iter_mut().zip(&exact_geometry.borders) {
            *border = exact.exact_line(&exact_geometry.normal).unwrap_or(*border);
        }
        Ok(Self {
            flat,
            frame,
            size,
            slack: EXTENT * size.max_element() + UNDERFLOW,
            borders,
        })
    }

    /// The same rectangle, decided by the plane and the lines that it shares with others.
    #[must_use]
    pub fn welded(self, to: &Flat, borders: [Option<Line>; 4]) -> Self {
        let flat = self.flat.welded(to);
        let mut welded = Self { flat, ..self };
        if borders.iter().all(Option::is_none) {
            return welded;
        }
        let ends = [[0, 3], [1, 2], [0, 1], [3, 2]];
        let corners = self.exact_corners();
        for ((border, line), ends) in welded.borders.iter_mut().zip(borders).zip(ends) {
            let Some(line) = line else { continue };
            *border = line;
            // A border is straight, so nowhere is it further off than at one of its ends.
            for end in ends {
                let apart = line.apart(&corners[end], &flat);
                welded.slack = welded.slack.max(self.slack + apart.next_up());
            }
        }
        welded
    }

    /// The corners, exactly, counter-clockwise from the lower left as seen from the front.
    #[must_use]
    pub fn exact_corners(&self) -> [ExactVector; 4] {
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| self.exact_corner(x, y))
    }

    /// A corner, from 0 and 1 for left and right, bottom and top.
    fn exact_corner(&self, x: f64, y: f64) -> ExactVector {
        let along = |axis: DVec3, length: f64| ExactVector::from(axis).times(&length.into());
        let x = along(self.frame.x, x * self.size.x);
        let y = along(self.frame.y, y * self.size.y);
        &(&ExactVector::from(self.flat.point) + &x) + &y
    }

    /// What `hit` makes of where a ray crosses the rectangle: its distance, how far at most that is
    /// from the exact one, and the offset from the corner along x and y in world units.
    ///
    /// All four borders belong to the rectangle, but for those that a neighbour owns.
    #[inline(always)]
    pub fn hits<H>(
        &self,
        ray: &Ray,
        span: Span,
        hit: impl FnOnce(f64, f64, DVec2) -> H,
    ) -> Option<H> {
        match self.flat.certain_crossing(ray) {
            Ok(crossing) => {
                let (t, error, offset) = self.met(&crossing?, ray, span)?;
                Some(hit(t, error, offset))
            }
            Err(InDoubt) => self.hits_in_doubt(ray, span, hit),
        }
    }

    /// As [`hits`](Self::hits), where rounded values leave doubt of the crossing.
    #[cold]
    #[inline(never)]
    fn hits_in_doubt<H>(
        &self,
        ray: &Ray,
        span: Span,
        hit: impl FnOnce(f64, f64, DVec2) -> H,
    ) -> Option<H> {
        let crossing = self.flat.doubtful_crossing(ray)?;
        let (t, error, offset) = self.met(&crossing, ray, span)?;
        Some(hit(t, error, offset))
    }

    /// Where a ray that crosses the plane there meets the rectangle, if it does.
    #[inline(always)]
    fn met(&self, crossing: &Crossing, ray: &Ray, span: Span) -> Option<(f64, f64, DVec2)> {
        if crossing.is_beyond(span) {
            return None;
        }
        let scaled = self.inside(crossing, ray)?;
        // Only a certain hit is divided.
        let t = crossing.distance();
        let error = crossing.error(t);
        if !span.admits(t, error) {
            return None;
        }
        let offset = scaled / crossing.slope.abs();
        Some((t, error, offset.max(DVec2::ZERO).min(self.size)))
    }

    /// Whether the rectangle stands between the ends of a segment, whose `end` is on this side.
    #[must_use]
    #[inline]
    pub fn occludes(&self, segment: &Segment, end: Side) -> bool {
        self.flat.separates(segment, end).is_some_and(|crossing| {
            self.inside(&crossing, &segment.ray).is_some() && segment.holds(&crossing, &self.flat)
        })
    }

    /// The offset from the corner times `|D|`, if the line of the ray passes inside.
    ///
    /// With `m = d × c`, `x D = y·m` and `y D = −x·m` (Binet–Cauchy), so the side of each border
    /// is decided by the line alone, before any division.
    #[inline(always)]
    fn inside(&self, crossing: &Crossing, ray: &Ray) -> Option<DVec2> {
        let moment = ray.dir.cross(crossing.origin);
        let scale = crossing.slope.abs();
        let sign = if crossing.rises { 1.0 } else { -1.0 };
        let mut doubt = MOMENT_PER_HEIGHT * crossing.doubt + self.slack;
        let exactly = || {
            let corners = || self.exact_corners().into();
            // A copy, so that the crossing itself need not be in memory where there is no doubt.
            inside_all(&self.borders, corners, ray, &self.flat, &{ *crossing })
        };

        let x = self.frame.y.dot(moment) * sign;
        let y = -self.frame.x.dot(moment) * sign;
        if crossing.is_delicate() {
            if crossing.at_start.is_some() {
                return exactly().then(|| DVec2::new(x, y));
            }
            doubt = self.doubt_along_plane(doubt, DVec2::new(x, y), scale);
        }
        let beyond_x = self.size.x * scale - x;
        if x < -doubt || beyond_x < -doubt {
            return None;
        }
        let beyond_y = self.size.y * scale - y;
        if y < -doubt || beyond_y < -doubt {
            return None;
        }
        let certain = x > doubt && beyond_x > doubt && y > doubt && beyond_y > doubt;
        let inside = if certain { true } else { exactly() };
        inside.then(|| DVec2::new(x, y))
    }

    /// What the scaled place of a crossing is off by for a ray nearly along the plane, whose borders are
    /// decided in the plane, if it is off by `doubt` for others.
    ///
    /// With the crossing `p` and the ray's part `d'` along the plane, `a·(d × p)` is the distance from the
    /// border in the plane, times `D`, plus `a·(d' × p)`. The latter is at most the height of the border's
    /// point above the plane, and for each unit from there to the crossing what the border rises: no more
    /// than from one end to the other of the shortest side, if at both it is as far off as it can be.
    #[cold]
    fn doubt_along_plane(&self, doubt: f64, scaled: DVec2, scale: f64) -> f64 {
        let far = scaled.abs().element_sum() / scale + self.size.element_sum();
        let rise = 2.0 * self.slack / self.size.min_element();
        2.0 * doubt + self.slack + rise * far
    }

    /// How far at most the lines that decide lie from its own borders and its plane.
    pub(crate) fn slack(&self) -> f64 {
        self.slack
    }

    /// The lines that decide its borders: left, right, bottom and top.
    #[must_use]
    pub fn borders(&self) -> &[Line; 4] {
        &self.borders
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
        unit_square().hits(&ray, Span::AHEAD, |_, _, offset| offset)
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
