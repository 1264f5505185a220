//! The lamp.
//!
//! ```
//! # heliodon::doctest::surface(r#"
//! lamp "ceiling" {
//!     point -1 2 -3
//!     normal 0 -1 0
//!     xdir 1 0 0
//!     dimensions 2 1
//!     emissivity 12
//! }
//! # "#, [0.0, 0.0, -2.5], [0.0, 1.0, 0.0], Some(2.0));
//! # heliodon::doctest::surface(r#"
//! lamp "globe" {
//!     center 0 1 -4
//!     radius 1
//!     emissivity 12
//! }
//! # "#, [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], Some(3.0));
//! ```

use glam::DVec3;

use super::{Common, Surface};
use crate::geometry::{Rectangle, Shape, Sphere};
use crate::language::{Attribute, Default, Naming, Node, Range, Schema, Takes, ValueError};
use crate::math::exact::Sign;
use crate::math::{Ray, Rgb};

/// A rectangle or a sphere that emits light and is visible.
#[derive(Debug, Clone)]
pub struct Lamp {
    common: Common,
    shape: Shape,
    emissivity: Rgb,
    samples: u32,
}

impl Lamp {
    /// The largest number of sample points: the length of the sequence.
    const MOST_SAMPLES: u32 = 65_536;

    /// The `lamp` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "lamp",
        about: "A rectangle or a sphere that emits light and is seen; its shadows are soft.",
        naming: Naming::Optional,
        value: None,
        properties: &[],
        attributes: &[&[
            Attribute::new(
                "point",
                Takes::Triple,
                "the lower-left corner of a rectangle, which emits light on its front",
            )
            .unit("world units")
            .optional(),
            Attribute::new(
                "normal",
                Takes::Triple,
                "the normal of a rectangle, on the side that emits light; any length except zero",
            )
            .optional(),
            Attribute::new(
                "xdir",
                Takes::Triple,
                "direction of a rectangle's own x axis; projected into its plane",
            )
            .optional(),
            Attribute::new(
                "dimensions",
                Takes::Pair(Range::Positive),
                "width of a rectangle along its x axis, height along its y axis",
            )
            .unit("world units")
            .optional(),
            Attribute::new("center", Takes::Triple, "the centre of a sphere")
                .unit("world units")
                .optional(),
            Attribute::new(
                "radius",
                Takes::Number(Range::Positive),
                "the radius of a sphere",
            )
            .unit("world units")
            .optional(),
            Attribute::new(
                "emissivity",
                Takes::Color,
                "brightness, equal at all points; the light on a surface depends on the lamp's \
                 apparent size, not on `falloff`",
            ),
            Attribute::new(
                "samples",
                Takes::Number(Range::Whole(1, Self::MOST_SAMPLES)),
                "points on the lamp that are tested where its shadow may be soft; powers of two \
                 are best",
            )
            .or(Default::Number(64.0)),
        ]],
    };

    const RECTANGLE: [&'static str; 4] = ["point", "normal", "xdir", "dimensions"];
    const BALL: [&'static str; 2] = ["center", "radius"];
    const RECTANGLE_HAS: &'static str =
        "a rectangle has `point`, `normal`, `xdir` and `dimensions`";
    const BALL_HAS: &'static str = "a ball has `center` and `radius`";

    /// The lamp of a `lamp` node.
    ///
    /// # Errors
    /// Returns an error for a lamp that is neither a rectangle nor a ball, or both, or lacks a part
    /// of either; and those of [`Rectangle::new`] and [`Sphere::new`].
    pub fn from_node(node: &Node, common: Common) -> Result<Self, ValueError> {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "the schema allows small whole numbers only"
        )]
        let samples = node.number("samples") as u32;
        let shape = if is_rectangle(node)? {
            Rectangle::from_node(node)?.into()
        } else {
            Sphere::from_node(node)?.into()
        };
        Ok(Self {
            common,
            shape,
            emissivity: node.triple("emissivity").into(),
            samples,
        })
    }

    /// The intensity of its light.
    #[must_use]
    pub fn emissivity(&self) -> Rgb {
        self.emissivity
    }

    /// The number of sample points for shadow rays where the shadow may be soft.
    #[must_use]
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// The colour that a ray sees on the lamp; the back of a rectangle is black.
    #[must_use]
    pub fn shows(&self, ray: &Ray) -> Rgb {
        let from_behind = self
            .shape
            .carrier()
            .is_some_and(|flat| flat.exact_slope(ray.dir).sign() != Sign::Negative);
        if from_behind {
            Rgb::BLACK
        } else {
            self.emissivity
        }
    }
}

/// Returns whether a lamp is a rectangle and not a sphere.
///
/// # Errors
/// Returns an error if it is neither, both, or incomplete.
fn is_rectangle(node: &Node) -> Result<bool, ValueError> {
    let given = |words: &[&'static str]| {
        let mut words = words.iter();
        words.find(|word| node.entry(word).is_some()).copied()
    };
    let (words, they) = match (given(&Lamp::RECTANGLE), given(&Lamp::BALL)) {
        (Some(_), None) => (&Lamp::RECTANGLE[..], Lamp::RECTANGLE_HAS),
        (None, Some(_)) => (&Lamp::BALL[..], Lamp::BALL_HAS),
        (None, None) => {
            let advice = format!("{}, {}", Lamp::RECTANGLE_HAS, Lamp::BALL_HAS);
            return Err(ValueError::new("lamp", "the lamp has no shape", advice)
                .expected("expected a rectangle or a ball between its braces"));
        }
        (Some(rectangle), Some(ball)) => {
            let reason = format!("the lamp has both `{rectangle}` and `{ball}`");
            let advice = format!("{}, {}; keep one", Lamp::RECTANGLE_HAS, Lamp::BALL_HAS);
            return Err(ValueError::new(ball, reason, advice).expected("expected only one shape"));
        }
    };
    if let Some(lacks) = words.iter().find(|word| node.entry(word).is_none()) {
        let reason = format!("the lamp has no `{lacks}`");
        let expected = format!("expected `{lacks}` between its braces");
        return Err(ValueError::new(lacks, reason, they).expected(expected));
    }
    Ok(words.len() == Lamp::RECTANGLE.len())
}

impl Surface for Lamp {
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
        self.shape
            .describe_into(Node::new(&Self::SCHEMA, None))
            .with("emissivity", DVec3::from(self.emissivity))
            .with("samples", f64::from(self.samples))
    }

    fn lamp(&self) -> Option<&Lamp> {
        Some(self)
    }
}
