//! The procedural plane.
//!
//! ```
//! # heliodon::doctest::surface(r#"
//! procedural-plane "wall" {
//!     material "gray"
//!     point 0 0 -4
//!     normal 0 0 1
//!     shader "stripes"
//! }
//! # "#, [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], Some(4.0));
//! ```

use std::f64::consts::PI;

use super::{Common, Hit, Surface};
use crate::geometry::{Plane, Shape};
use crate::language::{Attribute, Naming, Node, Schema, Takes, words};
use crate::math::Rgb;

/// An unbounded plane whose ambient colour is a formula; the course's two examples.
#[derive(Debug, Clone)]
pub struct ProceduralPlane {
    common: Common,
    shape: Shape,
    shader: Shader,
}

/// A formula from a point to a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shader {
    /// Curved stripes without red or without blue.
    Stripes,
    /// The three channels as waves around the plane's point, 120° apart.
    ColorWheel,
}

words!(Shader {
    Stripes: "stripes",
    ColorWheel: "color-wheel",
});

impl Shader {
    /// The largest channel of any of its colours.
    const LARGEST: f64 = 2.0;

    /// The colour at an offset from the plane's point, along the world's x and y.
    fn at(self, x: f64, y: f64) -> Rgb {
        match self {
            Self::Stripes => {
                let stripe = (1000.0 + x * y * y / 100.0 + x * y / 100.0).trunc();
                if stripe.rem_euclid(2.0) == 1.0 {
                    Rgb::new(0.0, 1.0, 1.0)
                } else {
                    Rgb::new(1.0, 1.0, 0.0)
                }
            }
            Self::ColorWheel => {
                // From 0 to `LARGEST`.
                let angle = libm::atan2(y, x);
                let wave = |phase: f64| 1.0 + libm::cos(2.0 * angle + phase);
                Rgb::new(wave(0.0), wave(2.0 * PI / 3.0), wave(4.0 * PI / 3.0))
            }
        }
    }
}

impl ProceduralPlane {
    /// The `procedural-plane` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "procedural-plane",
        about: "An unbounded plane with an ambient colour that is a formula of the position.",
        naming: Naming::Optional,
        value: None,
        properties: &[],
        attributes: &[
            Common::ATTRIBUTES,
            Plane::ATTRIBUTES,
            &[Attribute::new(
                "shader",
                Takes::Word(&Shader::WORDS),
                "the formula of the colour",
            )],
        ],
    };

    /// A plane with a formula that multiplies its ambient colour.
    #[must_use]
    pub fn new(common: Common, plane: Plane, shader: Shader) -> Self {
        let shape = plane.into();
        Self {
            common,
            shape,
            shader,
        }
    }
}

impl Surface for ProceduralPlane {
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
        let node = Node::new(&Self::SCHEMA, None);
        let node = self.shape.describe_into(node);
        node.with("shader", self.shader.word())
    }

    fn getamb(&self, hit: &Hit) -> Rgb {
        let offset = hit.point.from(self.shape.anchor());
        self.common.material.ambient * hit.texel * self.shader.at(offset.x, offset.y)
    }

    fn brightest(&self) -> [f64; 2] {
        let material = &self.common.material;
        let ambient = material.ambient.largest() * Shader::LARGEST;
        [ambient, material.diffuse.largest()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stripes_take_red_or_blue() {
        assert_eq!(Shader::Stripes.at(0.0, 0.0), Rgb::new(1.0, 1.0, 0.0));
        assert_eq!(Shader::Stripes.at(50.0, 1.0), Rgb::new(0.0, 1.0, 1.0));
        assert_eq!(Shader::Stripes.at(-50.0, 1.0), Rgb::new(0.0, 1.0, 1.0));
    }

    #[test]
    fn the_wheel_is_reddest_along_x() {
        let color = Shader::ColorWheel.at(1.0, 0.0);
        assert!(
            (color.r - 2.0).abs() < 1e-15 && (color.g - 0.5).abs() < 1e-15,
            "{color:?}"
        );
    }
}
