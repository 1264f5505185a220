//! Curves in panels.

use super::axis::Axis;
use super::color_class;
use super::frame::{Frame, Write, number};
use super::labels::spread;
use super::svg::{Place, Svg};

/// Curves in panels side by side with one vertical axis.
#[derive(Debug, Clone)]
pub struct Figure {
    /// Panels from left to right; the labels of the last one stand for all.
    pub panels: Vec<Panel>,
    /// Vertical axis.
    pub up: Scale,
}

/// Title and number format of a logarithmic axis.
#[derive(Debug, Clone, Copy)]
pub struct Scale {
    /// Quantity with its unit.
    pub title: &'static str,
    /// Format of a number.
    pub write: fn(f64) -> String,
}

/// Curves over one horizontal axis.
#[derive(Debug, Clone)]
pub struct Panel {
    /// Title above it.
    pub title: &'static str,
    /// Horizontal axis.
    pub across: Scale,
    /// Curves, drawn in order.
    pub curves: Vec<Curve>,
}

/// A line through points.
#[derive(Debug, Clone)]
pub struct Curve {
    /// Text at its end.
    pub label: String,
    /// Number of its colour; any number has one.
    pub hue: usize,
    /// True if it is a bound: a dashed line without dots.
    pub is_bound: bool,
    /// Points from left to right, above zero; a second number may be zero, which has a line of its
    /// own below the axis.
    pub points: Vec<[f64; 2]>,
}

impl Scale {
    /// An axis of plain numbers.
    #[must_use]
    pub fn of(title: &'static str) -> Self {
        let write: Write = number;
        Self { title, write }
    }
}

const SIZE: [f64; 2] = [880.0, 430.0];
const LEFT: f64 = 72.0;
/// Room for the labels of curves, on the right.
const MARGIN: f64 = 186.0;
const TOP: f64 = 52.0;
const BOTTOM: f64 = SIZE[1] - 48.0;
/// Room between two panels.
const GUTTER: f64 = 40.0;
/// Distance of the line of zeros from the axis.
const ZERO: f64 = 26.0;
/// Height of a label.
const LINE: f64 = 17.0;

impl Figure {
    /// The figure as an SVG file.
    #[must_use]
    pub fn svg(&self) -> String {
        let mut svg = Svg::paper(SIZE);
        let numbers = || {
            let curves = self.panels.iter().flat_map(|panel| &panel.curves);
            curves.flat_map(|curve| curve.points.iter().map(|point| point[1]))
        };
        let up = Axis::around(numbers());
        let bottom = match numbers().any(|number| number == 0.0) && !up.is_zero() {
            true => BOTTOM - ZERO,
            false => BOTTOM,
        };
        svg.text("title", "start", [LEFT - 46.0, 20.0], self.up.title);
        #[expect(clippy::cast_precision_loss, reason = "a few panels")]
        let count = self.panels.len() as f64;
        let wide = (SIZE[0] - LEFT - MARGIN + GUTTER) / count - GUTTER;
        let mut left = LEFT;
        for (number, panel) in self.panels.iter().enumerate() {
            let points = panel.curves.iter().flat_map(|curve| &curve.points);
            let right = left + wide;
            let frame = Frame {
                across: [left, right],
                down: [TOP, bottom],
                foot: BOTTOM + 19.0,
                x: Axis::around(points.map(|point| point[0])),
                y: up,
            };
            let is_first = number == 0;
            let write_up = is_first.then_some(self.up.write);
            frame.draw(&mut svg, panel.across.write, write_up);
            if bottom < BOTTOM {
                svg.line("grid", [left, BOTTOM], [right, BOTTOM]);
                if is_first {
                    svg.text("mark", "end", [left - 8.0, BOTTOM + 4.0], "none");
                }
            }
            svg.text("key", "start", [left, TOP - 9.0], panel.title);
            svg.text("note", "end", [right, SIZE[1] - 9.0], panel.across.title);
            let ends = panel.draw(&mut svg, &frame);
            if number + 1 == self.panels.len() {
                panel.label(&mut svg, &ends, right);
            }
            left = right + GUTTER;
        }
        svg.file(SIZE)
    }
}

impl Panel {
    /// Draws the curves and returns their ends.
    fn draw(&self, svg: &mut Svg, frame: &Frame) -> Vec<Place> {
        let mut ends = Vec::new();
        for curve in &self.curves {
            let places = curve.points.iter().map(|point| match point[1] {
                0.0 => [frame.place(*point)[0], BOTTOM],
                _ => frame.place(*point),
            });
            let places: Vec<_> = places.collect();
            let color = color_class(Some(curve.hue));
            if curve.is_bound {
                svg.polyline(&format!("bound {color}"), &places);
            } else {
                svg.polyline(&format!("curve {color}"), &places);
                for place in &places {
                    svg.circle(&format!("dot {color}"), *place, 3.5);
                }
            }
            ends.extend(places.last());
        }
        ends
    }

    /// Draws the labels of the curves beside their ends.
    fn label(&self, svg: &mut Svg, ends: &[Place], right: f64) {
        let mut heights: Vec<_> = ends.iter().map(|end| end[1]).collect();
        spread(&mut heights, LINE, [TOP, BOTTOM]);
        for ((curve, end), height) in self.curves.iter().zip(ends).zip(heights) {
            let color = color_class(Some(curve.hue));
            let [from, to] = [right + 12.0, right + 24.0];
            let leader = [*end, [from, end[1]], [to, height]];
            svg.polyline(&format!("leader {color}"), &leader);
            let place = [to + 5.0, height + 4.0];
            svg.text(&format!("end {color}"), "start", place, &curve.label);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(label: &str, points: &[[f64; 2]]) -> Curve {
        Curve {
            label: label.to_owned(),
            hue: 0,
            is_bound: false,
            points: points.to_vec(),
        }
    }

    #[test]
    fn curves_have_dots_and_names_and_zeros_a_line_of_their_own() {
        let panel = |last| Panel {
            title: "it",
            across: Scale::of("rays"),
            curves: vec![
                curve("even", &[[1.0, 0.5], [4.0, last]]),
                curve("odd", &[[1.0, 0.5], [4.0, 0.1]]),
            ],
        };
        let figure = |last| Figure {
            panels: vec![panel(0.1), panel(last)],
            up: Scale::of("error"),
        };
        let svg = figure(0.1).svg();
        assert!(svg.starts_with("<svg xmlns="));
        assert_eq!(svg.matches("class=\"dot").count(), 8);
        assert_eq!(svg.matches(">even</text>").count(), 1, "named once");
        assert!(!svg.contains(">none</text>"));
        assert!(figure(0.0).svg().contains(">none</text>"));
    }
}
