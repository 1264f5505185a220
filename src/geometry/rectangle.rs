//! The rectangle: the chapter's finite plane.
//!
//! ```
//! # heliodon::doctest::surface(r#"
//! finite-plane "door" {
//!     material "gray"
//!     point -1 0 -2
//!     normal 0 0 1
//!     xdir 1 0 0
//!     dimensions 2 3
//! }
//! # "#, [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], Some(2.0));
//! ```

use glam::{DVec2, DVec3};

use super::{Hit, Planar};
use crate::language::{Attribute, Node, Range, Takes, ValueError};
use crate::math::error_bounds::{EXTENT, MOMENT_PER_HEIGHT, UNDERFLOW};
use crate::math::exact::{Distance, ExactVector};
use crate::math::{
    Crossing, ExactFrame, ExactGeometry, Flat, Frame, InDoubt, Line, Point, Ray, Segment, Side,
    Span, inside_all,
};

/// A rectangle with its lower-left corner, axes and size; the chapter's `fplane_t`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    /// The carrier plane; its point is the lower-left corner.
    pub flat: Flat,
    /// Its axes.
    pub frame: Frame,
    /// Width along x and height along y, in world units.
    pub size: DVec2,
    /// A bound of the distance between its own borders and those that decide.
    ///
    /// Rounding is included.
    border_error: f64,
    /// The borders that decide: left, right, bottom and top.
    borders: [Line; 4],
    given_normal: DVec3,
    given_xdir: DVec3,
}

impl Rectangle {
    /// The attributes of a rectangle's node; its `point` is the lower-left corner.
    pub const ATTRIBUTES: &[Attribute] = &[
        Attribute::new("point", Takes::Triple, "the lower-left corner").unit("world units"),
        Attribute::new(
            "normal",
            Takes::Triple,
            "the normal; any length except zero",
        ),
        Attribute::new(
            "xdir",
            Takes::Triple,
            "direction of its own x axis; projected into the plane",
        ),
        Attribute::new(
            "dimensions",
            Takes::Pair(Range::Positive),
            "width along its x axis, height along its y axis",
        )
        .unit("world units"),
    ];

    /// A rectangle from its corner, normal, x direction and size.
    ///
    /// # Errors
    /// Returns an error for a zero normal, an `xdir` that is zero or nearly parallel to it, and a
    /// size that is not above zero.
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
        let exact = ExactGeometry::framed(corner, exact, size);
        for (border, own) in borders.iter_mut().zip(&exact.borders) {
            *border = own.exact_line(&exact.normal).unwrap_or(*border);
        }
        Ok(Self {
            flat,
            frame,
            size,
            border_error: EXTENT * size.max_element() + UNDERFLOW,
            borders,
            given_normal: normal,
            given_xdir: xdir,
        })
    }

    /// The rectangle of a node.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn from_node(node: &Node) -> Result<Self, ValueError> {
        let [point, normal, xdir] = ["point", "normal", "xdir"].map(|word| node.triple(word));
        Self::new(point, normal, xdir, node.pair("dimensions"))
    }

    /// Adds the rectangle's attributes to a node.
    #[must_use]
    pub fn describe_into(&self, node: Node) -> Node {
        node.with("point", self.flat.point)
            .with("normal", self.given_normal)
            .with("xdir", self.given_xdir)
            .with("dimensions", self.size)
    }

    /// The point at an offset from the corner; it lies in the plane by construction.
    #[must_use]
    pub fn point(&self, offset: DVec2) -> Point {
        Point {
            anchor: self.flat.point,
            offset: self.frame.x * offset.x + self.frame.y * offset.y,
        }
    }

    /// The rounded corners, counter-clockwise from the lower left, seen from the front.
    #[must_use]
    pub fn corners(&self) -> [DVec3; 4] {
        let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        corners.map(|corner| self.point(corner * self.size).world())
    }

    /// The nearest hit of a ray in a span; its `uv` is the offset from the corner.
    ///
    /// All four borders belong to the rectangle, except those that a neighbour owns.
    #[must_use]
    #[inline(always)]
    pub fn intersect(&self, ray: &Ray, span: Span) -> Option<Hit> {
        match self.flat.certain_crossing(ray) {
            Ok(crossing) => self.hit(&crossing?, ray, span),
            Err(InDoubt) => self.intersect_in_doubt(ray, span),
        }
    }

    /// [`intersect`](Self::intersect) where rounded values do not decide the crossing.
    #[cold]
    #[inline(never)]
    fn intersect_in_doubt(&self, ray: &Ray, span: Span) -> Option<Hit> {
        self.hit(&self.flat.doubtful_crossing(ray)?, ray, span)
    }

    /// The hit of a ray with this crossing, if it is inside and in the span.
    #[inline(always)]
    fn hit(&self, crossing: &Crossing, ray: &Ray, span: Span) -> Option<Hit> {
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
        let uv = offset.max(DVec2::ZERO).min(self.size);
        Some(Hit {
            uv,
            ..Hit::new(t, error, self.point(uv), self.flat.normal)
        })
    }

    #[inline]
    pub(super) fn occludes(&self, segment: &Segment, end: Side) -> bool {
        self.flat.separates(segment, end).is_some_and(|crossing| {
            self.inside(&crossing, &segment.ray).is_some() && segment.holds(&crossing, &self.flat)
        })
    }

    pub(super) fn side(&self, point: &Point) -> Side {
        self.flat.side(point)
    }

    pub(super) fn exact_distance(&self, ray: &Ray) -> Option<Distance> {
        self.flat.exact_distance(ray)
    }

    pub(super) fn distance_error(&self, ray: &Ray, hit: &Hit) -> f64 {
        self.flat.error(ray, hit.t)
    }

    /// The offset from the corner times `|D|`, if the line of the ray passes inside.
    #[inline(always)]
    fn inside(&self, crossing: &Crossing, ray: &Ray) -> Option<DVec2> {
        // With m = d × c, x D = y·m and y D = −x·m (Binet–Cauchy), so the side of each border is
        // decided by the line alone, before any division.
        let moment = ray.dir.cross(crossing.origin);
        let scale = crossing.slope.abs();
        let sign = if crossing.rises { 1.0 } else { -1.0 };
        let mut bound = MOMENT_PER_HEIGHT * crossing.doubt + self.border_error;
        let exactly = || {
            let corners = || self.exact_corners();
            // A copy, so that the crossing itself need not be in memory on the fast path.
            inside_all(&self.borders, corners, ray, &self.flat, &{ *crossing })
        };

        let x = self.frame.y.dot(moment) * sign;
        let y = -self.frame.x.dot(moment) * sign;
        if crossing.is_delicate() {
            if crossing.at_start.is_some() {
                return exactly().then(|| DVec2::new(x, y));
            }
            bound = self.bound_of_grazing(bound, DVec2::new(x, y), scale);
        }
        let beyond_x = self.size.x * scale - x;
        if x < -bound || beyond_x < -bound {
            return None;
        }
        let beyond_y = self.size.y * scale - y;
        if y < -bound || beyond_y < -bound {
            return None;
        }
        let certain = x > bound && beyond_x > bound && y > bound && beyond_y > bound;
        let inside = if certain { true } else { exactly() };
        inside.then(|| DVec2::new(x, y))
    }

    /// The error bound of a scaled offset for a ray nearly along the plane.
    ///
    /// The borders of such a ray are decided in the plane. `bound` is the bound for other rays.
    #[cold]
    fn bound_of_grazing(&self, bound: f64, scaled: DVec2, scale: f64) -> f64 {
        // With the crossing p and the ray's part d' along the plane, a·(d × p) is the distance from
        // the border in the plane, times D, plus a·(d' × p). The latter is at most the height of
        // the border's point above the plane, and for each unit from there to the crossing what the
        // border rises: no more than from one end to the other of the shortest side, if both ends
        // are as far off as they can be.
        let far = scaled.abs().element_sum() / scale + self.size.element_sum();
        let rise = 2.0 * self.border_error / self.size.min_element();
        2.0 * bound + self.border_error + rise * far
    }

    /// A corner, from 0 and 1 for left and right, bottom and top.
    fn exact_corner(&self, x: f64, y: f64) -> ExactVector {
        let along = |axis: DVec3, length: f64| ExactVector::from(axis).times(&length.into());
        let x = along(self.frame.x, x * self.size.x);
        let y = along(self.frame.y, y * self.size.y);
        &(&ExactVector::from(self.flat.point) + &x) + &y
    }
}

impl Planar for Rectangle {
    fn carrier(&self) -> &Flat {
        &self.flat
    }

    fn exact_geometry(&self) -> ExactGeometry {
        let (normal, xdir) = (self.given_normal, self.given_xdir);
        ExactGeometry::rectangle(self.flat.point, normal, xdir, self.size)
    }

    fn share(&mut self, plane: &Flat, borders: &[Option<Line>]) {
        self.flat = self.flat.welded(plane);
        if borders.iter().all(Option::is_none) {
            return;
        }
        let ends = [[0, 3], [1, 2], [0, 1], [3, 2]];
        let corners = self.exact_corners();
        let own_error = self.border_error;
        for ((border, shared), ends) in self.borders.iter_mut().zip(borders).zip(ends) {
            let Some(shared) = shared else { continue };
            *border = *shared;
            // A border is straight, so nowhere is it further off than at one of its ends.
            for end in ends {
                let apart = shared.apart(&corners[end], &self.flat);
                self.border_error = self.border_error.max(own_error + apart.next_up());
            }
        }
    }

    fn outline(&self) -> Vec<DVec3> {
        self.corners().to_vec()
    }

    fn exact_corners(&self) -> Vec<ExactVector> {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        corners.map(|[x, y]| self.exact_corner(x, y)).into()
    }

    fn borders(&self) -> &[Line] {
        &self.borders
    }

    fn border_error(&self) -> f64 {
        self.border_error
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
        unit_square().intersect(&ray, Span::AHEAD).map(|hit| hit.uv)
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
