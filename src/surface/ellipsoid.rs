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

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::chord::{Chord, Quadratic, Roundings, is_beyond};
use super::inside::Round;
use super::{Anatomy, Common, Hit, Shape, Sphere, Surface, globe};
use crate::language::{Attribute, Naming, Node, Range, Schema, Takes, ValueError};
use crate::math::exact::{Distance, Exact, ExactVector};
use crate::math::{Beam, Bounds, Point, Ray, Rgb, Segment, Side, Span, direction};
use crate::texture::{Filter, Texture, TextureMap};

/// A sphere stretched along the world's axes.
#[derive(Debug, Clone)]
pub struct Ellipsoid {
    common: Common,
    center: DVec3,
    radius: f64,
    scale: DVec3,
    /// The three half axes: radius times scale.
    axes: DVec3,
    /// One divided by each axis, and the largest of these.
    shrink: DVec3,
    most_shrink: f64,
    /// The sum of the centre's coordinates without their signs.
    size: f64,
    image: Option<TextureMap>,
}

impl Ellipsoid {
    /// The `ellipsoid` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "ellipsoid",
        about: "A sphere stretched along the world's axes.",
        naming: Naming::Optional,
        value: None,
        properties: &[],
        attributes: &[
            Common::ATTRIBUTES,
            Sphere::ATTRIBUTES,
            &[Attribute::new(
                "scale",
                Takes::Triple,
                "factors along x, y and z; each above 0",
            )],
            globe::ATTRIBUTES,
        ],
    };

    /// An ellipsoid, optionally with an image wrapped around it.
    ///
    /// # Errors
    /// Refuses a radius or a factor that is not above zero.
    pub fn new(
        common: Common,
        center: DVec3,
        radius: f64,
        scale: DVec3,
        texture: Option<Arc<Texture>>,
    ) -> Result<Self, ValueError> {
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
            let advice = "give the radius in world units";
            return Err(ValueError::new(
                "radius",
                "the radius must be above zero",
                advice,
            ));
        }
        let image = texture.map(|texture| TextureMap::clamp(texture, globe::WHOLE));
        Ok(Self {
            common,
            center,
            radius,
            scale,
            axes,
            shrink: axes.recip(),
            most_shrink: axes.min_element().recip(),
            size: Point::exact(center).size(),
            image,
        })
    }

    /// The product of the three axes.
    fn exact_volume(&self) -> Exact {
        let [x, y, z] = self.axes.to_array().map(Exact::from);
        &(&x * &y) * &z
    }

    /// From a point on the ellipsoid to the same point on the unit sphere.
    fn on_unit_sphere(&self, point: &Point) -> DVec3 {
        point.from(self.center) / self.axes
    }
}

impl Round for Ellipsoid {
    const ROUNDINGS: Roundings = Roundings::OF_ELLIPSOID;

    fn center_and_axes(&self) -> [DVec3; 2] {
        [self.center, self.axes]
    }

    fn ball_radius(&self) -> f64 {
        1.0
    }

    #[inline(always)]
    fn in_ball(&self, vector: DVec3) -> DVec3 {
        vector * self.shrink
    }

    fn most_stretch(&self) -> f64 {
        self.most_shrink
    }

    /// Multiplied by all three axes squared, since exact numbers are not divided.
    fn equation(&self, ray: &Ray) -> Quadratic {
        let stretch = ExactVector::from(self.axes).products_of_others();
        let origin = ray.origin.exactly_from(self.center).scaled(&stretch);
        let dir = ExactVector::from(ray.dir).scaled(&stretch);
        Quadratic {
            a: dir.dot(&dir),
            b: -&origin.dot(&dir),
            c: &origin.dot(&origin) - &self.exact_volume().squared(),
            rounding: ray.rounding() / self.axes.min_element(),
        }
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
}

impl Surface for Ellipsoid {
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        // In the space where the ellipsoid is the unit sphere.
        let (t, error) = self
            .meeting(ray)
            .filter(|(t, error)| span.admits(*t, *error))?;
        let on_sphere = direction(self.in_ball(ray.origin.from(self.center) + ray.dir * t));
        let point = Point {
            anchor: self.center,
            offset: on_sphere * self.axes,
        };
        Some(Hit {
            t,
            error,
            point,
            normal: direction(on_sphere * self.shrink),
            uv: DVec2::ZERO,
            texel: Rgb::WHITE,
        })
    }

    fn common(&self) -> &Common {
        &self.common
    }

    fn anatomy(&self) -> Option<Anatomy<'_>> {
        let shape = Shape::Ellipsoid {
            center: self.center,
            axes: self.axes,
        };
        Some(globe::anatomy(shape, self.image.as_ref()))
    }

    fn describe(&self) -> Node {
        let node = Node::new(&Self::SCHEMA, None)
            .with("center", self.center)
            .with("radius", self.radius)
            .with("scale", self.scale);
        globe::describe(node, self.image.as_ref())
    }

    fn round(&self) -> Option<[DVec3; 2]> {
        Some(self.center_and_axes())
    }

    fn bounds(&self) -> Option<Bounds> {
        Some(Bounds {
            min: self.center - self.axes,
            max: self.center + self.axes,
        })
    }

    fn hull(&self) -> Option<Vec<ExactVector>> {
        Some(ExactVector::box_around(self.center, self.axes))
    }

    fn side(&self, point: &Point) -> Side {
        let stretch = ExactVector::from(self.axes).products_of_others();
        let way = point.exactly_from(self.center).scaled(&stretch);
        Side::of((&way.dot(&way) - &self.exact_volume().squared()).sign())
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
        // As with a sphere, in the space where the ellipsoid is one.
        let (parts, dir) = (segment.end.parts_from(self.center), segment.ray.dir);
        let exact = || {
            let stretch = ExactVector::from(self.axes).products_of_others();
            let way = segment.end.exactly_from(self.center);
            let dir = ExactVector::from(dir).scaled(&stretch);
            way.scaled(&stretch).dot(&dir)
        };
        let beyond = || {
            is_beyond(
                parts.map(|part| self.in_ball(part)),
                self.in_ball(dir),
                exact,
            )
        };
        (end == Side::Back || beyond()) && segment.admits(t, || error, None)
    }

    fn texture(&self) -> Option<&Texture> {
        self.image.as_ref().map(|image| &*image.texture)
    }

    fn settle(&self, hit: &mut Hit, _ray: &Ray) {
        if let Some(image) = &self.image {
            let on_sphere = direction(self.on_unit_sphere(&hit.point));
            hit.texel = globe::texel(image, on_sphere);
        }
    }

    fn texel_over(&self, hit: &Hit, beam: &Beam, filter: Filter) -> Rgb {
        let Some(image) = &self.image else {
            return hit.texel;
        };
        let steps = beam.steps_at(&hit.point, hit.normal);
        let steps = steps.map(|step| step / self.axes);
        let on_sphere = direction(self.on_unit_sphere(&hit.point));
        let seen = (filter, hit.texel);
        globe::texel_over(image, seen, on_sphere, steps)
    }
}
