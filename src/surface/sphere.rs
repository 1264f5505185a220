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

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::chord::{Chord, Quadratic, Roundings, is_beyond};
use super::inside::Round;
use super::{Anatomy, Common, Hit, Shape, Surface, globe};
use crate::language::{Attribute, Naming, Node, Range, Schema, Takes, ValueError};
use crate::math::error_bounds::UNDERFLOW;
use crate::math::exact::{Distance, Exact, ExactVector, Sign};
use crate::math::{Beam, Bounds, Point, Ray, Rgb, Segment, Side, Span, UNIT, direction};
use crate::texture::{Filter, Texture, TextureMap};

/// A sphere, lit from outside, and seen from outside unless its material has an index of refraction.
#[derive(Debug, Clone)]
pub struct Sphere {
    common: Common,
    center: DVec3,
    radius: f64,
    /// The sum of the centre's coordinates without their signs.
    size: f64,
    image: Option<TextureMap>,
}

impl Sphere {
    /// The attributes of a round thing.
    pub(super) const ATTRIBUTES: &[Attribute] = &[
        Attribute::new("center", Takes::Triple, "its centre").unit("world units"),
        Attribute::new("radius", Takes::Number(Range::Positive), "its radius").unit("world units"),
    ];

    /// The `sphere` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "sphere",
        about: "A sphere, seen and lit from outside.",
        naming: Naming::Optional,
        value: None,
        properties: &[],
        attributes: &[Common::ATTRIBUTES, Self::ATTRIBUTES, globe::ATTRIBUTES],
    };

    /// A sphere, optionally with an image wrapped around it.
    ///
    /// # Errors
    /// Refuses a radius that is not above zero.
    pub fn new(
        common: Common,
        center: DVec3,
        radius: f64,
        texture: Option<Arc<Texture>>,
    ) -> Result<Self, ValueError> {
        if !(radius.is_finite() && radius > 0.0) {
            let advice = "give the radius in world units";
            return Err(ValueError::new(
                "radius",
                "the radius must be above zero",
                advice,
            ));
        }
        if radius < Range::SMALLEST_RADIUS {
            let reason = "the radius is too small";
            let error = ValueError::new("radius", reason, "choose a smaller unit of length");
            return Err(error.expected("expected at least 5.6e-76, which is 2^-250"));
        }
        let image = texture.map(|texture| TextureMap::clamp(texture, globe::WHOLE));
        Ok(Self {
            common,
            center,
            radius,
            size: Point::exact(center).size(),
            image,
        })
    }
}

impl Round for Sphere {
    const ROUNDINGS: Roundings = Roundings::OF_BALL;

    fn center_and_axes(&self) -> [DVec3; 2] {
        [self.center, DVec3::splat(self.radius)]
    }

    fn ball_radius(&self) -> f64 {
        self.radius
    }

    fn in_ball(&self, vector: DVec3) -> DVec3 {
        vector
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

    #[inline(always)]
    fn entry(&self, ray: &Ray) -> Option<(f64, f64)> {
        let origin = ray.origin.from(self.center);
        let chord = Chord::new(
            origin,
            ray.size() + self.size,
            ray.dir,
            1.0,
            self.radius,
            Self::ROUNDINGS,
        )?;
        chord.entry(ray.astray, || self.equation(ray))
    }
}

impl Sphere {
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

    /// Adds the sphere's place and size to a node.
    pub(super) fn describe_into(&self, node: Node) -> Node {
        node.with("center", self.center).with("radius", self.radius)
    }
}

impl Surface for Sphere {
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        let (t, error) = self
            .meeting(ray)
            .filter(|(t, error)| span.admits(*t, *error))?;
        let normal = direction(ray.origin.from(self.center) + ray.dir * t);
        // Pushed out radially onto the sphere, which the rounded point is not.
        let point = Point {
            anchor: self.center,
            offset: normal * self.radius,
        };
        Some(Hit {
            t,
            error,
            point,
            normal,
            uv: DVec2::ZERO,
            texel: Rgb::WHITE,
        })
    }

    fn common(&self) -> &Common {
        &self.common
    }

    fn anatomy(&self) -> Option<Anatomy<'_>> {
        let shape = Shape::Sphere {
            center: self.center,
            radius: self.radius,
        };
        Some(globe::anatomy(shape, self.image.as_ref()))
    }

    fn describe(&self) -> Node {
        let node = self.describe_into(Node::new(&Self::SCHEMA, None));
        globe::describe(node, self.image.as_ref())
    }

    fn round(&self) -> Option<[DVec3; 2]> {
        Some(self.center_and_axes())
    }

    fn bounds(&self) -> Option<Bounds> {
        let reach = DVec3::splat(self.radius);
        Some(Bounds {
            min: self.center - reach,
            max: self.center + reach,
        })
    }

    fn hull(&self) -> Option<Vec<ExactVector>> {
        Some(ExactVector::box_around(
            self.center,
            DVec3::splat(self.radius),
        ))
    }

    fn side(&self, point: &Point) -> Side {
        // Two roundings in each component of the way, a product and two sums, and a difference.
        const ROUNDINGS: f64 = 16.0 * UNIT;
        let (way, size) = point.seen_from(self.center);
        let height = way.length_squared() - self.radius * self.radius;
        if height.abs() > ROUNDINGS * (size * size + self.radius * self.radius) + UNDERFLOW {
            return Side::of(Sign::of(height));
        }
        let way = point.exactly_from(self.center);
        Side::of((&way.dot(&way) - &Exact::from(self.radius).squared()).sign())
    }

    fn error(&self, ray: &Ray, hit: &Hit) -> f64 {
        self.own_error(ray, hit)
    }

    fn exact_distance(&self, ray: &Ray) -> Option<Distance> {
        self.exact_meeting(ray)
    }

    fn occludes(&self, segment: &Segment, end: Side) -> bool {
        if let Some(passes) = self.lets_out(segment, end) {
            return passes;
        }
        let Some((t, error)) = self.entry(&segment.ray) else {
            return false;
        };
        // The line is nearest to the centre inside, so an end outside lies before or beyond that
        // place together with the whole sphere.
        let dir = segment.ray.dir;
        let exact = || {
            let way = segment.end.exactly_from(self.center);
            way.dot(&dir.into())
        };
        let beyond = || is_beyond(segment.end.parts_from(self.center), dir, exact);
        (end == Side::Back || beyond()) && segment.admits(t, || error, None)
    }

    fn texture(&self) -> Option<&Texture> {
        self.image.as_ref().map(|image| &*image.texture)
    }

    fn settle(&self, hit: &mut Hit, _ray: &Ray) {
        if let Some(image) = &self.image {
            hit.texel = globe::texel(image, hit.normal);
        }
    }

    fn texel_over(&self, hit: &Hit, beam: &Beam, filter: Filter) -> Rgb {
        let Some(image) = &self.image else {
            return hit.texel;
        };
        let steps = beam.steps_at(&hit.point, hit.normal);
        let steps = steps.map(|step| step / self.radius);
        let seen = (filter, hit.texel);
        globe::texel_over(image, seen, hit.normal, steps)
    }
}
