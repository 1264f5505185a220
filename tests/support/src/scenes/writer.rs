//! The text of a scene, node by node.

use std::fmt::{Display, Write};

/// The text of a scene in the making.
///
/// The `attributes` of a surface are all that does not shape it: `material "chalk"` and whatever
/// else, with semicolons between.
#[derive(Debug, Clone, Default)]
pub struct Writer {
    text: String,
}

/// Three numbers as a scene has them; they are read again as the same numbers.
#[must_use]
pub fn triple([x, y, z]: [f64; 3]) -> String {
    format!("{x:?} {y:?} {z:?}")
}

impl Writer {
    /// A scene that starts with this text.
    #[must_use]
    pub fn new(head: &str) -> Self {
        Self {
            text: head.to_owned(),
        }
    }

    /// The text so far.
    #[must_use]
    pub fn text(self) -> String {
        self.text
    }

    /// Adds a line.
    pub fn line(&mut self, line: impl Display) {
        // Writing to a String cannot fail.
        let _ = writeln!(self.text, "{line}");
    }

    /// Adds a plane without borders.
    pub fn plane(&mut self, attributes: &str, point: impl Display, normal: impl Display) {
        self.line(format_args!(
            "plane {{ {attributes}; point {point}; normal {normal} }}"
        ));
    }

    /// Adds a node of a rectangle, such as `finite-plane` or `texture-plane`.
    pub fn rectangle(
        &mut self,
        word: &str,
        attributes: &str,
        point: impl Display,
        [normal, xdir]: [impl Display; 2],
        [width, height]: [f64; 2],
    ) {
        self.line(format_args!(
            "{word} {{ {attributes}; point {point}; normal {normal}; xdir {xdir}; \
             dimensions {width:?} {height:?} }}"
        ));
    }

    /// Adds a triangle.
    pub fn triangle(&mut self, attributes: &str, [a, b, c]: [impl Display; 3]) {
        self.line(format_args!(
            "triangle {{ {attributes}; vertex1 {a}; vertex2 {b}; vertex3 {c} }}"
        ));
    }

    /// Adds a sphere.
    pub fn sphere(&mut self, attributes: &str, center: impl Display, radius: f64) {
        self.line(format_args!(
            "sphere {{ {attributes}; center {center}; radius {radius:?} }}"
        ));
    }

    /// Adds an ellipsoid.
    pub fn ellipsoid(
        &mut self,
        attributes: &str,
        center: impl Display,
        radius: f64,
        scale: impl Display,
    ) {
        self.line(format_args!(
            "ellipsoid {{ {attributes}; center {center}; radius {radius:?}; scale {scale} }}"
        ));
    }
}
