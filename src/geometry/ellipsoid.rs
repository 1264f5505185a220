//! The ellipsoid.
//!
//! ```
//! # heliodon::doctest::surface(r#"
//! ellipsoid "saucer" {
//!     material "gray"
//!     center 0 1 -4
//!     radius 1
//!     scale 2 0.5 1
//! }
//! # "#, [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], Some(3.0));
//! ```

use glam::DVec3;

use super::chord::{Chord, Quadratic, Roundings};
use super::round::Round;
use crate::language::{Attribute, Node, Range, Takes, ValueError};
use crate::math::exact::{Exact, ExactVector};
use crate::math::{Point, Ray, Side, direction};

/// A sphere stretched along the world's axes.
///
/// It is computed in the space where it is the unit sphere.
#[derive(Debug, Clone, PartialEq)]
pub struct Ellipsoid {
    center: DVec3,
    radius: f64,
    scale: DVec3,
    /// The three half axes: radius times scale.
    axes: DVec3,
    /// One divided by each axis, and the largest of these.
    shrink: DVec3,
    most_shrink: f64,
    /// The sum of the absolute values of the centre's coordinates.
    size: f64,
    is_entered: bool,
}

impl Ellipsoid {
    /// The attribute that an ellipsoid's node adds to a sphere's.
    pub const ATTRIBUTES: &[Attribute] = &[Attribute::new(
        "scale",
        Takes::Triple,
        "factors along x, y and z; each above 0",
    )];

    /// An ellipsoid that rays do not enter, with half axes of `radius` times `scale`.
    ///
    /// # Errors
    /// Returns an error if a radius or a factor is not above zero, or a product out of range.
    pub fn new(center: DVec3, radius: f64, scale: DVec3) -> Result<Self, ValueError> {
        let axes = scale * radius;
        if !(scale.is_finite() && scale.min_element() > 0.0) {
            let advice = "1 1 1 is a sphere, 1 0.3 1 a flat saucer";
            let error = ValueError::new("scale", "a factor is not above zero", advice);
            return Err(error.expected("expected three numbers above 0"));
        }
        let computable =
            axes.min_element() >= Range::SMALLEST_RADIUS && axes.max_element() <= Range::LARGEST;
        if radius.is_finite() && radius > 0.0 && !computable {
            let reason = "radius times scale is out of range";
            let error = ValueError::new("scale", reason, "choose another unit of length");
            return Err(error
                .expected("expected products from 5.6e-76 to 1.8e75, which are 2^-250 and 2^250"));
        }
        if !(axes.is_finite() && axes.min_element() > 0.0) {
            let (reason, advice) = (
                "the radius must be above zero",
                "give the radius in world units",
            );
            return Err(ValueError::new("radius", reason, advice));
        }
        Ok(Self {
            center,
            radius,
            scale,
            axes,
            shrink: axes.recip(),
            most_shrink: axes.min_element().recip(),
            size: Point::exact(center).size(),
            is_entered: false,
        })
    }

    /// The ellipsoid of a node.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn from_node(node: &Node) -> Result<Self, ValueError> {
        let (center, radius) = (node.triple("center"), node.number("radius"));
        Self::new(center, radius, node.triple("scale"))
    }

    /// The same ellipsoid, whose inside rays can hit if `is_entered`.
    #[must_use]
    pub fn entered(self, is_entered: bool) -> Self {
        Self { is_entered, ..self }
    }

    /// Centre and half axes.
    #[must_use]
    pub fn extent(&self) -> [DVec3; 2] {
        [self.center, self.axes]
    }

    /// Adds the ellipsoid's attributes to a node.
    #[must_use]
    pub fn describe_into(&self, node: Node) -> Node {
        node.with("center", self.center)
            .with("radius", self.radius)
            .with("scale", self.scale)
    }

    /// The product of the three axes.
    fn exact_volume(&self) -> Exact {
        let [x, y, z] = self.axes.to_array().map(Exact::from);
        &(&x * &y) * &z
    }

    /// For each axis the product of the other two.
    fn exact_stretch(&self) -> ExactVector {
        ExactVector::from(self.axes).products_of_others()
    }
}

// Exact values are multiplied by all three axes, or their squares: exact numbers are not divided.
impl Round for Ellipsoid {
    const ROUNDINGS: Roundings = Roundings::OF_ELLIPSOID;

    fn extent(&self) -> [DVec3; 2] {
        [self.center, self.axes]
    }

    fn is_entered(&self) -> bool {
        self.is_entered
    }

    fn ball_radius(&self) -> f64 {
        1.0
    }

    #[inline(always)]
    fn in_ball(&self, vector: DVec3) -> DVec3 {
        vector * self.shrink
    }

    fn normal(&self, on_ball: DVec3) -> DVec3 {
        direction(on_ball * self.shrink)
    }

    fn most_stretch(&self) -> f64 {
        self.most_shrink
    }

    fn equation(&self, ray: &Ray) -> Quadratic {
        let stretch = self.exact_stretch();
        let origin = ray.origin.exactly_from(self.center).scaled(&stretch);
        let dir = ExactVector::from(ray.dir).scaled(&stretch);
        Quadratic {
            a: dir.dot(&dir),
            b: -&origin.dot(&dir),
            c: &origin.dot(&origin) - &self.exact_volume().squared(),
            rounding: ray.rounding() / self.axes.min_element(),
        }
    }

    fn exact_dot(&self, from_center: &Point, dir: DVec3) -> Exact {
        let stretch = self.exact_stretch();
        let dir = ExactVector::from(dir).scaled(&stretch);
        let way = from_center.exactly_from(self.center).scaled(&stretch);
        way.dot(&dir)
    }

    #[inline(always)]
    fn entry(&self, ray: &Ray) -> Option<(f64, f64)> {
        let origin = self.in_ball(ray.origin.from(self.center));
        let dir = self.in_ball(ray.dir);
        let (size, astray) = (ray.size() + self.size, ray.astray * self.most_shrink);
        let chord = Chord::new(
            origin,
            size * self.most_shrink,
            dir,
            dir.length_squared(),
            1.0,
            Self::ROUNDINGS,
        )?;
        chord.entry(astray, || self.equation(ray))
    }

    fn side(&self, point: &Point) -> Side {
        let way = point
            .exactly_from(self.center)
            .scaled(&self.exact_stretch());
        Side::of((&way.dot(&way) - &self.exact_volume().squared()).sign())
    }
}
