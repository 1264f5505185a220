//! Materials: the reflectivities of surfaces.

use crate::language::{Attribute, Default, Naming, Node, Range, Schema, Takes, Value};
use crate::math::Rgb;

/// The reflectivities of a surface.
///
/// The result is divided by distances, so values above 1 are usual.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// The name that surfaces use.
    pub name: String,
    /// Reflectivity for ambient light.
    pub ambient: Rgb,
    /// Reflectivity for the light of lights.
    pub diffuse: Rgb,
    /// Reflectivity of the mirror, and colour of the specular highlights.
    pub specular: Rgb,
    /// Exponent of the specular highlights; 0 for none.
    pub shininess: f64,
    /// Fraction of the light that passes through, from 0 to 1.
    pub transparency: f64,
    /// Index of refraction behind the surface, from 1 to 10.
    ///
    /// `None` for a thin surface: it does not refract, and it reflects by `specular`.
    pub ior: Option<f64>,
}

impl Material {
    /// The `material` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "material",
        about: "The reflectivities of a surface.",
        naming: Naming::Required,
        value: None,
        properties: &[],
        attributes: &[&[
            Attribute::new("ambient", Takes::Color, "reflectivity for ambient light")
                .or(Default::Number(0.0)),
            Attribute::new(
                "diffuse",
                Takes::Color,
                "reflectivity for the light of lights and lamps",
            )
            .or(Default::Number(0.0)),
            Attribute::new(
                "specular",
                Takes::Color,
                "reflectivity of the mirror, and of specular highlights",
            )
            .or(Default::Number(0.0)),
            Attribute::new(
                "shininess",
                Takes::Number(Range::NotNegative),
                "exponent of the specular highlights; larger is smaller; 0 for none",
            )
            .or(Default::Number(0.0)),
            Attribute::new(
                "transparency",
                Takes::Number(Range::Between(0.0, 1.0)),
                "fraction of the light that passes straight through, tinted by `diffuse`",
            )
            .or(Default::Number(0.0)),
            Attribute::new(
                "ior",
                Takes::Number(Range::Between(1.0, 10.0)),
                "index of refraction behind the surface: glass 1.5, water 1.33; it turns on \
                 refraction and Fresnel reflection",
            )
            .optional(),
        ]],
    };

    /// True if it shows specular highlights of lights.
    #[must_use]
    pub fn has_highlights(&self) -> bool {
        self.shininess > 0.0 && !self.specular.is_black()
    }

    /// True if it reflects rays.
    #[must_use]
    pub fn mirrors(&self) -> bool {
        self.ior.is_some() || !self.specular.is_black()
    }

    /// True if a hit spawns reflected or transmitted rays.
    #[must_use]
    pub fn spawns_rays(&self) -> bool {
        self.transparency > 0.0 || self.mirrors()
    }

    /// The colour of transmitted white light: `diffuse` divided by its largest channel.
    ///
    /// Without `diffuse` it is white.
    #[must_use]
    pub fn tint(&self) -> Rgb {
        let largest = self.diffuse.max_channel();
        if largest > 0.0 {
            self.diffuse / largest
        } else {
            Rgb::WHITE
        }
    }

    /// True if rays can travel inside of the material.
    #[must_use]
    pub fn is_entered(&self) -> bool {
        self.ior.is_some() && self.transparency > 0.0
    }

    /// The material as a node of the scene language.
    #[must_use]
    pub fn describe(&self) -> Node {
        let node = Node::new(&Self::SCHEMA, Some(&self.name))
            .with("ambient", gray_or_color(self.ambient))
            .with("diffuse", gray_or_color(self.diffuse))
            .with("specular", gray_or_color(self.specular))
            .with("shininess", self.shininess)
            .with("transparency", self.transparency);
        match self.ior {
            Some(ior) => node.with("ior", ior),
            None => node,
        }
    }
}

/// One number for a gray, three numbers for another colour.
fn gray_or_color(color: Rgb) -> Value {
    let [r, g, b] = color.channels().map(f64::to_bits);
    if r == g && g == b {
        Value::Number(color.r)
    } else {
        Value::Triple(color.channels())
    }
}
