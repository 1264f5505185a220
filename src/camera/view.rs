//! The camera as a scene gives it, before the picture's size is known.

use glam::{DVec2, DVec3};

use super::Camera;
use crate::language::{
    Attribute, Default, Naming, Node, Range, Schema, Takes, Value, ValueError, words,
};
use crate::math::{Flat, unit};

/// A viewpoint and what it looks at.
#[derive(Debug, Clone, PartialEq)]
pub enum View {
    /// The chapter's camera: a window in a plane across the z axis.
    ///
    /// Edge pixels lie exactly on the window's edges, and hits on the viewer's side are misses.
    Screen {
        /// Where the eye is; its z is above the window's.
        viewpoint: DVec3,
        /// The window's width and height in world units.
        size: DVec2,
        /// The point of the window that stands at `at`.
        origin: WindowOrigin,
        /// Where that point stands; in the chapter at the world's origin.
        at: DVec3,
    },
    /// A camera that is aimed. Pixel centres lie half a pixel inside the window.
    LookAt {
        /// Where the eye is.
        viewpoint: DVec3,
        /// The point in the middle of the picture.
        target: DVec3,
        /// What is up in the picture; any direction but the one of view.
        up: DVec3,
        /// The vertical angle of view in degrees.
        field_of_view: f64,
    },
}

/// The point of the chapter's window that its place is told by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum WindowOrigin {
    /// The lower-left corner.
    #[default]
    Corner,
    /// The middle.
    Center,
}

words!(WindowOrigin {
    Corner: "corner",
    Center: "center",
});

impl View {
    /// The `camera` node of the scene language.
    pub const SCHEMA: Schema = Schema {
        word: "camera",
        about: "Where the picture is taken from; with either `screen` or `look-at`.",
        naming: Naming::None,
        value: None,
        properties: &[],
        attributes: &[&[
            Attribute::new("viewpoint", Takes::Triple, "where the eye is").unit("world units"),
            Attribute::new(
                "screen",
                Takes::Pair(Range::Positive),
                "width and height of the chapter's window, in the plane z = 0 if not moved",
            )
            .unit("world units")
            .optional()
            .with(&[Attribute {
                word: "origin",
                takes: Takes::Word(&WindowOrigin::WORDS),
                unit: "",
                default: Default::Word(WindowOrigin::Corner.word()),
                properties: &[],
                about: "the window's point at `screen-at`: its lower-left corner or centre",
            }]),
            Attribute::new(
                "screen-at",
                Takes::Triple,
                "where the point of the window stands that `origin` names; the screen then lies in \
                 the plane z = Z and hits on the viewer's side of it are misses",
            )
            .unit("world units")
            .or(Default::Triple([0.0; 3])),
            Attribute::new(
                "look-at",
                Takes::Triple,
                "the point in the middle of the picture",
            )
            .unit("world units")
            .optional(),
            Attribute::new(
                "up",
                Takes::Triple,
                "what is up in the picture, with `look-at`",
            )
            .or(Default::Triple([0.0, 1.0, 0.0])),
            Attribute::new(
                "field-of-view",
                Takes::Number(Range::Inside(0.0, 180.0)),
                "vertical angle of view, with `look-at`",
            )
            .unit("degrees")
            .or(Default::Number(45.0)),
        ]],
    };

    /// The view that a `camera` node gives.
    ///
    /// # Errors
    /// Refuses a camera with both or neither of `screen` and `look-at`, what belongs to the other
    /// of them, and impossible directions.
    pub fn from_node(node: &Node) -> Result<Self, ValueError> {
        let viewpoint = node.triple("viewpoint");
        let view = match (node.entry("screen"), node.entry("look-at")) {
            (Some(screen), None) => {
                let advice = "remove it, or aim the camera with `look-at` instead of `screen`";
                refuse_stray(
                    node,
                    &["up", "field-of-view"],
                    ["screen", "look-at"],
                    advice,
                )?;
                let origin = screen.property("origin");
                Self::Screen {
                    viewpoint,
                    size: node.pair("screen"),
                    origin: origin
                        .and_then(|origin| WindowOrigin::from_word(origin.text()))
                        .unwrap_or_default(),
                    at: node.triple("screen-at"),
                }
            }
            (None, Some(_)) => {
                let advice = "remove it, or give `screen` instead of `look-at`";
                refuse_stray(node, &["screen-at"], ["look-at", "screen"], advice)?;
                Self::LookAt {
                    viewpoint,
                    target: node.triple("look-at"),
                    up: node.triple("up"),
                    field_of_view: node.number("field-of-view"),
                }
            }
            (None, None) => {
                return Err(ValueError::new(
                    "camera",
                    "the camera has neither `screen` nor `look-at`",
                    "give `screen WIDTH HEIGHT` for the chapter's window, or `look-at X Y Z`",
                )
                .expected("expected one of them between its braces"));
            }
            (Some(_), Some(_)) => {
                return Err(ValueError::new(
                    "look-at",
                    "the camera has both `screen` and `look-at`",
                    "keep one of them",
                )
                .expected("expected only one of the two"));
            }
        };
        view.camera(1, 1).map(|_| view)
    }

    /// Where the eye is.
    #[must_use]
    pub fn viewpoint(&self) -> DVec3 {
        match self {
            Self::Screen { viewpoint, .. } | Self::LookAt { viewpoint, .. } => *viewpoint,
        }
    }

    /// The camera for a picture of this size.
    ///
    /// # Errors
    /// Refuses an eye behind the screen or at its target, and an `up` along the view.
    pub fn camera(&self, width: u32, height: u32) -> Result<Camera, ValueError> {
        let pixels = [width, height].map(f64::from);
        match *self {
            Self::Screen {
                viewpoint,
                size,
                origin,
                at,
            } => {
                let corner = match origin {
                    WindowOrigin::Corner => DVec3::ZERO,
                    WindowOrigin::Center => -0.5 * size.extend(0.0),
                };
                through_screen(viewpoint, [at, corner], size, pixels)
            }
            Self::LookAt {
                viewpoint,
                target,
                up,
                field_of_view,
            } => looking_at(viewpoint, [target, up], field_of_view, pixels),
        }
    }

    /// The world size of one pixel of the chapter's screen: its size divided by the pixels.
    ///
    /// `None` for a camera without a screen.
    #[must_use]
    pub fn pixel_size(&self, width: u32, height: u32) -> Option<DVec2> {
        match self {
            Self::Screen { size, .. } => {
                Some(*size / DVec2::new(f64::from(width), f64::from(height)))
            }
            Self::LookAt { .. } => None,
        }
    }

    /// The view as a node of the scene language.
    #[must_use]
    pub fn describe(&self) -> Node {
        let node = Node::new(&Self::SCHEMA, None);
        match self {
            Self::Screen {
                viewpoint,
                size,
                origin,
                at,
            } => node
                .with("viewpoint", *viewpoint)
                .with_entry(
                    "screen",
                    Some((*size).into()),
                    &[("origin", origin.word().into())],
                )
                .with("screen-at", *at),
            Self::LookAt {
                viewpoint,
                target,
                up,
                field_of_view,
            } => node
                .with("viewpoint", *viewpoint)
                .with("look-at", *target)
                .with("up", *up)
                .with("field-of-view", *field_of_view),
        }
    }
}

/// The camera behind a window of this size, whose lower-left corner is at a point of the scene and a
/// way from there.
fn through_screen(
    viewpoint: DVec3,
    [at, to_corner]: [DVec3; 2],
    size: DVec2,
    [width, height]: [f64; 2],
) -> Result<Camera, ValueError> {
    if viewpoint.z <= at.z {
        let z = Value::Number(at.z);
        return Err(ValueError::new(
            "viewpoint",
            "the viewpoint is not in front of the screen",
            format!("the screen lies in the plane z = {z}; give the viewpoint a z above {z}"),
        )
        .expected(format!("expected a z above {z}")));
    }
    Ok(Camera {
        viewpoint,
        // Scene points are subtracted first, so that only their distance counts.
        lower_left: (at - viewpoint) + to_corner,
        right: DVec3::X * size.x,
        up: DVec3::Y * size.y,
        inset: 0.0,
        // A picture one pixel wide looks along the window's left edge.
        span: [(width - 1.0).max(1.0), (height - 1.0).max(1.0)],
        screen: Some(Flat::with_unit_normal(at, DVec3::Z)),
    })
}

/// The camera that looks at a point, with a vertical angle of view in degrees.
fn looking_at(
    viewpoint: DVec3,
    [target, up]: [DVec3; 2],
    field_of_view: f64,
    [width, height]: [f64; 2],
) -> Result<Camera, ValueError> {
    let ahead = unit(target - viewpoint).ok_or_else(|| {
        ValueError::new(
            "look-at",
            "the camera looks at its own viewpoint",
            "give `look-at` another point",
        )
        .expected("expected another point than `viewpoint`")
    })?;
    let across = unit(up).and_then(|up| unit(ahead.cross(up)));
    let across = across.ok_or_else(|| {
        ValueError::new(
            "up",
            "`up` is zero or points along the direction of view",
            "`up` is what is up in the picture, such as 0 1 0",
        )
        .expected("expected a direction across the view")
    })?;
    let half_height = libm::tan(field_of_view.to_radians() / 2.0);
    let right = across * (2.0 * half_height * (width / height));
    let upward = across.cross(ahead) * (2.0 * half_height);
    Ok(Camera {
        viewpoint,
        lower_left: ahead - right * 0.5 - upward * 0.5,
        right,
        up: upward,
        inset: 0.5,
        span: [width, height],
        screen: None,
    })
}

/// Refuses attributes that mean nothing to a camera with `has`, only to one with `other`.
fn refuse_stray(
    node: &Node,
    words: &[&'static str],
    [has, other]: [&str; 2],
    advice: &str,
) -> Result<(), ValueError> {
    let mut words = words.iter();
    let Some(stray) = words.find(|word| node.entry(word).is_some()) else {
        return Ok(());
    };
    let reason = format!("`{stray}` means nothing to a camera with `{has}`");
    let expected = format!("expected only with `{other}`");
    Err(ValueError::new(stray, reason, advice).expected(expected))
}
