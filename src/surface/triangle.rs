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
use crate::language::{Attribute, Naming, Node, Schema, Takes, ValueError};
use crate::math::error_bounds::{EXTENT, MOMENT, UNDERFLOW};
use crate::math::exact::{Distance, ExactVector};
use crate::math::{
    Crossing, ExactGeometry, Flat, Line, Point, Ray, Rgb, Segment, Side, Span, inside_all,
};

/// A triangle, lit on the side from which its vertices run counter-clockwise.
#[derive(Debug, Clone)]
pub struct Triangle {
    common: Common,
    vertices: [DVec3; 3],
    flat: Flat,
    /// From each vertex to the next.
    edges: [DVec3; 3],
    /// The lines that decide.
    borders: [Line; 3],
    /// How far at most its own borders lie from the lines that decide.
    slack: f64,
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
    pub fn new(common: Common, vertices: [DVec3; 3]) -> Result<Self, ValueError> {
        let [a, b, c] = vertices;
        let edge = |to: DVec3| Point::exact(to).exactly_from(a);
        let normal = edge(b).cross(&edge(c)).unit();
        // What the file says in decimals may be in line though the doubles next to them are not.
        let meant = ExactGeometry::polygon(&vertices).normal;
        if normal == DVec3::ZERO || meant.is_zero() {
            return Err(ValueError::new(
                "vertex3",
                "the three vertices lie on one line",
                "a triangle needs three corners that are not in line",
            )
            .expected("expected a point off the line through the other two"));
        }
        Ok(Self {
            common,
            vertices,
            flat: Flat::with_unit_normal(a, normal),
            edges: [b - a, c - b, a - c],
            borders: [
                Line::between(b, a),
                Line::between(c, b),
                Line::between(a, c),
            ],
            slack: UNDERFLOW,
        })
    }

    /// Whether the line of a ray passes inside, borders included but for those that a neighbour
    /// owns.
    ///
    /// For the edge `e` from a vertex `v`, and `c` from `v` to the ray's origin, `e·(d × c)` is
    /// the distance of the crossing from the edge times `n·d` and the edge's length.
    fn contains_line(&self, ray: &Ray, crossing: &Crossing) -> bool {
        let sign = if crossing.rises { -1.0 } else { 1.0 };
        let exactly = || {
            let corners = || self.vertices.map(ExactVector::from).into();
            inside_all(&self.borders, corners, ray, &self.flat, crossing)
        };
        if crossing.at_start.is_some() {
            return exactly();
        }
        let along_plane = crossing.grazing.is_some();
        let mut certain = true;
        for (vertex, edge) in self.vertices.into_iter().zip(self.edges) {
            let (origin, size) = ray.origin.seen_from(vertex);
            let side = edge.dot(ray.dir.cross(origin)) * sign;
            let length = edge.abs().element_sum();
            let mut doubt = (MOMENT * size + self.slack) * length + UNDERFLOW;
            if along_plane {
                doubt = 2.0 * doubt + self.rise(edge, size + crossing.distance());
            }
            if side < -doubt {
                return false;
            }
            certain &= side > doubt;
        }
        certain || exactly()
    }

    /// What the side of an edge is off by for a ray nearly along the plane that crosses it so far
    /// from a vertex at most, because the edge is decided in the plane.
    ///
    /// As on a rectangle this is the height of the edge above the plane, there, times its length. The
    /// vertices lie off the plane by the rounding of the normal, and by what the plane is welded to.
    #[cold]
    fn rise(&self, edge: DVec3, far: f64) -> f64 {
        let length = edge.abs().element_sum();
        let around: f64 = self.edges.iter().map(|edge| edge.abs().element_sum()).sum();
        (EXTENT * length + 2.0 * self.slack) * far + (EXTENT * around + self.slack) * length
    }

    /// Moves a point that lies beside the triangle to where it has any part.
    ///
    /// Where a ray nearly along the plane crosses it is known less well than that it does so inside.
    fn hold(&self, point: &mut Point) {
        let inward = [2, 0, 1].map(|index| {
            let way = point.from(self.vertices[index]);
            self.flat.normal.dot(self.edges[index].cross(way))
        });
        if inward.iter().all(|inward| *inward >= 0.0) {
            return;
        }
        let shares = inward.map(|inward| inward.max(0.0));
        let [of_b, of_c, _] = shares.map(|share| share / shares.iter().sum::<f64>());
        let offset = self.edges[0] * of_b - self.edges[2] * of_c;
        if offset.is_finite() {
            point.offset = offset;
        }
    }
}

impl Surface for Triangle {
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        let crossing = self.flat.crossing(ray)?;
        if crossing.is_beyond(span) || !self.contains_line(ray, &crossing) {
            return None;
        }
        let t = crossing.distance();
        let error = crossing.error(t);
        if !span.admits(t, error) {
            return None;
        }
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

    fn flat(&self) -> Option<&Flat> {
        Some(&self.flat)
    }

    fn outline(&self) -> Vec<DVec3> {
        self.vertices.to_vec()
    }

    fn hull(&self) -> Option<Vec<ExactVector>> {
        Some(self.vertices.map(ExactVector::from).to_vec())
    }

    fn settle(&self, hit: &mut Hit, _ray: &Ray) {
        self.hold(&mut hit.point);
    }

    fn borders(&self) -> Vec<Line> {
        self.borders.to_vec()
    }

    fn slack(&self) -> f64 {
        self.slack
    }

    fn exact_geometry(&self) -> Option<ExactGeometry> {
        Some(ExactGeometry::polygon(&self.vertices))
    }

    fn weld(&mut self, plane: &Flat, borders: &[Option<Line>]) {
        self.flat = self.flat.welded(plane);
        let [a, b, c] = self.vertices;
        let shared = self
            .borders
            .iter_mut()
            .zip(borders)
            .zip([[a, b], [b, c], [c, a]]);
        for ((border, line), ends) in shared {
            let Some(line) = line else { continue };
            *border = *line;
            for end in ends {
                let apart = line.apart(&end.into(), &self.flat);
                self.slack = self.slack.max(apart.next_up());
            }
        }
    }

    fn exact_distance(&self, ray: &Ray) -> Option<Distance> {
        self.flat.exact_distance(ray)
    }

    fn occludes(&self, segment: &Segment, end: Side) -> bool {
        self.flat.separates(segment, end).is_some_and(|crossing| {
            self.contains_line(&segment.ray, &crossing) && segment.holds(&crossing, &self.flat)
        })
    }
}
