//! The camera as a scene gives it, before the picture's size is known.

use glam::{DVec2, DVec3};

use super::Camera;
use crate::language::{Attribute, Default, Naming, Node, Range, Refusal, Schema, Takes};
use crate::math::unit;

/// A viewpoint and what it looks at.
#[derive(Debug, Clone, PartialEq)]
pub enum View {
    /// The chapter's camera: a window in the plane z = 0.
    ///
    /// Edge pixels lie exactly on the window's edges, and hits with z > 0 are misses.
    Screen {
        /// Where the eye is; z > 0.
        viewpoint: DVec3,
        /// The window's width and height in world units.
        size: DVec2,
        /// Where the window lies.
        origin: WindowOrigin,
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

/// The point of the chapter's window that lies at the world's origin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WindowOrigin {
    /// The lower-left corner.
    Corner,
    /// The middle.
    Center,
}

impl WindowOrigin {
    const WORDS: [&'static str; 2] = ["corner", "center"];

    fn word(self) -> &'static str {
        match self {
            Self::Corner => Self::WORDS[0],
            Self::Center => Self::WORDS[1],
        }
    }
}

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
                "width and height of the chapter's window in the plane z = 0",
            )
            .unit("world units")
            .optional()
            .with(&[Attribute {
                word: "origin",
                takes: Takes::Word(&WindowOrigin::WORDS),
                unit: "",
                default: Default::Word("corner"),
                properties: &[],
                about: "the window's point at the world's origin: its lower-left corner or centre",
            }]),
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
    /// Refuses a camera with both or neither of `screen` and `look-at`, and impossible directions.
    pub fn from_node(node: &Node) -> Result<Self, Refusal> {
        let viewpoint = node.triple("viewpoint");
        let view = match (node.entry("screen"), node.entry("look-at")) {
            (Some(screen), None) => {
                if let Some(stray) = ["up", "field-of-view"]
                    .into_iter()
                    .find(|word| node.entry(word).is_some())
                {
                    return Err(Refusal::new(
                        stray,
                        format!("`{stray}` means nothing to a camera with `screen`"),
                        "remove it, or aim the camera with `look-at` instead of `screen`",
                    )
                    .expected("expected only with `look-at`"));
                }
                let centered = screen
                    .property("origin")
                    .is_some_and(|at| at.text() == "center");
                let origin = if centered {
                    WindowOrigin::Center
                } else {
                    WindowOrigin::Corner
                };
                Self::Screen {
                    viewpoint,
                    size: node.pair("screen"),
                    origin,
                }
            }
            (None, Some(_)) => Self::LookAt {
                viewpoint,
                target: node.triple("look-at"),
                up: node.triple("up"),
                field_of_view: node.number("field-of-view"),
            },
            (None, None) => {
                return Err(Refusal::new(
                    "camera",
                    "the camera has neither `screen` nor `look-at`",
                    "give `screen WIDTH HEIGHT` for the chapter's window, or `look-at X Y Z`",
                )
                .expected("expected one of them between its braces"));
            }
            (Some(_), Some(_)) => {
                return Err(Refusal::new(
                    "look-at",
                    "the camera has both `screen` and `look-at`",
                    "keep one of them",
                )
                .expected("expected only one of the two"));
            }
        };
        view.camera(1, 1).map(|_| view)
    }

    /// The camera for a picture of this size.
    ///
    /// # Errors
    /// Refuses an eye behind the screen or at its target, and an `up` along the view.
    pub fn camera(&self, width: u32, height: u32) -> Result<Camera, Refusal> {
        let (width, height) = (f64::from(width), f64::from(height));
        match *self {
            Self::Screen {
                viewpoint,
                size,
                origin,
            } => {
                if viewpoint.z <= 0.0 {
                    return Err(Refusal::new(
                        "viewpoint",
                        "the viewpoint is not in front of the screen",
                        "the screen lies in the plane z = 0; give the viewpoint a z above 0",
                    )
                    .expected("expected a z above 0"));
                }
                let corner = match origin {
                    WindowOrigin::Corner => DVec3::ZERO,
                    WindowOrigin::Center => -0.5 * size.extend(0.0),
                };
                Ok(Camera {
                    viewpoint,
                    lower_left: corner - viewpoint,
                    right: DVec3::X * size.x,
                    up: DVec3::Y * size.y,
                    inset: 0.0,
                    // A picture one pixel wide looks along the window's left edge.
                    span: [(width - 1.0).max(1.0), (height - 1.0).max(1.0)],
                    screen: true,
                })
            }
            Self::LookAt {
                viewpoint,
                target,
                up,
                field_of_view,
            } => {
                let ahead = unit(target - viewpoint).ok_or_else(|| {
                    Refusal::new(
                        "look-at",
                        "the camera looks at its own viewpoint",
                        "give `look-at` another point",
                    )
                    .expected("expected another point than `viewpoint`")
                })?;
                let across = unit(up)
                    .and_then(|up| unit(ahead.cross(up)))
                    .ok_or_else(|| {
                        Refusal::new(
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
                    screen: false,
                })
            }
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
            } => node.with("viewpoint", *viewpoint).with_entry(
                "screen",
                Some((*size).into()),
                &[("origin", origin.word().into())],
            ),
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
