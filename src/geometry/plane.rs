//! The unbounded plane.
//!
//! ```
//! # heliodon::doctest::surface(r#"
//! plane "floor" {
//!     material "gray"
//!     point 0 0 0
//!     normal 0 1 0
//! }
//! # "#, [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], Some(1.0));
//! ```

use glam::DVec3;

use super::{Hit, Planar};
use crate::language::{Attribute, Node, Takes, ValueError};
use crate::math::exact::Distance;
use crate::math::{ExactGeometry, Flat, Line, Point, Ray, Segment, Side, Span};

/// An unbounded plane; the chapter's `plane_t`.
#[derive(Debug, Clone)]
pub struct Plane {
    flat: Flat,
    given_point: DVec3,
    given_normal: DVec3,
}

impl Plane {
    /// The attributes of a plane's node.
    pub const ATTRIBUTES: &[Attribute] = &[
        Attribute::new("point", Takes::Triple, "a point in the plane").unit("world units"),
        Attribute::new(
            "normal",
            Takes::Triple,
            "the normal; any length except zero",
        ),
    ];

    /// A plane through a point.
    ///
    /// # Errors
    /// Returns an error if the normal is zero.
    pub fn new(point: DVec3, normal: DVec3) -> Result<Self, ValueError> {
        Ok(Self {
            flat: Flat::new(point, normal)?,
            given_point: point,
            given_normal: normal,
        })
    }

    /// The plane of a node.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn from_node(node: &Node) -> Result<Self, ValueError> {
        Self::new(node.triple("point"), node.triple("normal"))
    }

    /// The same plane, anchored near an eye that may be far away; see [`Flat::near`].
    ///
    /// Its hits are then no longer offsets from the scene's point.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn near(self, eye: DVec3) -> Result<Self, ValueError> {
        let flat = Flat::near(eye, self.given_point, self.given_normal)?;
        Ok(Self { flat, ..self })
    }

    /// The normal as the scene gives it.
    #[must_use]
    pub fn given_normal(&self) -> DVec3 {
        self.given_normal
    }

    /// Adds the plane's attributes to a node.
    #[must_use]
    pub fn describe_into(&self, node: Node) -> Node {
        node.with("point", self.given_point)
            .with("normal", self.given_normal)
    }

    #[inline(always)]
    pub(super) fn intersect(&self, ray: &Ray, span: Span) -> Option<Hit> {
        let (t, error) = self.flat.hits(ray, span)?;
        let point = self.flat.foot(ray, t);
        Some(Hit::new(t, error, point, self.flat.normal))
    }

    pub(super) fn occludes(&self, segment: &Segment, end: Side) -> bool {
        let crossing = self.flat.separates(segment, end);
        crossing.is_some_and(|crossing| segment.holds(&crossing, &self.flat))
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
}

impl Planar for Plane {
    fn carrier(&self) -> &Flat {
        &self.flat
    }

    fn exact_geometry(&self) -> ExactGeometry {
        ExactGeometry::plane(self.given_point, self.given_normal)
    }

    fn share(&mut self, plane: &Flat, _borders: &[Option<Line>]) {
        self.flat = self.flat.welded(plane);
    }
}
