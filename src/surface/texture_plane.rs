//! The texture plane.
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

use glam::DVec3;

use super::{Anatomy, Common, Cover, FinitePlane, Hit, Surface};
use crate::language::{Attribute, Default, Naming, Node, Range, Reference, Schema, Takes, Value};
use crate::math::exact::{Distance, ExactVector};
use crate::math::{Beam, ExactGeometry, Flat, Line, Ray, Rectangle, Rgb, Segment, Side, Span};
use crate::texture::{Filter, Texture, TextureMap, Wrap};

/// A finite plane that wears an image: the chapter's `texplane_t`.
#[derive(Debug, Clone)]
pub struct TexturePlane {
    plane: FinitePlane,
    image: TextureMap,
    texel_given: bool,
}

impl TexturePlane {
    /// The attribute that puts a texture on a rectangle.
    pub(crate) const ATTRIBUTES: &[Attribute] = &[Attribute::new(
        "texture",
        Takes::Name(Reference::Texture),
        "the image that it wears",
    )
    .with(&[
        Attribute::new(
            "mode",
            Takes::Word(&Wrap::WORDS),
            "stretch the image over the whole surface, or tile it at its own scale",
        )
        .or(Default::Word(Wrap::Clamp.word())),
        Attribute::new(
            "texel",
            Takes::NumberOrPair(Range::Positive),
            "with `repeat`: size of a texel; one pixel of the chapter's screen if not given",
        )
        .unit("world units")
        .optional(),
    ])];

    /// The `texture-plane` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "texture-plane",
        about: "A rectangle that wears an image; the image multiplies `ambient` and `diffuse`.",
        naming: Naming::Optional,
        value: None,
        properties: &[],
        attributes: &[
            Common::ATTRIBUTES,
            FinitePlane::ATTRIBUTES,
            Self::ATTRIBUTES,
        ],
    };

    /// A finite plane with an image; `texel_given` tells whether the scene gives the texel's size
    /// or leaves it to the screen.
    #[must_use]
    pub fn new(plane: FinitePlane, image: TextureMap, texel_given: bool) -> Self {
        Self {
            plane,
            image,
            texel_given,
        }
    }

    /// Adds the texture of a rectangle to its node.
    pub(crate) fn describe_image(node: Node, image: &TextureMap, texel_given: bool) -> Node {
        let mut properties = vec![("mode", image.wrap.word().into())];
        if texel_given {
            properties.push(("texel", number_or_pair(image.size.to_array())));
        }
        let name = image.texture.name.as_str();
        node.with_entry("texture", Some(name.into()), &properties)
    }

    /// Settles a hit whose offset is off by as much as `doubt`, which may be another texel's.
    #[cold]
    fn settle_in_doubt(&self, hit: &mut Hit, doubt: f64, ray: &Ray) {
        let Rectangle { flat, frame, .. } = self.plane.rectangle();
        let exact = || frame.exact_offset(flat, ray);
        hit.uv = self.image.snapped(hit.uv, doubt, exact);
        hit.texel = self.image.at(hit.uv);
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

impl Surface for TexturePlane {
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        self.plane.hits(ray, span)
    }

    fn meetings(&self, rays: &[Ray], met: &mut [Option<Hit>]) {
        self.plane.meetings(rays, met);
        self.settle_all(rays, met);
    }

    fn common(&self) -> &Common {
        self.plane.common()
    }

    fn anatomy(&self) -> Option<Anatomy<'_>> {
        Some(self.plane.anatomy()?.covered(Cover::Image(&self.image)))
    }

    fn describe(&self) -> Node {
        let node = self.plane.describe_into(Node::new(&Self::SCHEMA, None));
        Self::describe_image(node, &self.image, self.texel_given)
    }

    fn flat(&self) -> Option<&Flat> {
        self.plane.flat()
    }

    fn outline(&self) -> Vec<DVec3> {
        self.plane.outline()
    }

    fn hull(&self) -> Option<Vec<ExactVector>> {
        self.plane.hull()
    }

    fn borders(&self) -> Vec<Line> {
        self.plane.borders()
    }

    fn slack(&self) -> f64 {
        self.plane.slack()
    }

    fn exact_geometry(&self) -> Option<ExactGeometry> {
        self.plane.exact_geometry()
    }

    fn weld(&mut self, plane: &Flat, borders: &[Option<Line>]) {
        self.plane.weld(plane, borders);
    }

    fn exact_distance(&self, ray: &Ray) -> Option<Distance> {
        self.plane.exact_distance(ray)
    }

    fn occludes(&self, segment: &Segment, end: Side) -> bool {
        self.plane.occludes(segment, end)
    }

    fn texture(&self) -> Option<&Texture> {
        Some(&self.image.texture)
    }

    fn settle(&self, hit: &mut Hit, ray: &Ray) {
        // The offset has the same roundings as the distance, and half as many again.
        let doubt = 3.0 * hit.error;
        match self.image.certain_texel(hit.uv, doubt) {
            Some(texel) => hit.texel = texel,
            None => self.settle_in_doubt(hit, doubt, ray),
        }
    }

    fn texel_over(&self, hit: &Hit, beam: &Beam, filter: Filter) -> Rgb {
        let Rectangle {
            flat, frame, size, ..
        } = self.plane.rectangle();
        let footprint = beam.on(flat.point, [frame.x, frame.y], flat.normal);
        self.image.filtered(filter, hit.texel, &footprint, *size)
    }
}
