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

use super::lamp_form::LampForm;
use super::{Anatomy, Common, Hit, Surface};
use crate::language::{Attribute, Default, Naming, Node, Range, Schema, Takes, ValueError};
use crate::math::exact::{Distance, ExactVector, Sign};
use crate::math::{Bounds, ExactGeometry, Flat, Line, Point, Ray, Rgb, Segment, Side, Span};

/// A rectangle or a ball that shines, and is seen to.
#[derive(Debug, Clone)]
pub struct Lamp {
    pub(super) form: LampForm,
    emissivity: Rgb,
    samples: u32,
}

impl Lamp {
    /// The most places of a lamp that are asked for its shadow; more the sequence does not have.
    const MOST_SAMPLES: u32 = 65_536;

    /// The `lamp` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "lamp",
        about: "A rectangle or a ball that shines and is seen; its shadows are soft.",
        naming: Naming::Optional,
        value: None,
        properties: &[],
        attributes: &[&[
            Attribute::new(
                "point",
                Takes::Triple,
                "the lower-left corner of a rectangle, which shines on its front",
            )
            .unit("world units")
            .optional(),
            Attribute::new(
                "normal",
                Takes::Triple,
                "the direction in which a rectangle shines; any length but zero",
            )
            .optional(),
            Attribute::new(
                "xdir",
                Takes::Triple,
                "where a rectangle's own x grows; projected into its plane",
            )
            .optional(),
            Attribute::new(
                "dimensions",
                Takes::Pair(Range::Positive),
                "a rectangle's width along x, height along y",
            )
            .unit("world units")
            .optional(),
            Attribute::new("center", Takes::Triple, "the centre of a ball")
                .unit("world units")
                .optional(),
            Attribute::new(
                "radius",
                Takes::Number(Range::Positive),
                "the radius of a ball",
            )
            .unit("world units")
            .optional(),
            Attribute::new(
                "emissivity",
                Takes::Color,
                "how bright it is, all over; what it lights fades by its apparent size alone",
            ),
            Attribute::new(
                "samples",
                Takes::Number(Range::Whole(1, Self::MOST_SAMPLES)),
                "places of it that are asked where its shadow may be soft; powers of two are best",
            )
            .or(Default::Number(64.0)),
        ]],
    };

    /// What a `lamp` node says.
    ///
    /// # Errors
    /// Refuses a lamp that is neither a rectangle nor a ball, or both, or lacks a part of either; and
    /// what [`FinitePlane::new`](super::FinitePlane::new) and [`Sphere::new`](super::Sphere::new) refuse.
    pub fn from_node(node: &Node, common: Common) -> Result<Self, ValueError> {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "the schema allows small whole numbers only"
        )]
        let samples = node.number("samples") as u32;
        Ok(Self {
            form: LampForm::from_node(node, common)?,
            emissivity: node.triple("emissivity").into(),
            samples,
        })
    }

    /// How bright it is.
    #[must_use]
    pub fn emissivity(&self) -> Rgb {
        self.emissivity
    }

    /// How many places of it are asked where its shadow may be soft.
    #[must_use]
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// What is seen of it along a ray that meets it.
    #[must_use]
    pub fn shows(&self, ray: &Ray) -> Rgb {
        let from_behind = self
            .flat()
            .is_some_and(|flat| flat.exact_slope(ray.dir).sign() != Sign::Negative);
        if from_behind {
            Rgb::BLACK
        } else {
            self.emissivity
        }
    }
}

impl Surface for Lamp {
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        self.form.surface().hits(ray, span)
    }

    fn common(&self) -> &Common {
        self.form.surface().common()
    }

    fn lamp(&self) -> Option<&Lamp> {
        Some(self)
    }

    fn describe(&self) -> Node {
        let node = Node::new(&Self::SCHEMA, None);
        let node = match &self.form {
            LampForm::Pane(pane) => pane.describe_into(node),
            LampForm::Globe(globe) => globe.describe_into(node),
        };
        node.with("emissivity", DVec3::from(self.emissivity))
            .with("samples", f64::from(self.samples))
    }

    fn flat(&self) -> Option<&Flat> {
        self.form.surface().flat()
    }

    fn round(&self) -> Option<[DVec3; 2]> {
        self.form.surface().round()
    }

    fn outline(&self) -> Vec<DVec3> {
        self.form.surface().outline()
    }

    fn hull(&self) -> Option<Vec<ExactVector>> {
        self.form.surface().hull()
    }

    fn bounds(&self) -> Option<Bounds> {
        self.form.surface().bounds()
    }

    fn side(&self, point: &Point) -> Side {
        self.form.surface().side(point)
    }

    fn anatomy(&self) -> Option<Anatomy<'_>> {
        self.form.surface().anatomy()
    }

    fn occludes(&self, segment: &Segment, end: Side) -> bool {
        self.form.surface().occludes(segment, end)
    }

    fn error(&self, ray: &Ray, hit: &Hit) -> f64 {
        self.form.surface().error(ray, hit)
    }

    fn exact_distance(&self, ray: &Ray) -> Option<Distance> {
        self.form.surface().exact_distance(ray)
    }

    fn exact_geometry(&self) -> Option<ExactGeometry> {
        self.form.surface().exact_geometry()
    }

    fn borders(&self) -> Vec<Line> {
        self.form.surface().borders()
    }

    fn slack(&self) -> f64 {
        self.form.surface().slack()
    }

    fn weld(&mut self, plane: &Flat, borders: &[Option<Line>]) {
        self.form.surface_mut().weld(plane, borders);
    }
}
