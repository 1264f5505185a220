//! Lights: points that shine in all directions, in a cone, or through a slide.

mod cone;
mod slide;

pub use cone::Cone;
pub use slide::Slide;

use glam::DVec3;

use crate::language::{Attribute, Location, Naming, Node, Schema, Takes};
use crate::math::{Point, Rgb};

/// A point light. It is not visible itself.
#[derive(Debug, Clone)]
pub struct Light {
    /// Its name, if the scene gives one.
    pub name: Option<String>,
    /// Its position in world units.
    pub location: DVec3,
    /// Its intensity, before it fades with the distance.
    pub emissivity: Rgb,
    /// The directions of its light.
    pub beam: Beam,
    /// Its place in the scene file, if it was read from one.
    pub place: Option<Location>,
}

/// The directions of a light's emission.
#[derive(Debug, Clone)]
pub enum Beam {
    /// All directions: `light`.
    Everywhere,
    /// A cone: `spotlight`.
    Cone(Cone),
    /// Through a slide: `projector`.
    Slide(Box<Slide>),
}

const ATTRIBUTES: &[Attribute] = &[
    Attribute::new("location", Takes::Triple, "its position").unit("world units"),
    Attribute::new("emissivity", Takes::Color, "its intensity"),
];

impl Light {
    /// The `light` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "light",
        about: "A point that shines in all directions; it is not visible itself.",
        naming: Naming::Optional,
        value: None,
        properties: &[],
        attributes: &[ATTRIBUTES],
    };

    /// The light that arrives at a receiver; `None` outside of the beam.
    ///
    /// `to_light` is the unit direction from the receiver to the light.
    #[must_use]
    #[inline(always)]
    pub fn incident(&self, to_light: DVec3) -> Option<Rgb> {
        match &self.beam {
            Beam::Everywhere => Some(self.emissivity),
            _ => self.emitted(-to_light),
        }
    }

    /// The light that leaves in a direction.
    fn emitted(&self, direction: DVec3) -> Option<Rgb> {
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
