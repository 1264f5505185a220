//! Slides of projectors.

use glam::DVec3;

use super::{ATTRIBUTES, Light};
use crate::geometry::Rectangle;
use crate::language::{Naming, Node, Schema};
use crate::math::{Point, Ray, Rgb, Span};
use crate::surface::Textured;
use crate::texture::TextureMap;

/// A slide in front of a projector. It colours the light and is not visible itself.
#[derive(Debug, Clone)]
pub struct Slide {
    /// Its rectangle.
    pub rectangle: Rectangle,
    /// Its image.
    pub image: TextureMap,
    /// True if the scene gives the size of its texels.
    pub texel_given: bool,
}

impl Slide {
    /// The `projector` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "projector",
        about: "A light that shines through a slide, and nowhere else.",
        attributes: &[ATTRIBUTES, Rectangle::ATTRIBUTES, Textured::ATTRIBUTES],
        naming: Naming::Optional,
        ..Light::SCHEMA
    };

    /// The colour of the slide at a ray from the light; `None` for a miss.
    #[must_use]
    pub fn color(&self, lamp: Point, direction: DVec3) -> Option<Rgb> {
        let ray = Ray::new(lamp, direction);
        let hit = self.rectangle.intersect(&ray, Span::AHEAD)?;
        Some(self.image.at(hit.uv))
    }

    /// Adds the slide's attributes to a light's node.
    pub(super) fn describe_into(&self, node: Node) -> Node {
        let node = self.rectangle.describe_into(node);
        Textured::describe_image(node, &self.image, self.texel_given)
    }
}
