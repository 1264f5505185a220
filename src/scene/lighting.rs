//! How light fades with distance.

use crate::language::{Attribute, Default, Naming, Node, Range, Schema, Takes, words};

/// How light fades on its way from the lights and to the eye. The default is the chapter's model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lighting {
    /// Fading with the distance from a light.
    pub falloff: Falloff,
    /// Fading with the whole way from the eye, mirrors included.
    pub view_falloff: Falloff,
    /// Nothing is seen after a way from the eye longer than this, in world units.
    pub reach: f64,
}

/// How an intensity fades with a distance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Falloff {
    /// Not at all.
    None,
    /// By 1/d.
    #[default]
    Inverse,
    /// By 1/d².
    InverseSquare,
}

words!(Falloff {
    None: "none",
    Inverse: "inverse",
    InverseSquare: "inverse-square",
});

impl Falloff {
    /// What an intensity is divided by at a distance; never zero, however near.
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
        about: "How light fades; without it, as in the chapter.",
        naming: Naming::None,
        value: None,
        properties: &[],
        attributes: &[&[
            Attribute::new(
                "falloff",
                Takes::Word(&Falloff::WORDS),
                "with the way from a light",
            )
            .or(Default::Word(Falloff::Inverse.word())),
            Attribute::new(
                "view-falloff",
                Takes::Word(&Falloff::WORDS),
                "with the whole way from the eye, mirrors included",
            )
            .or(Default::Word(Falloff::Inverse.word())),
            Attribute::new(
                "reach",
                Takes::Number(Range::Positive),
                "rays that have come further than this see nothing; without it there is no limit",
            )
            .unit("world units")
            .optional(),
        ]],
    };

    /// What a `lighting` node says.
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

    /// The settings as a node of the scene language.
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
