//! Slides of projectors.

use glam::DVec3;

use super::{ATTRIBUTES, Light};
use crate::language::{Naming, Node, Schema};
use crate::math::{Point, Ray, Rectangle, Rgb, Span};
use crate::surface::{FinitePlane, TexturePlane};
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
    /// The normal as the scene gives it.
    pub given_normal: DVec3,
    /// The x direction as the scene gives it.
    pub given_xdir: DVec3,
}

impl Slide {
    /// The `projector` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "projector",
        about: "A light that shines through a slide, and nowhere else.",
        attributes: &[
            ATTRIBUTES,
            FinitePlane::ATTRIBUTES,
            TexturePlane::ATTRIBUTES,
        ],
        naming: Naming::Optional,
        ..Light::SCHEMA
    };

    /// The colour of the slide at a ray from the light; `None` for a miss.
    #[must_use]
    pub fn color(&self, location: Point, direction: DVec3) -> Option<Rgb> {
        let offset = self.rectangle.hits(
            &Ray::new(location, direction),
            Span::AHEAD,
            |_, _, offset| offset,
        )?;
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
