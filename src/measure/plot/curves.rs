//! Curves in panels.

use super::frame::Write;
use super::labels::spread;
use super::{Axis, Frame, HUES, STYLE, Svg, number};

/// Curves in panels side by side, which share their vertical axis.
#[derive(Debug, Clone)]
pub struct Figure {
    /// The panels from left to right. The labels of the last one's curves stand for all.
    pub panels: Vec<Panel>,
    /// What goes up.
    pub up: Scale,
    /// What lies below this number means nothing, and why.
    pub doubt: Option<(f64, &'static str)>,
}

/// What an axis shows; it is logarithmic.
#[derive(Debug, Clone, Copy)]
pub struct Scale {
    /// What it is, with its unit.
    pub title: &'static str,
    /// How a number of it is written.
    pub write: fn(f64) -> String,
}

/// Curves over one axis.
#[derive(Debug, Clone)]
pub struct Panel {
    /// What is above it.
    pub title: &'static str,
    /// What goes from left to right.
    pub across: Scale,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// A line through some points.
#[derive(Debug, Clone)]
pub struct Curve {
    /// What stands at its end.
    pub label: String,
    /// The number of its colour; any number has one.
    pub hue: usize,
    /// Whether it is a bound, which is drawn as a line of dashes without dots.
    pub is_bound: bool,
    /// The points from left to right. A second number of zero is drawn on a line of its own, below the
    /// axis; others, and all first ones, are above zero.
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
/// Where labels of curves start, from the right.
const MARGIN: f64 = 186.0;
const TOP: f64 = 52.0;
const BOTTOM: f64 = SIZE[1] - 48.0;
/// Between two panels.
const GUTTER: f64 = 40.0;
/// From the line of zeros to the axis.
const ZERO: f64 = 26.0;
/// From one label to the next.
const LINE: f64 = 17.0;

impl Figure {
    /// The figure as an SVG file.
    #[must_use]
    pub fn svg(&self) -> String {
        let mut svg = Svg::default();
        svg.rectangle("sheet", [0.0, 0.0], SIZE);
        let numbers = || {
            let curves = self.panels.iter().flat_map(|panel| &panel.curves);
            curves.flat_map(|curve| curve.points.iter().map(|point| point[1]))
        };
        let doubt = self.doubt.map(|(number, _)| number);
        let up = Axis::around(numbers().chain(doubt));
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
            let frame = Frame {
                across: [left, left + wide],
                down: [TOP, bottom],
                foot: BOTTOM + 19.0,
                x: Axis::around(points.map(|point| point[0])),
                y: up,
            };
            let is_first = number == 0;
            frame.draw(
                &mut svg,
                panel.across.write,
                is_first.then_some(self.up.write),
            );
            if bottom < BOTTOM {
                svg.line("grid", [left, BOTTOM], [left + wide, BOTTOM]);
                if is_first {
                    svg.text("mark", "end", [left - 8.0, BOTTOM + 4.0], "none");
                }
            }
            self.error_bounds(&mut svg, &frame);
            svg.text("key", "start", [left, TOP - 9.0], panel.title);
            let title = [left + wide, SIZE[1] - 9.0];
            svg.text("note", "end", title, panel.across.title);
            let ends = panel.draw(&mut svg, &frame);
            if number + 1 == self.panels.len() {
                panel.name(&mut svg, &ends, left + wide);
            }
            left += wide + GUTTER;
        }
        svg.file(SIZE, STYLE)
    }

    /// Draws the band of what means nothing.
    fn error_bounds(&self, svg: &mut Svg, frame: &Frame) {
        let Some((number, why)) = self.doubt else {
            return;
        };
        let [left, right] = frame.across;
        let [_, at] = frame.place([frame.x.least, number]);
        svg.rectangle("doubt", [left, at], [right - left, frame.down[1] - at]);
        svg.text("note", "start", [left + 8.0, frame.down[1] - 8.0], why);
    }
}

impl Panel {
    /// Draws the curves, and tells where they end.
    fn draw(&self, svg: &mut Svg, frame: &Frame) -> Vec<[f64; 2]> {
        let mut ends = Vec::new();
        for curve in &self.curves {
            let places = curve.points.iter().map(|point| match point[1] {
                0.0 => [frame.place(*point)[0], BOTTOM],
                _ => frame.place(*point),
            });
            let places: Vec<_> = places.collect();
            let hue = curve.hue % HUES;
            if curve.is_bound {
                svg.path(&format!("bound hue-{hue}"), &places);
            } else {
                svg.path(&format!("curve hue-{hue}"), &places);
                for place in &places {
                    svg.circle(&format!("dot hue-{hue}"), *place, 3.5);
                }
            }
            ends.extend(places.last());
        }
        ends
    }

    /// Writes the names of the curves beside their ends.
    fn name(&self, svg: &mut Svg, ends: &[[f64; 2]], right: f64) {
        let mut heights: Vec<_> = ends.iter().map(|end| end[1]).collect();
        spread(&mut heights, LINE, [TOP, BOTTOM]);
        for ((curve, end), height) in self.curves.iter().zip(ends).zip(heights) {
            let hue = curve.hue % HUES;
            let [from, to] = [right + 12.0, right + 24.0];
            svg.path(
                &format!("leader hue-{hue}"),
                &[*end, [from, end[1]], [to, height]],
            );
            let place = [to + 5.0, height + 4.0];
            svg.text(&format!("end hue-{hue}"), "start", place, &curve.label);
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
            doubt: None,
        };
        let svg = figure(0.1).svg();
        assert!(svg.starts_with("<svg xmlns="));
        assert_eq!(svg.matches("class=\"dot").count(), 8);
        assert_eq!(svg.matches(">even</text>").count(), 1, "named once");
        assert!(!svg.contains(">none</text>"));
        assert!(figure(0.0).svg().contains(">none</text>"));
    }
}
