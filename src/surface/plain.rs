//! A shape that shows its material.

use super::{Common, Surface, globe};
use crate::geometry::{Ellipsoid, Plane, Rectangle, Shape, Sphere, Triangle};
use crate::language::{Attribute, Naming, Node, Schema};

/// A shape that shows its material.
#[derive(Debug, Clone)]
pub struct Plain {
    common: Common,
    shape: Shape,
}

impl Plain {
    /// The `plane` node of the scene language.
    pub const PLANE: Schema = schema(
        "plane",
        "An unbounded plane, lit on the side that its normal points to.",
        &[Common::ATTRIBUTES, Plane::ATTRIBUTES],
    );

    /// The `finite-plane` node of the scene language.
    pub const FINITE_PLANE: Schema = schema(
        "finite-plane",
        "A rectangle; all four borders belong to it.",
        &[Common::ATTRIBUTES, Rectangle::ATTRIBUTES],
    );

    /// The `triangle` node of the scene language.
    pub const TRIANGLE: Schema = schema(
        "triangle",
        "A triangle, lit on the side from which its vertices run counter-clockwise.",
        &[Common::ATTRIBUTES, Triangle::ATTRIBUTES],
    );

    /// The `sphere` node of the scene language.
    pub const SPHERE: Schema = schema(
        "sphere",
        "A sphere, seen and lit from outside.",
        &[Common::ATTRIBUTES, Sphere::ATTRIBUTES, globe::ATTRIBUTES],
    );

    /// The `ellipsoid` node of the scene language.
    pub const ELLIPSOID: Schema = schema(
        "ellipsoid",
        "A sphere stretched along the world's axes.",
        &[
            Common::ATTRIBUTES,
            Sphere::ATTRIBUTES,
            Ellipsoid::ATTRIBUTES,
            globe::ATTRIBUTES,
        ],
    );

    /// A shape that shows its material.
    #[must_use]
    pub fn new(common: Common, shape: impl Into<Shape>) -> Self {
        let shape = shape.into().entered(common.material.is_entered());
        Self { common, shape }
    }

    /// The node of a shape.
    pub(super) fn node_of(shape: &Shape) -> Node {
        let schema = match shape {
            Shape::Plane(_) => &Self::PLANE,
            Shape::Rectangle(_) => &Self::FINITE_PLANE,
            Shape::Triangle(_) => &Self::TRIANGLE,
            Shape::Sphere(_) => &Self::SPHERE,
            Shape::Ellipsoid(_) => &Self::ELLIPSOID,
        };
        shape.describe_into(Node::new(schema, None))
    }
}

const fn schema(
    word: &'static str,
    about: &'static str,
    attributes: &'static [&'static [Attribute]],
) -> Schema {
    Schema {
        word,
        about,
        naming: Naming::Optional,
        value: None,
        properties: &[],
        attributes,
    }
}

impl Surface for Plain {
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
        Self::node_of(&self.shape)
    }
}
