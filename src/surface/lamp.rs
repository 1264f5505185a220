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

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::{Anatomy, Common, FinitePlane, Hit, Sphere, Surface};
use crate::language::{Attribute, Default, Naming, Node, Range, Refusal, Schema, Takes};
use crate::math::exact::{Distance, ExactVector, Sign};
use crate::math::{
    Blueprint, Bounds, Flat, Frame, Line, Point, Ray, Rgb, Segment, Side, Span, direction,
    form_factor,
};

/// A rectangle or a ball that shines, and is seen to.
#[derive(Debug, Clone)]
pub struct Lamp {
    form: Form,
    emissivity: Rgb,
    samples: u32,
}

/// The forms that a lamp can have.
#[derive(Debug, Clone)]
enum Form {
    /// It shines on its front only; its back is black.
    Pane(Box<FinitePlane>),
    /// It shines outward.
    Globe(Sphere),
}

impl Lamp {
    /// The most places of a lamp that are asked for its shadow; more the sequence does not have.
    const MOST_SAMPLES: u32 = 65_536;

    const PANE: [&'static str; 4] = ["point", "normal", "xdir", "dimensions"];
    const GLOBE: [&'static str; 2] = ["center", "radius"];
    const PANE_HAS: &'static str = "a rectangle has `point`, `normal`, `xdir` and `dimensions`";
    const GLOBE_HAS: &'static str = "a ball has `center` and `radius`";

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
    /// what [`FinitePlane::new`] and [`Sphere::new`] refuse.
    pub fn from_node(node: &Node, common: Common) -> Result<Self, Refusal> {
        let form = if is_pane(node)? {
            let [point, normal, xdir] = ["point", "normal", "xdir"].map(|word| node.triple(word));
            let size = node.pair("dimensions");
            let pane = FinitePlane::new(common, point, normal, xdir, size)?;
            Form::Pane(Box::new(pane))
        } else {
            let (center, radius) = (node.triple("center"), node.number("radius"));
            Form::Globe(Sphere::new(common, center, radius, None)?)
        };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "the schema allows small whole numbers only"
        )]
        let samples = node.number("samples") as u32;
        Ok(Self {
            form,
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

    /// How much light arrives at a place with this unit normal if nothing stands in the way, as a
    /// share of what a sky as bright would give: from 0 to 1.
    #[must_use]
    pub fn form_factor(&self, place: &Point, normal: DVec3) -> f64 {
        // 2¹⁷. Beyond as many times its own size, a lamp is taken for a speck of light, which is off
        // by one in 2¹⁷ of what a lamp there can give at most; nearer, the sums of angles are off by
        // one in 2³⁶, since that is what is left of them when they cancel.
        const FAR: f64 = 131_072.0;
        if self.side(place) != Side::Front {
            return 0.0;
        }
        let center = self.center().way_from(place);
        let is_far = center.length() > FAR * self.reach();
        match &self.form {
            Form::Pane(pane) => {
                let rectangle = pane.rectangle();
                if is_far {
                    let slant = -rectangle.flat.normal.dot(direction(center));
                    let area = rectangle.size.x * rectangle.size.y;
                    return form_factor::of_speck(center, area * slant.max(0.0), normal);
                }
                let corners = Self::CORNERS.map(|corner| self.on_pane(pane, corner));
                form_factor::of_polygon(&corners.map(|corner| corner.way_from(place)), normal)
            }
            Form::Globe(_) if is_far => {
                form_factor::of_speck(center, PI * self.reach() * self.reach(), normal)
            }
            Form::Globe(_) => form_factor::of_ball(center, self.reach(), normal),
        }
    }

    const CORNERS: [DVec2; 4] = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];

    fn on_pane(&self, pane: &FinitePlane, at: DVec2) -> Point {
        let rectangle = pane.rectangle();
        rectangle.point(at * rectangle.size)
    }

    /// Its middle.
    #[must_use]
    pub fn center(&self) -> Point {
        match &self.form {
            Form::Pane(pane) => self.on_pane(pane, DVec2::splat(0.5)),
            Form::Globe(globe) => Point::exact(globe.center()),
        }
    }

    /// How far it reaches from its middle.
    #[must_use]
    pub fn reach(&self) -> f64 {
        match &self.form {
            Form::Pane(pane) => pane.rectangle().size.length() / 2.0,
            Form::Globe(globe) => globe.radius(),
        }
    }

    /// One of its points that a place in front of it sees, and what that point counts for, which is
    /// not negative; `at` chooses it, from 0 to 1 along two axes.
    ///
    /// The places of a rectangle are chosen evenly over its area, and those of a ball evenly over the
    /// disc that is seen of it from afar. Each counts for the light that the piece of lamp around it
    /// gives, so that the sum of what is seen by the sum of all is the share of the *light* that
    /// arrives.
    #[must_use]
    pub fn sample(&self, place: &Point, normal: DVec3, at: DVec2) -> (Point, f64) {
        let (point, front, stretch) = match &self.form {
            Form::Pane(pane) => (self.on_pane(pane, at), pane.rectangle().flat.normal, 1.0),
            Form::Globe(globe) => {
                let way = place.from(globe.center());
                let (distance, radius) = (way.length(), globe.radius());
                let axis = direction(way);
                let frame = Frame::any(axis);
                let seen = (distance - radius).max(0.0) * (distance + radius) / distance / distance;
                let (sine, cosine) = ((at.x * seen).sqrt(), (1.0 - at.x * seen).sqrt());
                let turn = 2.0 * PI * at.y;
                let across = frame.x * libm::cos(turn) + frame.y * libm::sin(turn);
                // So that a scene turned by half a turn about an axis is asked at the same places.
                let is_turned = axis.x < 0.0 || axis.x == 0.0 && axis.y * axis.z < 0.0;
                let across = if is_turned { -across } else { across };
                let front = axis * cosine + across * sine;
                let point = Point {
                    anchor: globe.center(),
                    offset: front * radius,
                };
                (point, front, cosine)
            }
        };
        let way = point.way_from(place);
        let distance = way.length();
        let dir = way / distance;
        let weight = normal.dot(dir).max(0.0) * (-front.dot(dir)).max(0.0);
        // A place on the lamp itself is not in front of it.
        let weight = weight / distance / distance / stretch;
        (point, if weight.is_finite() { weight } else { 0.0 })
    }

    /// The point of it that is highest along a direction.
    #[must_use]
    pub fn highest(&self, normal: DVec3) -> Point {
        match &self.form {
            Form::Pane(pane) => {
                let frame = pane.rectangle().frame;
                let end = |axis: DVec3| if axis.dot(normal) > 0.0 { 1.0 } else { 0.0 };
                self.on_pane(pane, DVec2::new(end(frame.x), end(frame.y)))
            }
            Form::Globe(globe) => Point {
                anchor: globe.center(),
                offset: normal * globe.radius(),
            },
        }
    }

    fn surface(&self) -> &dyn Surface {
        match &self.form {
            Form::Pane(pane) => &**pane,
            Form::Globe(globe) => globe,
        }
    }

    fn surface_mut(&mut self) -> &mut dyn Surface {
        match &mut self.form {
            Form::Pane(pane) => &mut **pane,
            Form::Globe(globe) => globe,
        }
    }
}

/// Whether a lamp is a rectangle and not a ball.
fn is_pane(node: &Node) -> Result<bool, Refusal> {
    let given = |words: &[&'static str]| {
        let mut words = words.iter();
        words.find(|word| node.entry(word).is_some()).copied()
    };
    let (words, they) = match (given(&Lamp::PANE), given(&Lamp::GLOBE)) {
        (Some(_), None) => (&Lamp::PANE[..], Lamp::PANE_HAS),
        (None, Some(_)) => (&Lamp::GLOBE[..], Lamp::GLOBE_HAS),
        (None, None) => {
            let advice = format!("{}, {}", Lamp::PANE_HAS, Lamp::GLOBE_HAS);
            return Err(Refusal::new("lamp", "the lamp has no shape", advice)
                .expected("expected a rectangle or a ball between its braces"));
        }
        (Some(pane), Some(globe)) => {
            let reason = format!("the lamp has both `{pane}` and `{globe}`");
            let advice = format!("{}, {}; keep one", Lamp::PANE_HAS, Lamp::GLOBE_HAS);
            return Err(Refusal::new(globe, reason, advice).expected("expected only one shape"));
        }
    };
    if let Some(lacks) = words.iter().find(|word| node.entry(word).is_none()) {
        let reason = format!("the lamp has no `{lacks}`");
        let expected = format!("expected `{lacks}` between its braces");
        return Err(Refusal::new(lacks, reason, they).expected(expected));
    }
    Ok(words.len() == Lamp::PANE.len())
}

impl Surface for Lamp {
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        self.surface().hits(ray, span)
    }

    fn common(&self) -> &Common {
        self.surface().common()
    }

    fn lamp(&self) -> Option<&Lamp> {
        Some(self)
    }

    fn describe(&self) -> Node {
        let node = Node::new(&Self::SCHEMA, None);
        let node = match &self.form {
            Form::Pane(pane) => pane.describe_into(node),
            Form::Globe(globe) => globe.describe_into(node),
        };
        node.with("emissivity", DVec3::from(self.emissivity))
            .with("samples", f64::from(self.samples))
    }

    fn flat(&self) -> Option<&Flat> {
        self.surface().flat()
    }

    fn round(&self) -> Option<[DVec3; 2]> {
        self.surface().round()
    }

    fn outline(&self) -> Vec<DVec3> {
        self.surface().outline()
    }

    fn hull(&self) -> Option<Vec<ExactVector>> {
        self.surface().hull()
    }

    fn bounds(&self) -> Option<Bounds> {
        self.surface().bounds()
    }

    fn side(&self, point: &Point) -> Side {
        self.surface().side(point)
    }

    fn anatomy(&self) -> Option<Anatomy<'_>> {
        self.surface().anatomy()
    }

    fn occludes(&self, segment: &Segment, end: Side) -> bool {
        self.surface().occludes(segment, end)
    }

    fn exact_distance(&self, ray: &Ray) -> Option<Distance> {
        self.surface().exact_distance(ray)
    }

    fn blueprint(&self) -> Option<Blueprint> {
        self.surface().blueprint()
    }

    fn borders(&self) -> Vec<Line> {
        self.surface().borders()
    }

    fn slack(&self) -> f64 {
        self.surface().slack()
    }

    fn weld(&mut self, plane: &Flat, borders: &[Option<Line>]) {
        self.surface_mut().weld(plane, borders);
    }
}
