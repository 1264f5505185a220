//! The slide of a projector.

use glam::DVec3;

use super::{ATTRIBUTES, Light};
use crate::language::{Naming, Node, Schema};
use crate::math::Rectangle;
use crate::math::{Point, Ray, Rgb, Span};
use crate::surface::{FinitePlane, TexturePlane};
use crate::texture::TextureMap;

/// A slide in front of a projector's lamp: it colours the light and is not seen itself.
#[derive(Debug, Clone)]
pub struct Slide {
    /// Its shape.
    pub rectangle: Rectangle,
    /// Its image.
    pub image: TextureMap,
    /// Whether the scene gives the size of its texels.
    pub texel_given: bool,
    /// The normal as the scene gives it.
    pub given_normal: DVec3,
    /// The direction of x as the scene gives it.
    pub given_xdir: DVec3,
}

impl Slide {
    /// The `projector` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "projector",
        about: "A light that shines through a slide; outside of its beam it lights nothing.",
        attributes: &[
            ATTRIBUTES,
            FinitePlane::ATTRIBUTES,
            TexturePlane::ATTRIBUTES,
        ],
        naming: Naming::Optional,
        ..Light::SCHEMA
    };

    /// The colour of the slide where light from the lamp crosses it; `None` if it does not.
    #[must_use]
    pub fn color(&self, lamp: Point, direction: DVec3) -> Option<Rgb> {
        let offset =
            self.rectangle
                .hits(&Ray::new(lamp, direction), Span::AHEAD, |_, _, offset| {
                    offset
                })?;
        Some(self.image.at(offset))
    }

    /// Adds the slide's attributes to a light's node.
    pub(super) fn describe_into(&self, node: Node) -> Node {
        let node = node
            .with("point", self.rectangle.flat.point)
            .with("normal", self.given_normal)
            .with("xdir", self.given_xdir)
            .with("dimensions", self.rectangle.size);
        TexturePlane::describe_image(node, &self.image, self.texel_given)
    }
}
