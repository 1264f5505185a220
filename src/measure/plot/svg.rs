//! A small writer of SVG.

use std::fmt::{Display, Write};

/// A drawing that grows element by element. Colours come from classes, so that one drawing suits
/// light and dark pages.
#[derive(Debug, Clone, Default)]
pub(in crate::measure) struct Svg {
    body: String,
}

impl Svg {
    /// Adds a line between two places.
    pub(in crate::measure) fn line(&mut self, class: &str, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) {
        self.add(format_args!(
            r#"<line class="{class}" x1="{x1:.1}" y1="{y1:.1}" x2="{x2:.1}" y2="{y2:.1}"/>"#
        ));
    }

    /// Adds a line through several places.
    pub(in crate::measure) fn path(&mut self, class: &str, places: &[[f64; 2]]) {
        let points: Vec<_> = places
            .iter()
            .map(|[x, y]| format!("{x:.1},{y:.1}"))
            .collect();
        self.add(format_args!(
            r#"<polyline class="{class}" points="{}"/>"#,
            points.join(" ")
        ));
    }

    /// Adds a rectangle.
    pub(in crate::measure) fn rectangle(
        &mut self,
        class: &str,
        [x, y]: [f64; 2],
        [width, height]: [f64; 2],
    ) {
        self.add(format_args!(
            r#"<rect class="{class}" x="{x:.1}" y="{y:.1}" width="{width:.1}" height="{height:.1}"/>"#
        ));
    }

    /// Adds a text; `anchor` says which end of it is at the place.
    pub(in crate::measure) fn text(
        &mut self,
        class: &str,
        anchor: &str,
        [x, y]: [f64; 2],
        text: &str,
    ) {
        let text = escaped(text);
        self.add(format_args!(
            r#"<text class="{class}" text-anchor="{anchor}" x="{x:.1}" y="{y:.1}">{text}</text>"#
        ));
    }

    /// Adds a dot with a number, which tells its story to who points at it.
    pub(in crate::measure) fn dot(
        &mut self,
        class: &str,
        number: usize,
        [x, y]: [f64; 2],
        story: &str,
    ) {
        let story = escaped(story);
        self.add(format_args!(
            "<g class=\"rung\" data-rung=\"{number}\"><title>{story}</title>\
             <circle class=\"aim\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"14\"/>\
             <circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"5.5\"/></g>"
        ));
    }

    /// Adds a plain circle.
    pub(in crate::measure) fn circle(&mut self, class: &str, [x, y]: [f64; 2], radius: f64) {
        self.add(format_args!(
            r#"<circle class="{class}" cx="{x:.1}" cy="{y:.1}" r="{radius}"/>"#
        ));
    }

    /// The drawing as an element of a page that has the style.
    pub(in crate::measure) fn element(&self, class: &str, [width, height]: [f64; 2]) -> String {
        let body = &self.body;
        format!(
            "<svg class=\"plot {class}\" viewBox=\"0 0 {width} {height}\" role=\"img\">\n{body}</svg>\n"
        )
    }

    /// The drawing as a file of its own.
    pub(in crate::measure) fn file(&self, [width, height]: [f64; 2], style: &str) -> String {
        let body = &self.body;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" width=\"{width}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\"><style>{style}</style>\n{body}</svg>\n"
        )
    }

    fn add(&mut self, element: impl Display) {
        // Writing to a String cannot fail.
        let _ = writeln!(self.body, "{element}");
    }
}

/// A text with what markup is made of replaced.
pub(in crate::measure) fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            other => escaped.push(other),
        }
    }
    escaped
}
