//! Cones of spotlights.

use glam::DVec3;

use super::{ATTRIBUTES, Light};
use crate::language::{Attribute, Naming, Node, Range, Schema, Takes, ValueError};
use crate::math::unit;

/// A cone of light of constant intensity with a hard edge.
#[derive(Debug, Clone, PartialEq)]
pub struct Cone {
    point: DVec3,
    theta: f64,
    axis: DVec3,
    cosine: f64,
}

impl Cone {
    /// The `spotlight` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "spotlight",
        about: "A light that shines into a cone.",
        attributes: &[
            ATTRIBUTES,
            &[
                Attribute::new("point", Takes::Triple, "a point on the axis of the cone")
                    .unit("world units"),
                Attribute::new(
                    "theta",
                    Takes::Number(Range::Inside(0.0, 180.0)),
                    "angle between the axis and the edge of the cone",
                )
                .unit("degrees"),
            ],
        ],
        naming: Naming::Optional,
        ..Light::SCHEMA
    };

    /// The cone from a location towards a point; `theta` is the half-angle in degrees.
    ///
    /// # Errors
    /// Returns an error if location and point are equal.
    pub fn new(location: DVec3, point: DVec3, theta: f64) -> Result<Self, ValueError> {
        let axis = unit(point - location).ok_or_else(|| {
            ValueError::new(
                "point",
                "the spotlight points at its own location",
                "give `point` another position, on the axis of the cone",
            )
            .expected("expected another point than `location`")
        })?;
        Ok(Self {
            point,
            theta,
            axis,
            cosine: libm::cos(theta.to_radians()),
        })
    }

    /// True if a unit direction from the light lies inside.
    #[must_use]
    pub fn contains(&self, direction: DVec3) -> bool {
        self.axis.dot(direction) > self.cosine
    }

    /// The unit direction of its axis.
    #[must_use]
    pub fn axis(&self) -> DVec3 {
        self.axis
    }

    /// The angle between axis and edge, in radians.
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.theta.to_radians()
    }

    /// Adds the cone's attributes to a light's node.
    pub(super) fn describe_into(&self, node: Node) -> Node {
        node.with("point", self.point).with("theta", self.theta)
    }
}
