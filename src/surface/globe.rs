//! Images on round things.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::{Anatomy, Cover, Shape};
use crate::language::{Attribute, Node, Reference, Takes};
use crate::math::{Rgb, Spread};
use crate::texture::{Filter, TextureMap, Wrap};

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
    image.at(place(direction))
}

/// The place in the image, from 0 to 1 along each side.
fn place(direction: DVec3) -> DVec2 {
    let longitude = libm::atan2(direction.x, direction.z);
    let latitude = libm::asin(direction.y.clamp(-1.0, 1.0));
    DVec2::new(0.5 + longitude / (2.0 * PI), 0.5 + latitude / PI)
}

/// The colour around there by a filter; `nearest` is the texel, and the steps are those of the direction
/// from pixel to pixel.
pub(super) fn texel_over(
    image: &TextureMap,
    (filter, nearest): (Filter, Rgb),
    direction: DVec3,
    steps: [DVec3; 2],
) -> Rgb {
    // How fast longitude and latitude change; at a pole, infinitely.
    let around = direction.x * direction.x + direction.z * direction.z;
    let spread = Spread {
        place: place(direction),
        steps: steps.map(|step| {
            let turn = (direction.z * step.x - direction.x * step.z) / around;
            DVec2::new(turn / (2.0 * PI), step.y / around.sqrt() / PI)
        }),
    };
    let wraps = [Wrap::Repeat, Wrap::Clamp];
    image.filtered_linearly(filter, nearest, &image.in_texels(spread), wraps)
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
