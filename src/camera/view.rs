//! The camera of a scene, before the size of the picture is known.

use glam::{DVec2, DVec3};

use super::Camera;
use crate::language::{
    Attribute, Default, Naming, Node, Range, Schema, Takes, Value, ValueError, words,
};
use crate::math::{Flat, unit};

/// The `camera` of a scene.
#[derive(Debug, Clone, PartialEq)]
pub enum View {
    /// The chapter's camera: a window in a plane across the z axis.
    ///
    /// The centres of edge pixels lie on the window's edges. Hits in front of the window do not
    /// count.
    Screen {
        /// The viewpoint, with a z above the window's.
        viewpoint: DVec3,
        /// The window's width and height in world units.
        size: DVec2,
        /// The point of the window that lies at `at`.
        origin: WindowOrigin,
        /// The position of that point; the world's origin in the chapter.
        at: DVec3,
    },
    /// A camera that looks at a point.
    ///
    /// Pixel centres lie half a pixel inside the window.
    LookAt {
        /// The viewpoint.
        viewpoint: DVec3,
        /// The point in the middle of the picture.
        target: DVec3,
        /// The upward direction; not parallel to the direction of view.
        up: DVec3,
        /// The vertical angle of view in degrees.
        field_of_view: f64,
    },
}

/// The reference point of the chapter's window.
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
        about: "The viewpoint, with either `screen` or `look-at`.",
        naming: Naming::None,
        value: None,
        properties: &[],
        attributes: &[&[
            Attribute::new("viewpoint", Takes::Triple, "position of the eye").unit("world units"),
            Attribute::new(
                "screen",
                Takes::Pair(Range::Positive),
                "width and height of the chapter's window, in the plane z = 0 unless moved",
            )
            .unit("world units")
            .optional()
            .with(&[Attribute::new(
                "origin",
                Takes::Word(&WindowOrigin::WORDS),
                "the window's point at `screen-at`: its lower-left corner or centre",
            )
            .or(Default::Word(WindowOrigin::Corner.word()))]),
            Attribute::new(
                "screen-at",
                Takes::Triple,
                "position of the window's `origin`; the screen lies in the plane z = Z, and hits \
                 on the viewer's side of it are misses",
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
                "upward direction of the picture, with `look-at`",
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

    /// The view of a `camera` node.
    ///
    /// # Errors
    /// Returns an error if the node has both or neither of `screen` and `look-at`, an attribute of
    /// the other, or values without a camera.
    pub fn from_node(node: &Node) -> Result<Self, ValueError> {
        let viewpoint = node.triple("viewpoint");
        let view = match (node.entry("screen"), node.entry("look-at")) {
            (Some(screen), None) => {
                let advice = "remove it, or aim the camera with `look-at` instead of `screen`";
                check_absent(node, &["up", "field-of-view"], "look-at", advice)?;
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
                check_absent(node, &["screen-at"], "screen", advice)?;
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

    /// The position of the eye in world units.
    #[must_use]
    pub fn viewpoint(&self) -> DVec3 {
        match self {
            Self::Screen { viewpoint, .. } | Self::LookAt { viewpoint, .. } => *viewpoint,
        }
    }

    /// The camera for a picture of a width and a height in pixels.
    ///
    /// # Errors
    /// Returns an error if the viewpoint is not in front of the screen or is the target, or if `up`
    /// is parallel to the view.
    pub fn camera(&self, width: u32, height: u32) -> Result<Camera, ValueError> {
        let [width, height] = [width, height].map(f64::from);
        match *self {
            Self::Screen {
                viewpoint,
                size,
                origin,
                at,
            } => {
                if viewpoint.z <= at.z {
                    let z = Value::Number(at.z);
                    return Err(ValueError::new(
                        "viewpoint",
                        "the viewpoint is not in front of the screen",
                        format!(
                            "the screen lies in the plane z = {z}; give the viewpoint a z above {z}"
                        ),
                    )
                    .expected(format!("expected a z above {z}")));
                }
                let to_corner = match origin {
                    WindowOrigin::Corner => DVec3::ZERO,
                    WindowOrigin::Center => -0.5 * size.extend(0.0),
                };
                Ok(Camera {
                    viewpoint,
                    // The difference of scene points comes first: it does not depend on the origin.
                    lower_left: (at - viewpoint) + to_corner,
                    right: DVec3::X * size.x,
                    up: DVec3::Y * size.y,
                    inset: 0.0,
                    // A picture one pixel wide shows the window's left edge.
                    pixels: [(width - 1.0).max(1.0), (height - 1.0).max(1.0)],
                    screen: Some(Flat::with_unit_normal(at, DVec3::Z)),
                })
            }
            Self::LookAt {
                viewpoint,
                target,
                up,
                field_of_view,
            } => {
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
                        "`up` is zero or parallel to the direction of view",
                        "`up` is the upward direction of the picture, such as 0 1 0",
                    )
                    .expected("expected a direction across the view")
                })?;
                let half_height = libm::tan(field_of_view.to_radians() / 2.0);
                let right = across * (2.0 * half_height * (width / height));
                let up = across.cross(ahead) * (2.0 * half_height);
                Ok(Camera {
                    viewpoint,
                    lower_left: ahead - right * 0.5 - up * 0.5,
                    right,
                    up,
                    inset: 0.5,
                    pixels: [width, height],
                    screen: None,
                })
            }
        }
    }

    /// The world size of a pixel of the chapter's screen, if the camera has one.
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
        let node = Node::new(&Self::SCHEMA, None).with("viewpoint", self.viewpoint());
        match self {
            Self::Screen {
                size, origin, at, ..
            } => {
                let origin = [("origin", origin.word().into())];
                node.with_entry("screen", Some((*size).into()), &origin)
                    .with("screen-at", *at)
            }
            Self::LookAt {
                target,
                up,
                field_of_view,
                ..
            } => node
                .with("look-at", *target)
                .with("up", *up)
                .with("field-of-view", *field_of_view),
        }
    }
}

/// Checks that a camera without `owner` has no attributes that need it.
fn check_absent(
    node: &Node,
    words: &[&'static str],
    owner: &str,
    advice: &str,
) -> Result<(), ValueError> {
    let mut words = words.iter();
    let Some(word) = words.find(|word| node.entry(word).is_some()) else {
        return Ok(());
    };
    let reason = format!("`{word}` has no effect without `{owner}`");
    let expected = format!("expected only with `{owner}`");
    Err(ValueError::new(word, reason, advice).expected(expected))
}
