//! The properties of every surface.

use std::sync::Arc;

use crate::language::{Attribute, Default, Location, Node, Reference, Takes};
use crate::material::Material;
use crate::math::Rgb;

/// A surface's name, material, and part in shadows.
#[derive(Debug, Clone, PartialEq)]
pub struct Common {
    /// Its name, if the scene gives one.
    pub name: Option<String>,
    /// The material.
    pub material: Arc<Material>,
    /// Its part in shadows.
    pub shadows: Shadows,
    /// The position in the scene file, if it was read from one.
    pub location: Option<Location>,
}

/// A surface's part in shadows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shadows {
    /// True if other surfaces can shadow it: the chapter's `light_visible` test.
    pub receive: bool,
    /// True if it can shadow other surfaces.
    pub cast: bool,
}

impl std::default::Default for Shadows {
    fn default() -> Self {
        Self {
            receive: true,
            cast: true,
        }
    }
}

impl Common {
    /// The attributes that every surface takes.
    pub const ATTRIBUTES: &'static [Attribute] = &[
        Attribute::new(
            "material",
            Takes::Name(Reference::Material),
            "the material of the surface",
        ),
        Attribute::new("shadows", Takes::Nothing, "its shadows")
            .optional()
            .with(&[
                Attribute::new(
                    "receive",
                    Takes::Flag,
                    "whether other surfaces cast shadows on it",
                )
                .or(Default::Flag(true)),
                Attribute::new("cast", Takes::Flag, "whether it casts shadows")
                    .or(Default::Flag(true)),
            ]),
    ];

    /// The properties of a surface that reflects no light: a black material.
    #[must_use]
    pub fn black(name: Option<String>, location: Option<Location>) -> Self {
        let material = Material {
            name: String::new(),
            ambient: Rgb::BLACK,
            diffuse: Rgb::BLACK,
            specular: Rgb::BLACK,
            shininess: 0.0,
            transparency: 0.0,
            ior: None,
        };
        Self {
            name,
            location,
            ..Self::new(Arc::new(material))
        }
    }

    /// A surface of this material without a name.
    #[must_use]
    pub fn new(material: Arc<Material>) -> Self {
        Self {
            name: None,
            material,
            shadows: Shadows::default(),
            location: None,
        }
    }

    /// The share of light that passes straight through where the texel has this colour.
    #[must_use]
    pub fn transmits(&self, texel: Rgb) -> Rgb {
        self.material.tint() * self.material.transparency * texel
    }

    /// Adds the common properties to a surface's node.
    #[must_use]
    pub fn describe(&self, mut node: Node) -> Node {
        node.name.clone_from(&self.name);
        if !node.schema.attributes.contains(&Self::ATTRIBUTES) {
            // A lamp has neither material nor part in shadows.
            return node;
        }
        let geometry = std::mem::take(&mut node.attributes);
        let mut node = node.with("material", self.material.name.as_str());
        node.attributes.extend(geometry);
        let Shadows { receive, cast } = self.shadows;
        node.with_entry(
            "shadows",
            None,
            &[("receive", receive.into()), ("cast", cast.into())],
        )
    }
}
