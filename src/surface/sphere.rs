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

use super::{Anatomy, Common, Hit, Shape, Surface, globe};
use crate::language::{Attribute, Naming, Node, Range, Refusal, Schema, Takes};
use crate::math::{Bounds, Point, Ray, Rgb, Side, Span, direction};
use crate::texture::{Texture, TextureMap};

/// A sphere, seen and lit from outside.
#[derive(Debug, Clone)]
pub struct Sphere {
    common: Common,
    center: DVec3,
    radius: f64,
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
    ) -> Result<Self, Refusal> {
        if !(radius.is_finite() && radius > 0.0) {
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
            image,
        })
    }
}

/// The distance at which a ray enters a sphere around the origin; `None` if it misses, only
/// touches, starts inside or leads away.
///
/// The discriminant is `r² − |c − (c·d)d|²`: the distance of the line from the centre does not
/// cancel, however far away the origin is (Haines, Günther and Akenine-Möller 2019, "Precision
/// Improvements for Ray/Sphere Intersection").
pub(super) fn enters(origin: DVec3, dir: DVec3, radius: f64) -> Option<f64> {
    let along = origin.dot(dir);
    if along >= 0.0 {
        return None;
    }
    let nearest = origin - dir * along;
    let half_chord_squared = radius * radius - nearest.length_squared();
    if half_chord_squared <= 0.0 {
        return None;
    }
    Some(-along - half_chord_squared.sqrt())
}

impl Surface for Sphere {
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        let origin = ray.origin.from(self.center);
        let t = enters(origin, ray.dir, self.radius).filter(|t| span.contains(*t))?;
        let normal = direction(origin + ray.dir * t);
        // Pushed out radially onto the sphere, which the rounded point is not.
        let point = Point {
            anchor: self.center,
            offset: normal * self.radius,
        };
        Some(Hit {
            t,
            point,
            normal,
            uv: DVec2::ZERO,
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
        let node = Node::new(&Self::SCHEMA, None)
            .with("center", self.center)
            .with("radius", self.radius);
        globe::describe(node, self.image.as_ref())
    }

    fn round(&self) -> Option<[DVec3; 2]> {
        Some([self.center, DVec3::splat(self.radius)])
    }

    fn bounds(&self) -> Option<Bounds> {
        let reach = DVec3::splat(self.radius);
        Some(Bounds {
            min: self.center - reach,
            max: self.center + reach,
        })
    }

    fn side(&self, point: &Point) -> Side {
        Side::of(point.from(self.center).length() - self.radius)
    }

    fn texel(&self, hit: &Hit) -> Rgb {
        self.image
            .as_ref()
            .map_or(Rgb::WHITE, |image| globe::texel(image, hit.normal))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_near_side_is_hit_and_a_touch_is_a_miss() {
        let from = |x: f64| enters(DVec3::new(x, 0.0, 5.0), DVec3::NEG_Z, 1.0);
        assert_eq!(from(0.0), Some(4.0));
        assert_eq!(from(1.0), None);
        assert_eq!(enters(DVec3::ZERO, DVec3::NEG_Z, 1.0), None);
        assert_eq!(enters(DVec3::new(0.0, 0.0, -5.0), DVec3::NEG_Z, 1.0), None);
    }

    #[test]
    fn far_away_the_decision_is_still_right() {
        for (x, hit) in [(0.999_999, true), (1.000_001, false)] {
            let entered = enters(DVec3::new(x, 0.0, 1e9), DVec3::NEG_Z, 1.0);
            assert_eq!(entered.is_some(), hit, "{x}");
        }
    }
}
