//! Shapes: what a ray can hit, whatever covers it.
//!
//! The set of shapes is closed: [`Shape`] is an enum, and each variant has a file of its own.

mod chord;
pub mod classic;
mod ellipsoid;
mod hit;
mod planar;
mod plane;
mod rectangle;
mod round;
mod shared;
mod sphere;
mod triangle;

pub use ellipsoid::Ellipsoid;
pub use hit::{Hit, Resolved};
pub use planar::Planar;
pub use plane::Plane;
pub use rectangle::Rectangle;
pub use shared::{Shared, SharedKind, share};
pub use sphere::Sphere;
pub use triangle::Triangle;

use glam::DVec3;

use crate::language::Node;
use crate::math::error_bounds::{FLAT_SLIP, ROUND_SLIP};
use crate::math::exact::{Distance, ExactVector};
use crate::math::{Bounds, Flat, Point, Ray, Segment, Side, Span};
use round::Round;

/// The geometry of a surface.
#[derive(Debug, Clone)]
pub enum Shape {
    /// An unbounded plane.
    Plane(Plane),
    /// A rectangle.
    Rectangle(Rectangle),
    /// A triangle.
    Triangle(Triangle),
    /// A sphere.
    Sphere(Sphere),
    /// An ellipsoid along the world's axes.
    Ellipsoid(Ellipsoid),
}

/// Evaluates an expression for the shape that a [`Shape`] holds.
macro_rules! each {
    ($self:expr, $shape:ident => $answer:expr) => {
        match $self {
            Shape::Plane($shape) => $answer,
            Shape::Rectangle($shape) => $answer,
            Shape::Triangle($shape) => $answer,
            Shape::Sphere($shape) => $answer,
            Shape::Ellipsoid($shape) => $answer,
        }
    };
}

/// Makes each shape a [`Shape`].
macro_rules! variants {
    ($($shape:ident),*) => {
        $(impl From<$shape> for Shape {
            fn from(shape: $shape) -> Self {
                Self::$shape(shape)
            }
        })*
    };
}

variants!(Plane, Rectangle, Triangle, Sphere, Ellipsoid);

impl Shape {
    /// The same shape; rays can hit its inside if `is_entered` and it is round.
    #[must_use]
    pub fn entered(self, is_entered: bool) -> Self {
        match self {
            Self::Sphere(sphere) => sphere.entered(is_entered).into(),
            Self::Ellipsoid(ellipsoid) => ellipsoid.entered(is_entered).into(),
            flat => flat,
        }
    }

    /// Adds the shape's attributes to a node of the scene language.
    #[must_use]
    pub fn describe_into(&self, node: Node) -> Node {
        each!(self, shape => shape.describe_into(node))
    }

    /// The nearest hit of a ray in a span of distances.
    ///
    /// A ray that leaves a plane must not be tested against it again: a line crosses a plane once.
    #[must_use]
    #[inline(always)]
    pub fn intersect(&self, ray: &Ray, span: Span) -> Option<Hit> {
        each!(self, shape => shape.intersect(ray, span))
    }

    /// Adds the nearest hit ahead of each of some rays that start in free space.
    ///
    /// The hits are those of [`intersect`](Self::intersect). The choice of the shape is made once,
    /// so the tests of one ray need not wait for those of another.
    pub fn intersect_batch(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
        each!(self, shape => for (ray, hit) in rays.iter().zip(hits) {
            // A hit is large, so it is made in its place.
            if let Some(found) = shape.intersect(ray, Span::AHEAD) {
                *hit = Some(found);
            }
        });
    }

    /// Returns whether the shape stands between the ends of a segment.
    ///
    /// `end` is the side of the shape that the segment's end is on.
    #[must_use]
    #[inline]
    pub fn occludes(&self, segment: &Segment, end: Side) -> bool {
        each!(self, shape => shape.occludes(segment, end))
    }

    /// The exact side of a point; inside of a round shape is its back.
    #[must_use]
    pub fn side(&self, point: &Point) -> Side {
        each!(self, shape => shape.side(point))
    }

    /// The exact distance of a ray's hit; meaningless if the ray misses.
    #[must_use]
    pub fn exact_distance(&self, ray: &Ray) -> Option<Distance> {
        each!(self, shape => shape.exact_distance(ray))
    }

    /// An error bound of a hit's distance, from the vector between both ends.
    ///
    /// The hit's own bound is cheaper, and grows with the coordinates of both ends.
    #[must_use]
    pub fn distance_error(&self, ray: &Ray, hit: &Hit) -> f64 {
        each!(self, shape => hit.error.min(shape.distance_error(ray, hit)))
    }

    /// The point given in the scene: a point of the plane, a corner, or the centre.
    #[must_use]
    pub fn anchor(&self) -> DVec3 {
        match self {
            Self::Plane(plane) => plane.carrier().point,
            Self::Rectangle(rectangle) => rectangle.flat.point,
            Self::Triangle(triangle) => triangle.carrier().point,
            Self::Sphere(sphere) => sphere.center(),
            Self::Ellipsoid(ellipsoid) => Round::extent(ellipsoid)[0],
        }
    }

    /// The shape as a planar one; `None` for a round one.
    #[must_use]
    pub fn planar(&self) -> Option<&dyn Planar> {
        match self {
            Self::Plane(plane) => Some(plane),
            Self::Rectangle(rectangle) => Some(rectangle),
            Self::Triangle(triangle) => Some(triangle),
            Self::Sphere(_) | Self::Ellipsoid(_) => None,
        }
    }

    /// The shape as a planar one, mutable.
    fn planar_mut(&mut self) -> Option<&mut dyn Planar> {
        match self {
            Self::Plane(plane) => Some(plane),
            Self::Rectangle(rectangle) => Some(rectangle),
            Self::Triangle(triangle) => Some(triangle),
            Self::Sphere(_) | Self::Ellipsoid(_) => None,
        }
    }

    /// Centre and half axes of a round shape.
    #[must_use]
    pub fn round(&self) -> Option<[DVec3; 2]> {
        match self {
            Self::Plane(_) | Self::Rectangle(_) | Self::Triangle(_) => None,
            Self::Sphere(sphere) => Some(sphere.extent()),
            Self::Ellipsoid(ellipsoid) => Some(ellipsoid.extent()),
        }
    }

    /// The plane that a flat shape lies in.
    #[must_use]
    pub fn carrier(&self) -> Option<&Flat> {
        self.planar().map(Planar::carrier)
    }

    /// The corners of a flat shape, in order; empty if it is unbounded or round.
    #[must_use]
    pub fn outline(&self) -> Vec<DVec3> {
        self.planar().map(Planar::outline).unwrap_or_default()
    }

    /// Points whose convex hull holds the shape, exactly; `None` if it is unbounded.
    #[must_use]
    pub fn hull(&self) -> Option<Vec<ExactVector>> {
        match (self.planar(), self.round()) {
            (_, Some([center, axes])) => Some(ExactVector::box_around(center, axes)),
            (planar, None) => planar
                .map(Planar::exact_corners)
                .filter(|corners| !corners.is_empty()),
        }
    }

    /// The bounding box; `None` if the shape is unbounded.
    #[must_use]
    pub fn bounds(&self) -> Option<Bounds> {
        if let Some([center, axes]) = self.round() {
            return Some(Bounds {
                min: center - axes,
                max: center + axes,
            });
        }
        let outline = self.outline();
        (!outline.is_empty()).then(|| Bounds::around(outline))
    }

    /// A bound of the distance between its own borders and the borders that decide.
    ///
    /// They differ where the shape shares borders with others, and by rounding.
    #[must_use]
    pub fn border_error(&self) -> f64 {
        self.planar().map_or(0.0, Planar::border_error)
    }

    /// A bound of the error of a hit point, per unit of error in the hit's distance.
    #[must_use]
    pub fn point_error(&self) -> f64 {
        // A point of a round shape is pushed back towards the centre. It slides along the surface
        // by 1 / cos of the angle between the normal and the direction from the centre: for half
        // axes a ≥ b by at most (a/b + b/a) / 2.
        self.round().map_or(FLAT_SLIP, |[_, axes]| {
            let ratio = axes.max_element() / axes.min_element();
            ROUND_SLIP * 0.5 * (ratio + ratio.recip())
        })
    }
}
