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

use glam::DVec3;

use super::{Hit, Planar};
use crate::language::{Attribute, Node, Takes, ValueError};
use crate::math::error_bounds::{EXTENT, MOMENT, UNDERFLOW};
use crate::math::exact::{Distance, ExactVector};
use crate::math::{
    Crossing, ExactGeometry, Flat, Line, Point, Ray, Segment, Side, Span, inside_all,
};

/// A triangle, lit on the side from which its vertices run counter-clockwise.
#[derive(Debug, Clone)]
pub struct Triangle {
    vertices: [DVec3; 3],
    flat: Flat,
    /// From each vertex to the next.
    edges: [DVec3; 3],
    /// The borders that decide.
    borders: [Line; 3],
    /// A bound of the distance between its own borders and those that decide.
    border_error: f64,
}

impl Triangle {
    /// The attributes of a triangle's node.
    pub const ATTRIBUTES: &[Attribute] = &[
        Attribute::new("vertex1", Takes::Triple, "the first corner").unit("world units"),
        Attribute::new("vertex2", Takes::Triple, "the second corner").unit("world units"),
        Attribute::new("vertex3", Takes::Triple, "the third corner").unit("world units"),
    ];

    /// A triangle from its corners.
    ///
    /// # Errors
    /// Returns an error if the corners lie on one line.
    pub fn new(vertices: [DVec3; 3]) -> Result<Self, ValueError> {
        let [a, b, c] = vertices;
        let edge = |to: DVec3| Point::exact(to).exactly_from(a);
        let normal = edge(b).cross(&edge(c)).unit();
        // Decimals of the file can be in line although the doubles next to them are not.
        let given = ExactGeometry::polygon(&vertices).normal;
        if normal == DVec3::ZERO || given.is_zero() {
            return Err(ValueError::new(
                "vertex3",
                "the three vertices lie on one line",
                "a triangle needs three corners that are not in line",
            )
            .expected("expected a point off the line through the other two"));
        }
        Ok(Self {
            vertices,
            flat: Flat::with_unit_normal(a, normal),
            edges: [b - a, c - b, a - c],
            borders: [
                Line::between(b, a),
                Line::between(c, b),
                Line::between(a, c),
            ],
            border_error: UNDERFLOW,
        })
    }

    /// The triangle of a node.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn from_node(node: &Node) -> Result<Self, ValueError> {
        Self::new(["vertex1", "vertex2", "vertex3"].map(|word| node.triple(word)))
    }

    /// Adds the triangle's attributes to a node.
    #[must_use]
    pub fn describe_into(&self, node: Node) -> Node {
        let [a, b, c] = self.vertices;
        node.with("vertex1", a)
            .with("vertex2", b)
            .with("vertex3", c)
    }

    /// The corners.
    pub(super) fn vertices(&self) -> [DVec3; 3] {
        self.vertices
    }

    #[inline]
    pub(super) fn intersect(&self, ray: &Ray, span: Span) -> Option<Hit> {
        let crossing = self.flat.crossing(ray)?;
        if crossing.is_beyond(span) || !self.contains_line(ray, &crossing) {
            return None;
        }
        let t = crossing.distance();
        let error = crossing.error(t);
        if !span.admits(t, error) {
            return None;
        }
        let point = self.held(self.flat.foot(ray, t));
        Some(Hit::new(t, error, point, self.flat.normal))
    }

    #[inline]
    pub(super) fn occludes(&self, segment: &Segment, end: Side) -> bool {
        self.flat.separates(segment, end).is_some_and(|crossing| {
            self.contains_line(&segment.ray, &crossing) && segment.holds(&crossing, &self.flat)
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

    /// Returns whether the line of a ray passes inside.
    ///
    /// A border counts unless a neighbour owns it.
    fn contains_line(&self, ray: &Ray, crossing: &Crossing) -> bool {
        let sign = if crossing.rises { -1.0 } else { 1.0 };
        let exactly = || {
            inside_all(
                &self.borders,
                || self.exact_corners(),
                ray,
                &self.flat,
                crossing,
            )
        };
        if crossing.at_start.is_some() {
            return exactly();
        }
        let along_plane = crossing.grazing.is_some();
        let mut certain = true;
        for (vertex, edge) in self.vertices.into_iter().zip(self.edges) {
            // For the edge e from a vertex v, and c from v to the ray's origin, e·(d × c) is the
            // distance of the crossing from the edge times n·d and the edge's length.
            let (origin, size) = ray.origin.seen_from(vertex);
            let side = edge.dot(ray.dir.cross(origin)) * sign;
            let length = edge.abs().element_sum();
            let mut bound = (MOMENT * size + self.border_error) * length + UNDERFLOW;
            if along_plane {
                bound = 2.0 * bound + self.rise(edge, size + crossing.distance());
            }
            if side < -bound {
                return false;
            }
            certain &= side > bound;
        }
        certain || exactly()
    }

    /// The error bound that an edge's side gains for a ray nearly along the plane.
    ///
    /// The edge is decided in the plane, which the ray crosses at most `far` from a vertex.
    #[cold]
    fn rise(&self, edge: DVec3, far: f64) -> f64 {
        // As on a rectangle this is the height of the edge above the plane, there, times its
        // length. The vertices lie off the plane by the rounding of the normal, and by the distance
        // to the shared plane that decides.
        let length = edge.abs().element_sum();
        let around: f64 = self.edges.iter().map(|edge| edge.abs().element_sum()).sum();
        let error = self.border_error;
        (EXTENT * length + 2.0 * error) * far + (EXTENT * around + error) * length
    }

    /// The hit point, moved onto the triangle if rounding has put it outside.
    ///
    /// For a ray nearly along the plane, the hit is certain and its position is not.
    fn held(&self, point: Point) -> Point {
        let inward = [2, 0, 1].map(|index| {
            let way = point.from(self.vertices[index]);
            self.flat.normal.dot(self.edges[index].cross(way))
        });
        if inward.iter().all(|inward| *inward >= 0.0) {
            return point;
        }
        let shares = inward.map(|inward| inward.max(0.0));
        let [of_b, of_c, _] = shares.map(|share| share / shares.iter().sum::<f64>());
        let offset = self.edges[0] * of_b - self.edges[2] * of_c;
        if offset.is_finite() {
            Point { offset, ..point }
        } else {
            point
        }
    }
}

impl Planar for Triangle {
    fn carrier(&self) -> &Flat {
        &self.flat
    }

    fn exact_geometry(&self) -> ExactGeometry {
        ExactGeometry::polygon(&self.vertices)
    }

    fn share(&mut self, plane: &Flat, borders: &[Option<Line>]) {
        self.flat = self.flat.welded(plane);
        let [a, b, c] = self.vertices;
        let ends = [[a, b], [b, c], [c, a]];
        for ((border, shared), ends) in self.borders.iter_mut().zip(borders).zip(ends) {
            let Some(shared) = shared else { continue };
            *border = *shared;
            for end in ends {
                let apart = shared.apart(&end.into(), &self.flat);
                self.border_error = self.border_error.max(apart.next_up());
            }
        }
    }

    fn outline(&self) -> Vec<DVec3> {
        self.vertices.to_vec()
    }

    fn exact_corners(&self) -> Vec<ExactVector> {
        self.vertices.map(ExactVector::from).to_vec()
    }

    fn borders(&self) -> &[Line] {
        &self.borders
    }

    fn border_error(&self) -> f64 {
        self.border_error
    }
}
