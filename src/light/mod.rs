//! What illuminates: a point that shines everywhere, in a cone, or through a slide.

mod cone;
mod slide;

pub use cone::Cone;
pub use slide::Slide;

use glam::DVec3;

use crate::language::{Attribute, Location, Naming, Node, Schema, Takes};
use crate::math::{Point, Rgb};

/// A light. Lights themselves are not seen.
#[derive(Debug, Clone)]
pub struct Light {
    /// Its name, if the scene gives one.
    pub name: Option<String>,
    /// Where it shines from.
    pub location: DVec3,
    /// How much light leaves it; divided by the distance on the way.
    pub emissivity: Rgb,
    /// Where it shines to.
    pub beam: Beam,
    /// Where it stands in the scene file, if it was read from one.
    pub place: Option<Location>,
}

/// Where a light shines to.
#[derive(Debug, Clone)]
pub enum Beam {
    /// In all directions: `light`.
    Everywhere,
    /// Into a cone: `spotlight`.
    Cone(Cone),
    /// Through a slide: `projector`.
    Slide(Box<Slide>),
}

const ATTRIBUTES: &[Attribute] = &[
    Attribute::new("location", Takes::Triple, "where it shines from").unit("world units"),
    Attribute::new("emissivity", Takes::Color, "how much light leaves it"),
];

impl Light {
    /// The `light` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "light",
        about: "A point that shines in all directions; it is not seen itself.",
        naming: Naming::Optional,
        value: None,
        properties: &[],
        attributes: &[ATTRIBUTES],
    };

    /// The light that comes from where a unit direction leads to; `None` outside of the beam.
    #[must_use]
    #[inline(always)]
    pub fn seen_along(&self, direction: DVec3) -> Option<Rgb> {
        match &self.beam {
            Beam::Everywhere => Some(self.emissivity),
            _ => self.beam_towards(-direction),
        }
    }

    /// The light that leaves in a direction, if it is not the same in all of them.
    fn beam_towards(&self, direction: DVec3) -> Option<Rgb> {
        match &self.beam {
            Beam::Everywhere => Some(self.emissivity),
            Beam::Cone(cone) => cone.contains(direction).then_some(self.emissivity),
            Beam::Slide(slide) => {
                let color = slide.color(Point::exact(self.location), direction)?;
                Some(self.emissivity * color)
            }
        }
    }

    /// The light as a node of the scene language.
    #[must_use]
    pub fn describe(&self) -> Node {
        let schema = match &self.beam {
            Beam::Everywhere => &Self::SCHEMA,
            Beam::Cone(_) => &Cone::SCHEMA,
            Beam::Slide(_) => &Slide::SCHEMA,
        };
        let node = Node::new(schema, self.name.as_deref())
            .with("location", self.location)
            .with("emissivity", DVec3::from(self.emissivity));
        match &self.beam {
            Beam::Everywhere => node,
            Beam::Cone(cone) => cone.describe_into(node),
            Beam::Slide(slide) => slide.describe_into(node),
        }
    }
}
