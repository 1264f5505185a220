//! What ties a surface to a place, a size or an axis of the world, so that its picture may change.

use super::moved::moved;
use super::scaled::scaled;
use super::subject::{Subject, difference};
use super::turned::{Axis, turned};

/// A change that leaves pictures alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Relation {
    /// By a power of two.
    Scaled,
    /// Along the axes.
    Moved,
    /// By half a turn about an axis.
    Turned,
}

/// A setting that is an exception from some of them.
#[derive(Debug)]
pub(super) struct Exception {
    /// The kind of node.
    node: &'static str,
    /// The attribute that makes the exception.
    attribute: &'static str,
    /// Its value, or a property on its line; any if `None`.
    value: Option<&'static str>,
    /// What it is an exception from.
    from: &'static [Relation],
    /// Why.
    reason: &'static str,
    /// A surface that shows it, with the materials `red` and `blue`.
    example: &'static str,
}

pub(super) const EXCEPTIONS: [Exception; 6] = [
    Exception {
        node: "procedural-plane",
        attribute: "shader",
        value: Some("stripes"),
        from: &[Relation::Scaled, Relation::Turned],
        reason: "the formula takes absolute offsets along the world's x and y: x y (y + 1) / 100",
        example: r#"procedural-plane {
            material "red"; point -9 -40 -5; normal 0 0 1; shader "stripes" }"#,
    },
    Exception {
        node: "procedural-plane",
        attribute: "shader",
        value: Some("color-wheel"),
        from: &[Relation::Turned],
        reason: "the formula takes the angle between an offset and the world's x",
        example: r#"procedural-plane {
            material "red"; point 1 0 -5; normal 1 2 3; shader "color-wheel" }"#,
    },
    Exception {
        node: "tiled-plane",
        attribute: "start",
        value: Some("course"),
        from: &[Relation::Scaled, Relation::Moved],
        reason: "the tiles are counted from the world's origin, after 100,000 has been added",
        example: r#"tiled-plane {
            material "red"; alternate "blue"; point 0 0 -5; normal 0 0 1; xdir 1 0 0
            dimensions 0.7 0.7; start "course" }"#,
    },
    Exception {
        node: "texture-plane",
        attribute: "texture",
        value: Some("texel"),
        from: &[Relation::Scaled],
        reason: "texels of a given size end at multiples of its decimal, such as 0.3 for three of \
                 0.1, which is not what a scaled double says; rays aimed at such a line notice",
        example: r#"image 3 1
            camera { viewpoint 0.5 0.0625 1; look-at 0.5 0.0625 0 }
            texture-plane {
                material "red"; point 0 0 0; normal 0 0 1; xdir 1 0 0; dimensions 2 2
                texture "arrow" mode="repeat" texel=0.1 }"#,
    },
    Exception {
        node: "sphere",
        attribute: "texture",
        value: None,
        from: &[Relation::Turned],
        reason: "the middle of the image faces the world's +z and its top is at +y",
        example: r#"sphere { material "red"; center 0 0 -3; radius 2; texture "arrow" }"#,
    },
    Exception {
        node: "ellipsoid",
        attribute: "texture",
        value: None,
        from: &[Relation::Turned],
        reason: "the middle of the image faces the world's +z and its top is at +y",
        example: r#"ellipsoid {
            material "red"; center 0 0 -3; radius 2; scale 1 2 1; texture "arrow" }"#,
    },
];

impl Exception {
    /// Whether the exception applies to something in a scene.
    pub(super) fn breaks(&self, relation: Relation, subject: &Subject) -> bool {
        self.from.contains(&relation) && subject.says(self.node, self.attribute, self.value)
    }
}

/// Every exception is one: its example's picture does change, and only by what it is excepted from.
#[test]
fn every_exception_is_needed() {
    for exception in &EXCEPTIONS {
        let header = if exception.example.starts_with("image") {
            ""
        } else {
            "image 32 24; camera { viewpoint 0 0 6; look-at 0 0 -5; field-of-view 60 }"
        };
        let text = format!(
            r#"{header}
            texture "arrow" "../textures/arrow-8x8.png"
            material "red" {{ ambient 5 1 1 }}
            material "blue" {{ ambient 1 1 5 }}
            {}"#,
            exception.example
        );
        let name = format!("{} {:?}", exception.node, exception.value);
        let subject = Subject::new(&name, &text);
        let expected = subject.film();
        for (relation, other) in [
            (
                Relation::Scaled,
                (-50..50).map(|k| scaled(&subject, k)).collect(),
            ),
            (Relation::Moved, vec![moved(&subject, [8.0, 5.0, 3.0])]),
            (
                Relation::Turned,
                Axis::ALL.map(|axis| turned(&subject, axis)).to_vec(),
            ),
        ] {
            let excepted = exception.breaks(relation, &subject);
            let mut others = other.iter();
            let changes = others.find_map(|other| difference(&name, &expected, &other.film()));
            assert_eq!(
                changes.is_some(),
                excepted,
                "{relation:?}: {changes:?}; the reason given: {}",
                exception.reason
            );
        }
    }
}
