//! A shape covered by an image.
//!
//! ```
//! # heliodon::doctest::surface(r#"
//! texture-plane "poster" {
//!     material "gray"
//!     point -1 0 -2
//!     normal 0 0 1
//!     xdir 1 0 0
//!     dimensions 2 3
//!     texture "arrow" mode="clamp"
//! }
//! # "#, [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], Some(2.0));
//! ```

use std::sync::Arc;

use super::{Common, Hit, Plain, Resolved, Surface, globe};
use crate::geometry::{Rectangle, Shape};
use crate::language::{Attribute, Default, Naming, Node, Range, Reference, Schema, Takes, Value};
use crate::math::{Beam, Numerics, Ray, Rgb};
use crate::texture::{Filter, Texture, TextureMap, Wrap, texture_map};

/// A shape covered by an image: a rectangle is the chapter's `texplane_t`.
///
/// On a rectangle the image stands upright on the corner. Around a sphere or an ellipsoid it is
/// wrapped once.
#[derive(Debug, Clone)]
pub struct Textured {
    common: Common,
    shape: Shape,
    image: TextureMap,
    texel_given: bool,
}

impl Textured {
    /// The attribute that puts a texture on a rectangle.
    pub const ATTRIBUTES: &[Attribute] = &[Attribute::new(
        "texture",
        Takes::Name(Reference::Texture),
        "the image",
    )
    .with(&[
        Attribute::new(
            "mode",
            Takes::Word(&Wrap::WORDS),
            "`clamp` stretches the image over the whole surface, `repeat` tiles it",
        )
        .or(Default::Word(Wrap::Clamp.word())),
        Attribute::new(
            "texel",
            Takes::NumberOrPair(Range::Positive),
            "size of a texel, with `repeat`; one pixel of the chapter's screen if not given",
        )
        .unit("world units")
        .optional(),
    ])];

    /// The `texture-plane` node of the scene language.
    pub const PLANE: Schema = Schema {
        word: "texture-plane",
        about: "A rectangle with an image, which multiplies `ambient` and `diffuse`.",
        naming: Naming::Optional,
        value: None,
        properties: &[],
        attributes: &[Common::ATTRIBUTES, Rectangle::ATTRIBUTES, Self::ATTRIBUTES],
    };

    /// A rectangle with an image on it.
    ///
    /// `texel_given` is true if the scene gives the size of a texel; otherwise the screen does.
    #[must_use]
    pub fn plane(
        common: Common,
        rectangle: Rectangle,
        image: TextureMap,
        texel_given: bool,
    ) -> Self {
        Self {
            common,
            shape: rectangle.into(),
            image,
            texel_given,
        }
    }

    /// A sphere or an ellipsoid with an image wrapped around it.
    #[must_use]
    pub fn globe(common: Common, shape: impl Into<Shape>, texture: Arc<Texture>) -> Self {
        let shape = shape.into().entered(common.material.is_entered());
        Self {
            common,
            shape,
            image: TextureMap::clamp(texture, globe::WHOLE),
            texel_given: false,
        }
    }

    /// Adds the texture of a rectangle to its node.
    #[must_use]
    pub fn describe_image(node: Node, image: &TextureMap, texel_given: bool) -> Node {
        let mut properties = vec![("mode", image.wrap.word().into())];
        if texel_given {
            properties.push(("texel", number_or_pair(image.size.to_array())));
        }
        let name = image.texture.name.as_str();
        node.with_entry("texture", Some(name.into()), &properties)
    }

    /// The texel at a hit on a rectangle.
    #[inline]
    fn resolve_on(&self, rectangle: &Rectangle, hit: &Hit, ray: &Ray) -> Resolved {
        // The offset has the same roundings as the distance, and half as many again.
        let bound = 3.0 * hit.error;
        match self.image.certain_texel(hit.uv, bound) {
            Some(texel) => Resolved { uv: hit.uv, texel },
            None => self.resolve_exactly(rectangle, hit, bound, ray),
        }
    }

    /// The exact texel, if the error bound of the offset reaches more than one.
    #[cold]
    fn resolve_exactly(&self, rectangle: &Rectangle, hit: &Hit, bound: f64, ray: &Ray) -> Resolved {
        let exact = || rectangle.frame.exact_offset(&rectangle.flat, ray);
        let uv = self.image.snapped(hit.uv, bound, exact);
        let texel = self.image.at(uv);
        Resolved { uv, texel }
    }
}

/// One number for a square texel, two in quotes for another.
fn number_or_pair([x, y]: [f64; 2]) -> Value {
    if x.to_bits() == y.to_bits() {
        Value::Number(x)
    } else {
        Value::from(Value::Pair([x, y]).to_string().as_str())
    }
}

impl Surface for Textured {
    fn shape(&self) -> &Shape {
        &self.shape
    }

    fn shape_mut(&mut self) -> &mut Shape {
        &mut self.shape
    }

    fn common(&self) -> &Common {
        &self.common
    }

    fn describe(&self) -> Node {
        match &self.shape {
            Shape::Rectangle(rectangle) => {
                let node = rectangle.describe_into(Node::new(&Self::PLANE, None));
                Self::describe_image(node, &self.image, self.texel_given)
            }
            shape => Plain::node_of(shape).with("texture", self.image.texture.name.as_str()),
        }
    }

    fn resolve(&self, hit: &Hit, ray: &Ray, numerics: Numerics) -> Resolved {
        let texel = match (&self.shape, numerics) {
            (Shape::Rectangle(rectangle), Numerics::Robust) => {
                return self.resolve_on(rectangle, hit, ray);
            }
            (Shape::Rectangle(_), Numerics::Classic) => texture_map(&self.image, hit.uv.to_array()),
            (Shape::Rectangle(_), Numerics::ClassicF32) => {
                texture_map(&self.image, hit.uv.as_vec2().to_array())
            }
            (shape, _) => globe::texel(&self.image, shape, hit, numerics),
        };
        Resolved { uv: hit.uv, texel }
    }

    fn texture(&self) -> Option<&Texture> {
        Some(&self.image.texture)
    }

    fn texel_over(&self, hit: &Hit, beam: &Beam, filter: Filter) -> Rgb {
        let Shape::Rectangle(Rectangle {
            flat, frame, size, ..
        }) = &self.shape
        else {
            return globe::texel_over(&self.image, &self.shape, hit, beam, filter);
        };
        let footprint = beam.on(flat.point, [frame.x, frame.y], flat.normal);
        self.image.filtered(filter, hit.texel, &footprint, *size)
    }
}
