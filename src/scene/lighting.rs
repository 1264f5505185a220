//! Falloff of light with distance.

use crate::language::{Attribute, Default, Naming, Node, Range, Schema, Takes, words};

/// The falloff of light from the lights and to the eye.
///
/// The default is the chapter's model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lighting {
    /// The falloff with the distance from a light.
    pub falloff: Falloff,
    /// The falloff with the length of the path from the eye, mirrors included.
    pub view_falloff: Falloff,
    /// The longest path from the eye to a ray's origin, in world units.
    ///
    /// Rays beyond it are black.
    pub reach: f64,
}

/// The falloff of an intensity with a distance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Falloff {
    /// Constant.
    None,
    /// As 1/d.
    #[default]
    Inverse,
    /// As 1/d².
    InverseSquare,
}

words!(Falloff {
    None: "none",
    Inverse: "inverse",
    InverseSquare: "inverse-square",
});

impl Falloff {
    /// The divisor of an intensity at a distance, always above zero.
    #[must_use]
    pub fn divisor(self, distance: f64) -> f64 {
        let divisor = match self {
            Self::None => 1.0,
            Self::Inverse => distance,
            Self::InverseSquare => distance * distance,
        };
        divisor.max(f64::MIN_POSITIVE)
    }
}

impl std::default::Default for Lighting {
    fn default() -> Self {
        Self {
            falloff: Falloff::Inverse,
            view_falloff: Falloff::Inverse,
            reach: f64::INFINITY,
        }
    }
}

impl Lighting {
    /// The `lighting` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "lighting",
        about: "The falloff of light with distance; the default is the chapter's.",
        naming: Naming::None,
        value: None,
        properties: &[],
        attributes: &[&[
            Attribute::new(
                "falloff",
                Takes::Word(&Falloff::WORDS),
                "falloff with the distance from a light",
            )
            .or(Default::Word(Falloff::Inverse.word())),
            Attribute::new(
                "view-falloff",
                Takes::Word(&Falloff::WORDS),
                "falloff with the length of the path from the eye, mirrors included",
            )
            .or(Default::Word(Falloff::Inverse.word())),
            Attribute::new(
                "reach",
                Takes::Number(Range::Positive),
                "longest path from the eye to a ray's origin; rays beyond it are black",
            )
            .unit("world units")
            .optional(),
        ]],
    };

    /// The lighting of a `lighting` node.
    #[must_use]
    pub fn from_node(node: &Node) -> Self {
        let falloff = |word| Falloff::from_word(&node.text(word)).unwrap_or_default();
        Self {
            falloff: falloff("falloff"),
            view_falloff: falloff("view-falloff"),
            reach: node
                .get("reach")
                .map_or(f64::INFINITY, |value| value.number()),
        }
    }

    /// The lighting as a node of the scene language.
    #[must_use]
    pub fn describe(&self) -> Node {
        let node = Node::new(&Self::SCHEMA, None)
            .with("falloff", self.falloff.word())
            .with("view-falloff", self.view_falloff.word());
        if self.reach.is_finite() {
            node.with("reach", self.reach)
        } else {
            node
        }
    }
}
