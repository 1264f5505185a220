//! How a surface answers light.

use crate::language::{Attribute, Default, Naming, Node, Range, Schema, Takes, Value};
use crate::math::Rgb;

/// The reflectivities of a surface. They are divided by distances, so values above 1 are usual.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// The name that surfaces use.
    pub name: String,
    /// Reflectivity for light that is everywhere.
    pub ambient: Rgb,
    /// Reflectivity for light that comes from a light.
    pub diffuse: Rgb,
    /// Reflectivity of the mirror that the surface is, and colour of its glints.
    pub specular: Rgb,
    /// Exponent of the glint around a light's mirror image; 0 for none.
    pub shininess: f64,
    /// Share of the light that goes through, from 0 to 1.
    pub transparency: f64,
    /// Index of refraction of what is behind the surface, from 1 to 10; `None` for a thin one that
    /// bends nothing and mirrors as `specular` says.
    pub ior: Option<f64>,
}

impl Material {
    /// The `material` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "material",
        about: "How a surface answers light.",
        naming: Naming::Required,
        value: None,
        properties: &[],
        attributes: &[&[
            Attribute::new(
                "ambient",
                Takes::Color,
                "reflectivity for light that is everywhere",
            )
            .or(Default::Number(0.0)),
            Attribute::new(
                "diffuse",
                Takes::Color,
                "reflectivity for the light of the lights",
            )
            .or(Default::Number(0.0)),
            Attribute::new(
                "specular",
                Takes::Color,
                "reflectivity of the mirror, and of glints",
            )
            .or(Default::Number(0.0)),
            Attribute::new(
                "shininess",
                Takes::Number(Range::NotNegative),
                "exponent of the glint of a light; the higher, the smaller; 0 for none",
            )
            .or(Default::Number(0.0)),
            Attribute::new(
                "transparency",
                Takes::Number(Range::Between(0.0, 1.0)),
                "share of the light that goes straight through, tinted by `diffuse`",
            )
            .or(Default::Number(0.0)),
            Attribute::new(
                "ior",
                Takes::Number(Range::Between(1.0, 10.0)),
                "index of refraction of what is behind the surface: glass 1.5, water 1.33; the \
                 mirror is then Fresnel's, and what goes through is bent",
            )
            .optional(),
        ]],
    };

    /// Whether lights make glints on it.
    #[must_use]
    pub fn has_glints(&self) -> bool {
        self.shininess > 0.0 && !self.specular.is_black()
    }

    /// Whether it mirrors what is before it.
    #[must_use]
    pub fn mirrors(&self) -> bool {
        self.ior.is_some() || !self.specular.is_black()
    }

    /// Whether rays that meet it cause others.
    #[must_use]
    pub fn sends_on(&self) -> bool {
        self.transparency > 0.0 || self.mirrors()
    }

    /// The colour that light takes on its way through: `diffuse`, its largest channel made 1.
    ///
    /// A material without `diffuse` is clear.
    #[must_use]
    pub fn filter(&self) -> Rgb {
        let largest = self.diffuse.max_channel();
        if largest > 0.0 {
            self.diffuse / largest
        } else {
            Rgb::WHITE
        }
    }

    /// Whether rays can be inside of what is made of it.
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

/// One number for a gray, three for anything else.
fn gray_or_color(color: Rgb) -> Value {
    let [r, g, b] = color.channels().map(f64::to_bits);
    if r == g && g == b {
        Value::Number(color.r)
    } else {
        Value::Triple(color.channels())
    }
}
