//! The sphere.
//!
//! ```
//! # heliodon::doctest::surface(r#"
//! sphere "ball" {
//!     material "gray"
//!     center 0 1 -4
//!     radius 1
//! }
//! # "#, [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], Some(3.0));
//! ```

use glam::DVec3;

use super::chord::{Chord, Quadratic, Roundings};
use super::round::Round;
use crate::language::{Attribute, Node, Range, Takes, ValueError};
use crate::math::error_bounds::{BALL_SIDE, UNDERFLOW};
use crate::math::exact::{Exact, ExactVector, Sign};
use crate::math::{Point, Ray, Side};

/// A sphere, lit from outside; visible from inside if [entered](Self::entered).
#[derive(Debug, Clone, PartialEq)]
pub struct Sphere {
    center: DVec3,
    radius: f64,
    /// The sum of the absolute values of the centre's coordinates.
    size: f64,
    is_entered: bool,
}

impl Sphere {
    /// The attributes of a round shape's node.
    pub const ATTRIBUTES: &[Attribute] = &[
        Attribute::new("center", Takes::Triple, "its centre").unit("world units"),
        Attribute::new("radius", Takes::Number(Range::Positive), "its radius").unit("world units"),
    ];

    /// A sphere that rays do not enter.
    ///
    /// # Errors
    /// Returns an error if the radius is not above zero, or below 2⁻²⁵⁰.
    pub fn new(center: DVec3, radius: f64) -> Result<Self, ValueError> {
        let invalid = |reason, advice| ValueError::new("radius", reason, advice);
        if !(radius.is_finite() && radius > 0.0) {
            let advice = "give the radius in world units";
            return Err(invalid("the radius must be above zero", advice));
        }
        if radius < Range::SMALLEST_RADIUS {
            let error = invalid("the radius is too small", "choose a smaller unit of length");
            return Err(error.expected("expected at least 5.6e-76, which is 2^-250"));
        }
        Ok(Self {
            center,
            radius,
            size: Point::exact(center).size(),
            is_entered: false,
        })
    }

    /// The sphere of a node.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn from_node(node: &Node) -> Result<Self, ValueError> {
        Self::new(node.triple("center"), node.number("radius"))
    }

    /// The same sphere, whose inside rays can hit if `is_entered`.
    #[must_use]
    pub fn entered(self, is_entered: bool) -> Self {
        Self { is_entered, ..self }
    }

    /// Its centre.
    #[must_use]
    pub fn center(&self) -> DVec3 {
        self.center
    }

    /// Its radius.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Adds the sphere's attributes to a node.
    #[must_use]
    pub fn describe_into(&self, node: Node) -> Node {
        node.with("center", self.center).with("radius", self.radius)
    }
}

impl Round for Sphere {
    const ROUNDINGS: Roundings = Roundings::OF_BALL;

    fn extent(&self) -> [DVec3; 2] {
        [self.center, DVec3::splat(self.radius)]
    }

    fn is_entered(&self) -> bool {
        self.is_entered
    }

    fn ball_radius(&self) -> f64 {
        self.radius
    }

    fn in_ball(&self, vector: DVec3) -> DVec3 {
        vector
    }

    fn normal(&self, on_ball: DVec3) -> DVec3 {
        on_ball
    }

    fn most_stretch(&self) -> f64 {
        1.0
    }

    fn equation(&self, ray: &Ray) -> Quadratic {
        let origin = ray.origin.exactly_from(self.center);
        let dir = ExactVector::from(ray.dir);
        Quadratic {
            a: dir.dot(&dir),
            b: -&origin.dot(&dir),
            c: &origin.dot(&origin) - &Exact::from(self.radius).squared(),
            rounding: ray.rounding(),
        }
    }

    fn exact_dot(&self, from_center: &Point, dir: DVec3) -> Exact {
        from_center.exactly_from(self.center).dot(&dir.into())
    }

    #[inline(always)]
    fn entry(&self, ray: &Ray) -> Option<(f64, f64)> {
        let origin = ray.origin.from(self.center);
        let size = ray.size() + self.size;
        let chord = Chord::new(origin, size, ray.dir, 1.0, self.radius, Self::ROUNDINGS)?;
        chord.entry(ray.astray, || self.equation(ray))
    }

    fn side(&self, point: &Point) -> Side {
        let (way, size) = point.seen_from(self.center);
        let height = way.length_squared() - self.radius * self.radius;
        if height.abs() > BALL_SIDE * (size * size + self.radius * self.radius) + UNDERFLOW {
            return Side::of(Sign::of(height));
        }
        let way = point.exactly_from(self.center);
        Side::of((&way.dot(&way) - &Exact::from(self.radius).squared()).sign())
    }
}
