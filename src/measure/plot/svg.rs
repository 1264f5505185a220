//! Writer of SVG elements.

use std::fmt::{Display, Write};

use super::STYLE;

/// A place in a drawing: to the right and down.
pub(super) type Place = [f64; 2];

/// A drawing that grows element by element; colours come from classes.
#[derive(Debug, Default)]
pub(super) struct Svg {
    body: String,
}

impl Svg {
    /// Starts a file of its own.
    pub(super) fn paper(size: Place) -> Self {
        let mut svg = Self::default();
        svg.rectangle("paper", [0.0, 0.0], size);
        svg
    }

    pub(super) fn line(&mut self, class: &str, [x1, y1]: Place, [x2, y2]: Place) {
        self.add(format_args!(
            r#"<line class="{class}" x1="{x1:.1}" y1="{y1:.1}" x2="{x2:.1}" y2="{y2:.1}"/>"#
        ));
    }

    pub(super) fn polyline(&mut self, class: &str, places: &[Place]) {
        let points = places.iter().map(|[x, y]| format!("{x:.1},{y:.1}"));
        let points = points.collect::<Vec<_>>().join(" ");
        self.add(format_args!(
            r#"<polyline class="{class}" points="{points}"/>"#
        ));
    }

    pub(super) fn rectangle(&mut self, class: &str, [x, y]: Place, [width, height]: Place) {
        self.add(format_args!(
            r#"<rect class="{class}" x="{x:.1}" y="{y:.1}" width="{width:.1}" height="{height:.1}"/>"#
        ));
    }

    /// Adds a text of which the end that `anchor` names is at a place.
    pub(super) fn text(&mut self, class: &str, anchor: &str, [x, y]: Place, text: &str) {
        let text = escaped(text);
        self.add(format_args!(
            r#"<text class="{class}" text-anchor="{anchor}" x="{x:.1}" y="{y:.1}">{text}</text>"#
        ));
    }

    pub(super) fn circle(&mut self, class: &str, [x, y]: Place, radius: f64) {
        self.add(format_args!(
            r#"<circle class="{class}" cx="{x:.1}" cy="{y:.1}" r="{radius}"/>"#
        ));
    }

    /// Adds a dot with a number for scripts, and with a tooltip.
    pub(super) fn dot(&mut self, class: &str, number: usize, [x, y]: Place, tooltip: &str) {
        let tooltip = escaped(tooltip);
        self.add(format_args!(
            "<g class=\"step\" data-step=\"{number}\"><title>{tooltip}</title>\
             <circle class=\"aim\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"14\"/>\
             <circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"5.5\"/></g>"
        ));
    }

    /// The drawing as an element of a page that has the style sheet.
    pub(super) fn element(&self, class: &str, [width, height]: Place) -> String {
        let body = &self.body;
        format!(
            "<svg class=\"plot {class}\" viewBox=\"0 0 {width} {height}\" role=\"img\">\n{body}</svg>\n"
        )
    }

    /// The drawing as a file.
    pub(super) fn file(&self, [width, height]: Place) -> String {
        let body = &self.body;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" width=\"{width}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\"><style>{STYLE}</style>\n{body}</svg>\n"
        )
    }

    fn add(&mut self, element: impl Display) {
        // Writing to a String cannot fail.
        let _ = writeln!(self.body, "{element}");
    }
}

/// A text with the characters of markup replaced.
pub(in crate::measure) fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('>', "&gt;").replace('"', "&quot;")
}
