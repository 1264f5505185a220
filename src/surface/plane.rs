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

use glam::{DVec2, DVec3};

use super::{Anatomy, Common, Hit, Shape, Surface};
use crate::language::{Attribute, Naming, Node, Schema, Takes, ValueError};
use crate::math::exact::Distance;
use crate::math::{ExactGeometry, Flat, Line, Ray, Rgb, Segment, Side, Span};

/// An unbounded plane; the chapter's `plane_t`.
#[derive(Debug, Clone)]
pub struct Plane {
    common: Common,
    flat: Flat,
    given_point: DVec3,
    given_normal: DVec3,
}

impl Plane {
    /// The attributes that a plane and what is made of one take.
    pub(super) const ATTRIBUTES: &[Attribute] = &[
        Attribute::new("point", Takes::Triple, "a point in the plane").unit("world units"),
        Attribute::new(
            "normal",
            Takes::Triple,
            "the direction it faces; any length but zero",
        ),
    ];

    /// The `plane` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "plane",
        about: "An unbounded plane, lit on the side that its normal points to.",
        naming: Naming::Optional,
        value: None,
        properties: &[],
        attributes: &[Common::ATTRIBUTES, Self::ATTRIBUTES],
    };

    /// A plane through a point.
    ///
    /// # Errors
    /// Refuses a zero normal.
    pub fn new(common: Common, point: DVec3, normal: DVec3) -> Result<Self, ValueError> {
        Ok(Self {
            common,
            flat: Flat::new(point, normal)?,
            given_point: point,
            given_normal: normal,
        })
    }

    /// The same plane for an eye that may be very far from its point; see [`Flat::near`].
    ///
    /// Its hits are then no longer offsets from the point.
    ///
    /// # Errors
    /// None that [`new`](Self::new) has not.
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
    pub(super) fn describe_into(&self, node: Node) -> Node {
        node.with("point", self.given_point)
            .with("normal", self.given_normal)
    }
}

impl Surface for Plane {
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        let (t, error) = self.flat.hits(ray, span)?;
        let point = self.flat.foot(ray, t);
        Some(Hit {
            t,
            error,
            point,
            normal: self.flat.normal,
            uv: DVec2::ZERO,
            texel: Rgb::WHITE,
        })
    }

    fn common(&self) -> &Common {
        &self.common
    }

    fn anatomy(&self) -> Option<Anatomy<'_>> {
        Some(Anatomy::plain(Shape::Plane {
            point: self.flat.point,
            normal: self.flat.normal,
        }))
    }

    fn describe(&self) -> Node {
        self.describe_into(Node::new(&Self::SCHEMA, None))
    }

    fn flat(&self) -> Option<&Flat> {
        Some(&self.flat)
    }

    fn exact_geometry(&self) -> Option<ExactGeometry> {
        Some(ExactGeometry::plane(self.given_point, self.given_normal))
    }

    fn weld(&mut self, plane: &Flat, _borders: &[Option<Line>]) {
        self.flat = self.flat.welded(plane);
    }

    fn plain_ambient(&self) -> Option<Rgb> {
        Some(self.common.material.ambient)
    }

    fn exact_distance(&self, ray: &Ray) -> Option<Distance> {
        self.flat.exact_distance(ray)
    }

    fn occludes(&self, segment: &Segment, end: Side) -> bool {
        let crossing = self.flat.separates(segment, end);
        crossing.is_some_and(|crossing| segment.holds(&crossing, &self.flat))
    }
}
