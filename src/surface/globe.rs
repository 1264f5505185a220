//! Images on round things.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::{Anatomy, Cover, Shape};
use crate::language::{Attribute, Node, Reference, Takes};
use crate::math::Rgb;
use crate::texture::TextureMap;

/// The attribute that wraps a texture around a round thing.
pub(super) const ATTRIBUTES: &[Attribute] = &[Attribute::new(
    "texture",
    Takes::Name(Reference::Texture),
    "an image wrapped around it once: its middle faces +z, its top is at +y",
)
.optional()];

/// The world size of a whole image on a globe: its places run from 0 to 1.
pub(super) const WHOLE: DVec2 = DVec2::ONE;

/// The colour of the texture where a unit direction from the centre leaves the globe.
///
/// Longitude 0 is the middle column and faces +z; it grows towards +x. At the poles, where every
/// longitude would do, it is 0.
pub(super) fn texel(image: &TextureMap, direction: DVec3) -> Rgb {
    let longitude = libm::atan2(direction.x, direction.z);
    let latitude = libm::asin(direction.y.clamp(-1.0, 1.0));
    image.at(DVec2::new(
        0.5 + longitude / (2.0 * PI),
        0.5 + latitude / PI,
    ))
}

/// Adds the texture of a round thing to its node.
pub(super) fn describe(node: Node, image: Option<&TextureMap>) -> Node {
    match image {
        Some(image) => node.with("texture", image.texture.name.as_str()),
        None => node,
    }
}

/// The anatomy of a round thing, with the image around it if there is one.
pub(super) fn anatomy(shape: Shape, image: Option<&TextureMap>) -> Anatomy<'_> {
    let plain = Anatomy::plain(shape);
    image.map_or(plain, |image| plain.covered(Cover::Globe(image)))
}
