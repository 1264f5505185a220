//! The triangle.
//!
//! ```
//! # heliodon::doctest::surface(r#"
//! triangle "sail" {
//!     material "gray"
//!     vertex1 -1 0 -2
//!     vertex2 1 0 -2
//!     vertex3 0 3 -2
//! }
//! # "#, [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], Some(2.0));
//! ```

use glam::{DVec2, DVec3};

use super::{Anatomy, Common, Hit, Shape, Surface};
use crate::language::{Attribute, Naming, Node, Refusal, Schema, Takes};
use crate::math::{Flat, Ray, Segment, Span};

/// A triangle, lit on the side from which its vertices run counter-clockwise.
#[derive(Debug, Clone)]
pub struct Triangle {
    common: Common,
    vertices: [DVec3; 3],
    flat: Flat,
}

impl Triangle {
    /// The `triangle` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "triangle",
        about: "A triangle, lit on the side from which its vertices run counter-clockwise.",
        naming: Naming::Optional,
        value: None,
        properties: &[],
        attributes: &[
            Common::ATTRIBUTES,
            &[
                Attribute::new("vertex1", Takes::Triple, "the first corner").unit("world units"),
                Attribute::new("vertex2", Takes::Triple, "the second corner").unit("world units"),
                Attribute::new("vertex3", Takes::Triple, "the third corner").unit("world units"),
            ],
        ],
    };

    /// A triangle from its corners.
    ///
    /// # Errors
    /// Refuses corners that lie on one line.
    pub fn new(common: Common, vertices: [DVec3; 3]) -> Result<Self, Refusal> {
        let [a, b, c] = vertices;
        let normal = (b - a).cross(c - a);
        let flat = Flat::new(a, normal).map_err(|_| {
            Refusal::new(
                "vertex3",
                "the three vertices lie on one line",
                "a triangle needs three corners that are not in line",
            )
            .expected("expected a point off the line through the other two")
        })?;
        Ok(Self {
            common,
            vertices,
            flat,
        })
    }

    /// Whether the line of a ray passes inside, borders included.
    ///
    /// The side of each edge is the sign of a determinant of the line and the edge's two ends;
    /// neighbours that share the edge compute it from the same numbers, with the sign reversed.
    fn contains_line(&self, ray: &Ray) -> bool {
        // Written out, because mapping these arrays costs twice as much as the arithmetic.
        let [a, b, c] = self.vertices;
        let (a, b, c) = (
            -ray.origin.from(a),
            -ray.origin.from(b),
            -ray.origin.from(c),
        );
        let side = |from: DVec3, to: DVec3| ray.dir.dot(from.cross(to));
        let sides = [side(a, b), side(b, c), side(c, a)];
        sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0)
    }
}

impl Surface for Triangle {
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        let crossing = self.flat.crossing(ray);
        if !(crossing.is_ahead() && self.contains_line(ray)) {
            return None;
        }
        let t = Some(crossing.distance()).filter(|t| span.contains(*t))?;
        let point = self.flat.foot(ray, t);
        Some(Hit {
            t,
            point,
            normal: self.flat.normal,
            uv: DVec2::ZERO,
        })
    }

    fn common(&self) -> &Common {
        &self.common
    }

    fn anatomy(&self) -> Option<Anatomy<'_>> {
        Some(Anatomy::plain(Shape::Triangle {
            vertices: self.vertices,
            normal: self.flat.normal,
        }))
    }

    fn describe(&self) -> Node {
        let [a, b, c] = self.vertices;
        Node::new(&Self::SCHEMA, None)
            .with("vertex1", a)
            .with("vertex2", b)
            .with("vertex3", c)
    }

    fn flat(&self) -> Option<Flat> {
        Some(self.flat)
    }

    fn outline(&self) -> Vec<DVec3> {
        self.vertices.to_vec()
    }

    fn occludes(&self, segment: &Segment) -> bool {
        self.flat.separates(segment).is_some_and(|crossing| {
            self.contains_line(&segment.ray) && segment.span.contains(crossing.distance())
        })
    }
}
