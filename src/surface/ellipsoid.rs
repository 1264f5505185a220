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

use super::{Common, Hit, Sphere, Surface, globe, sphere::enters};
use crate::language::{Attribute, Naming, Node, Range, Refusal, Schema, Takes};
use crate::math::{Bounds, Point, Ray, Rgb, Side, Span, direction};
use crate::texture::{Texture, TextureMap};

/// A sphere stretched along the world's axes.
#[derive(Debug, Clone)]
pub struct Ellipsoid {
    common: Common,
    center: DVec3,
    radius: f64,
    scale: DVec3,
    /// The three half axes: radius times scale.
    axes: DVec3,
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
    ) -> Result<Self, Refusal> {
        let axes = scale * radius;
        if !(scale.is_finite() && scale.min_element() > 0.0) {
            let advice = "1 1 1 is a sphere, 1 0.3 1 a flat saucer";
            let refusal = Refusal::new("scale", "a factor is not above zero", advice);
            return Err(refusal.expected("expected three numbers above 0"));
        }
        let computable = axes.min_element() > 0.0 && axes.max_element() <= Range::LARGEST;
        if radius.is_finite() && radius > 0.0 && !computable {
            let reason = "radius times scale is out of range";
            let refusal = Refusal::new("scale", reason, "choose a larger unit of length");
            return Err(
                refusal.expected("expected a product of no more than 1.8e75, which is 2^250")
            );
        }
        if !(axes.is_finite() && axes.min_element() > 0.0) {
            let advice = "give the radius in world units";
            return Err(Refusal::new(
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
            image,
        })
    }

    /// From a point on the ellipsoid to the same point on the unit sphere.
    fn on_unit_sphere(&self, point: &Point) -> DVec3 {
        point.from(self.center) / self.axes
    }
}

impl Surface for Ellipsoid {
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        // In the space where the ellipsoid is the unit sphere.
        let origin = self.on_unit_sphere(&ray.origin);
        let stretched = ray.dir / self.axes;
        let speed = stretched.length();
        let dir = stretched / speed;
        let entered = enters(origin, dir, 1.0)?;
        let t = Some(entered / speed).filter(|t| span.contains(*t))?;
        let on_sphere = direction(origin + dir * entered);
        let point = Point {
            anchor: self.center,
            offset: on_sphere * self.axes,
        };
        Some(Hit {
            t,
            point,
            normal: direction(on_sphere / self.axes),
            uv: DVec2::ZERO,
        })
    }

    fn common(&self) -> &Common {
        &self.common
    }

    fn describe(&self) -> Node {
        let node = Node::new(&Self::SCHEMA, None)
            .with("center", self.center)
            .with("radius", self.radius)
            .with("scale", self.scale);
        globe::describe(node, self.image.as_ref())
    }

    fn round(&self) -> Option<[DVec3; 2]> {
        Some([self.center, self.axes])
    }

    fn bounds(&self) -> Option<Bounds> {
        Some(Bounds {
            min: self.center - self.axes,
            max: self.center + self.axes,
        })
    }

    fn side(&self, point: &Point) -> Side {
        Side::of(self.on_unit_sphere(point).length() - 1.0)
    }

    fn texel(&self, hit: &Hit) -> Rgb {
        let Some(image) = &self.image else {
            return Rgb::WHITE;
        };
        globe::texel(image, direction(self.on_unit_sphere(&hit.point)))
    }
}
