//! The finite plane.
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

use super::{Anatomy, Common, Hit, Shape, Surface};
use crate::language::{Attribute, Naming, Node, Range, Schema, Takes, ValueError};
use crate::math::exact::{Distance, ExactVector};
use crate::math::{ExactGeometry, Flat, Line, Ray, Rectangle, Rgb, Segment, Side, Span};

/// A finite plane, the chapter's `fplane_t`: a rectangle, in other renderers.
#[derive(Debug, Clone)]
pub struct FinitePlane {
    common: Common,
    rectangle: Rectangle,
    given_normal: DVec3,
    given_xdir: DVec3,
}

impl FinitePlane {
    /// The attributes that a rectangle adds to a plane's; its `point` is the lower-left corner.
    pub(crate) const ATTRIBUTES: &[Attribute] = &[
        Attribute::new("point", Takes::Triple, "the lower-left corner").unit("world units"),
        Attribute::new(
            "normal",
            Takes::Triple,
            "the direction it faces; any length but zero",
        ),
        Attribute::new(
            "xdir",
            Takes::Triple,
            "where its own x grows; projected into the plane",
        ),
        Attribute::new(
            "dimensions",
            Takes::Pair(Range::Positive),
            "width along x, height along y",
        )
        .unit("world units"),
    ];

    /// The `finite-plane` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "finite-plane",
        about: "A rectangle; all four borders belong to it.",
        naming: Naming::Optional,
        value: None,
        properties: &[],
        attributes: &[Common::ATTRIBUTES, Self::ATTRIBUTES],
    };

    /// A rectangle from its lower-left corner, normal, direction of x, width and height.
    ///
    /// # Errors
    /// Refuses a zero normal, an `xdir` that is zero or parallel to it, a size not above zero.
    pub fn new(
        common: Common,
        point: DVec3,
        normal: DVec3,
        xdir: DVec3,
        dimensions: DVec2,
    ) -> Result<Self, ValueError> {
        let rectangle = Rectangle::new(point, normal, xdir, dimensions)?;
        Ok(Self {
            common,
            rectangle,
            given_normal: normal,
            given_xdir: xdir,
        })
    }

    /// The shape.
    #[must_use]
    pub fn rectangle(&self) -> &Rectangle {
        &self.rectangle
    }

    /// The hit at this distance and offset from the corner.
    #[inline(always)]
    fn hit(&self, t: f64, error: f64, uv: DVec2) -> Hit {
        Hit {
            t,
            error,
            point: self.rectangle.point(uv),
            normal: self.rectangle.flat.normal,
            uv,
            texel: Rgb::WHITE,
        }
    }

    /// Adds the rectangle's attributes to a node.
    pub(super) fn describe_into(&self, node: Node) -> Node {
        node.with("point", self.rectangle.flat.point)
            .with("normal", self.given_normal)
            .with("xdir", self.given_xdir)
            .with("dimensions", self.rectangle.size)
    }
}

impl Surface for FinitePlane {
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        let hit = |t, error, uv| self.hit(t, error, uv);
        self.rectangle.hits(ray, span, hit)
    }

    fn meetings(&self, rays: &[Ray], met: &mut [Option<Hit>]) {
        for (ray, met) in rays.iter().zip(met) {
            // A hit is large, so it is made in its place.
            let hit = |t, error, uv| *met = Some(self.hit(t, error, uv));
            self.rectangle.hits(ray, Span::AHEAD, hit);
        }
    }

    fn common(&self) -> &Common {
        &self.common
    }

    fn anatomy(&self) -> Option<Anatomy<'_>> {
        let Rectangle {
            flat, frame, size, ..
        } = self.rectangle;
        Some(Anatomy::plain(Shape::Rectangle {
            corner: flat.point,
            axes: [frame.x, frame.y, flat.normal],
            size,
        }))
    }

    fn describe(&self) -> Node {
        self.describe_into(Node::new(&Self::SCHEMA, None))
    }

    fn flat(&self) -> Option<&Flat> {
        Some(&self.rectangle.flat)
    }

    fn outline(&self) -> Vec<DVec3> {
        self.rectangle.corners().to_vec()
    }

    fn hull(&self) -> Option<Vec<ExactVector>> {
        Some(self.rectangle.exact_corners().to_vec())
    }

    fn borders(&self) -> Vec<Line> {
        self.rectangle.borders().to_vec()
    }

    fn slack(&self) -> f64 {
        self.rectangle.slack()
    }

    fn exact_geometry(&self) -> Option<ExactGeometry> {
        let Rectangle { flat, size, .. } = self.rectangle;
        let (normal, xdir) = (self.given_normal, self.given_xdir);
        Some(ExactGeometry::rectangle(flat.point, normal, xdir, size))
    }

    fn weld(&mut self, plane: &Flat, borders: &[Option<Line>]) {
        let border = |index: usize| borders.get(index).copied().flatten();
        let borders = [0, 1, 2, 3].map(border);
        self.rectangle = self.rectangle.welded(plane, borders);
    }

    fn exact_distance(&self, ray: &Ray) -> Option<Distance> {
        self.rectangle.flat.exact_distance(ray)
    }

    fn occludes(&self, segment: &Segment, end: Side) -> bool {
        self.rectangle.occludes(segment, end)
    }
}
