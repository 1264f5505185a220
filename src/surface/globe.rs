//! Images wrapped around round shapes.
//!
//! Longitude 0 is the image's middle column and faces +z; it grows towards +x. At the poles it is
//! 0.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::Hit;
use crate::geometry::Shape;
use crate::language::{Attribute, Reference, Takes};
use crate::math::classic::{Scalar, Vector};
use crate::math::{Beam, Numerics, Rgb, Spread, direction};
use crate::texture::{Filter, TextureMap, Wrap, gettexel};

/// The attribute that wraps a texture around a round shape.
pub(super) const ATTRIBUTES: &[Attribute] = &[Attribute::new(
    "texture",
    Takes::Name(Reference::Texture),
    "an image wrapped around it once, with its middle at +z and its top at +y",
)
.optional()];

/// The world size of a whole image on a globe: its coordinates run from 0 to 1.
pub(super) const WHOLE: DVec2 = DVec2::ONE;

/// The colour of the image at a hit on a round shape.
pub(super) fn texel(image: &TextureMap, shape: &Shape, hit: &Hit, numerics: Numerics) -> Rgb {
    match numerics {
        Numerics::Robust => image.at(place(on_ball(shape, hit))),
        Numerics::Classic => classic_texel::<f64>(image, shape, hit),
        Numerics::ClassicF32 => classic_texel::<f32>(image, shape, hit),
    }
}

/// The colour of the image over a beam's footprint on a round shape.
pub(super) fn texel_over(
    image: &TextureMap,
    shape: &Shape,
    hit: &Hit,
    beam: &Beam,
    filter: Filter,
) -> Rgb {
    let Some([center, axes]) = shape.round() else {
        return hit.texel;
    };
    let steps = beam.steps_at(&hit.point.about(center), hit.normal);
    let steps = steps.map(|step| step / axes);
    let direction = on_ball(shape, hit);
    // The rates at which longitude and latitude change; at a pole, infinite.
    let around = direction.x * direction.x + direction.z * direction.z;
    let spread = Spread {
        place: place(direction),
        steps: steps.map(|step| {
            let turn = (direction.z * step.x - direction.x * step.z) / around;
            DVec2::new(turn / (2.0 * PI), step.y / around.sqrt() / PI)
        }),
    };
    let wraps = [Wrap::Repeat, Wrap::Clamp];
    image.filtered_linearly(filter, hit.texel, &image.in_texels(spread), wraps)
}

/// The unit vector of a hit in the space where the shape is the unit sphere.
fn on_ball(shape: &Shape, hit: &Hit) -> DVec3 {
    match shape {
        Shape::Ellipsoid(ellipsoid) => {
            let [center, axes] = ellipsoid.extent();
            direction(hit.point.from(center) / axes)
        }
        _ => hit.normal,
    }
}

/// The position in the image, from 0 to 1 along each side.
fn place(direction: DVec3) -> DVec2 {
    let longitude = libm::atan2(direction.x, direction.z);
    let latitude = libm::asin(direction.y.clamp(-1.0, 1.0));
    DVec2::new(0.5 + longitude / (2.0 * PI), 0.5 + latitude / PI)
}

/// The texel by the classic numerics.
fn classic_texel<T: Scalar>(image: &TextureMap, shape: &Shape, hit: &Hit) -> Rgb {
    let Some([center, axes]) = shape.round() else {
        return hit.texel;
    };
    let offset = Vector::<T>::of(hit.point.world()) - Vector::of(center);
    let direction = offset.over(Vector::of(axes)).unit();
    let longitude = T::angle(direction.x, direction.z);
    let latitude = T::angle_of_sine(direction.y.max(-T::one()).min(T::one()));
    let half = T::of(0.5);
    let (half_turn, turn) = (T::of(PI), T::of(2.0 * PI));
    let (xrel, yrel) = (half + longitude / turn, half + latitude / half_turn);
    gettexel(&image.texture, xrel, yrel)
}
