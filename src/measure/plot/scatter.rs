//! Named dots over two logarithmic axes.

use super::axis::Axis;
use super::color_class;
use super::frame::{Frame, number, seconds};
use super::labels::Labels;
use super::svg::{Place, Svg};

/// Dots over a horizontal axis of seconds and a vertical axis of plain numbers.
#[derive(Debug)]
pub(in crate::measure) struct Scatter<'a> {
    /// Titles of the horizontal and of the vertical axis.
    pub(in crate::measure) titles: [&'static str; 2],
    /// The dots; the first is drawn on top.
    pub(in crate::measure) dots: Vec<Dot<'a>>,
    /// Error of the reference, below which the vertical axis is shaded.
    pub(in crate::measure) noise_floor: Option<f64>,
}

/// A dot with a name and a tooltip.
#[derive(Debug)]
pub(in crate::measure) struct Dot<'a> {
    pub(in crate::measure) at: [f64; 2],
    pub(in crate::measure) name: &'a str,
    /// Entry of the legend that it belongs to.
    pub(in crate::measure) group: &'a str,
    /// Number of its colour; dots without one are labelled first.
    pub(in crate::measure) hue: Option<usize>,
    pub(in crate::measure) tooltip: String,
    /// True if it is on the Pareto front, which a dotted line joins.
    pub(in crate::measure) is_on_front: bool,
}

impl Scatter<'_> {
    /// The plot as an SVG file.
    pub(in crate::measure) fn svg(&self) -> String {
        let size = [880.0, 500.0];
        let mut svg = Svg::paper(size);
        self.draw(&mut svg, size);
        svg.file(size)
    }

    /// The plot as an element of a page that has the style sheet.
    pub(in crate::measure) fn element(&self, class: &str, size: [f64; 2]) -> String {
        let mut svg = Svg::default();
        self.draw(&mut svg, size);
        svg.element(class, size)
    }

    /// Axes around all dots and the noise floor.
    pub(super) fn axes(&self) -> [Axis; 2] {
        let along = |axis: usize| self.dots.iter().map(move |dot| dot.at[axis]);
        let up = along(1).chain(self.noise_floor);
        [Axis::around(along(0)), Axis::around(up)]
    }

    fn draw(&self, svg: &mut Svg, [width, height]: [f64; 2]) {
        let is_narrow = width < 600.0;
        let [left, right, below] = if is_narrow {
            [52.0, 10.0, 92.0]
        } else {
            [72.0, 24.0, 84.0]
        };
        let [x, y] = self.axes();
        let frame = Frame {
            across: [left, width - right],
            down: [24.0, height - below],
            foot: height - below + 18.0,
            x,
            y,
        };
        let [[left, right], [top, bottom]] = [frame.across, frame.down];
        frame.draw(svg, seconds, Some(number));
        let mut labels = Labels::within([left + 2.0, top], [right, bottom]);
        if let Some(floor) = self.noise_floor.filter(|floor| *floor > 0.0) {
            let [_, at] = frame.place([x.least, floor]);
            svg.rectangle("noise", [left, at], [right - left, bottom - at]);
            let note = "error of the reference itself";
            svg.text("note", "start", [left + 8.0, bottom - 8.0], note);
            labels.avoid([left + 90.0, bottom - 12.0], [90.0, 8.0]);
        }
        let [across, up] = self.titles;
        svg.text("title", "start", [left, top - 9.0], up);
        svg.text("title", "end", [right, bottom + 36.0], across);
        self.draw_front(svg, &frame);
        for (number, dot) in self.dots.iter().enumerate().rev() {
            let (class, place) = (color_class(dot.hue), frame.place(dot.at));
            svg.dot(&format!("dot {class}"), number, place, &dot.tooltip);
            // A little less up and down, so that nearly the same dots leave room above.
            labels.avoid(place, [6.0, 5.0]);
        }
        self.label(svg, &frame, labels);
        self.legend(svg, [left, bottom + 62.0], right);
    }

    /// Draws steps that join the dots on the Pareto front.
    fn draw_front(&self, svg: &mut Svg, frame: &Frame) {
        let mut front: Vec<_> = self.dots.iter().filter(|dot| dot.is_on_front).collect();
        front.sort_by(|one, other| one.at[0].total_cmp(&other.at[0]));
        let mut steps: Vec<Place> = Vec::new();
        for dot in front {
            let [x, y] = frame.place(dot.at);
            let before = steps.last().map(|last| [x, last[1]]);
            steps.extend(before);
            steps.push([x, y]);
        }
        svg.polyline("front", &steps);
    }

    /// Names dots as far as there is room, those without a hue and on the front first.
    fn label(&self, svg: &mut Svg, frame: &Frame, mut labels: Labels) {
        /// Distance below which one of two dots is named.
        const TWINS: f64 = 9.0;
        let mut dots: Vec<_> = self.dots.iter().collect();
        dots.sort_by_key(|dot| (dot.hue.is_some(), !dot.is_on_front));
        let mut named: Vec<Place> = Vec::new();
        for dot in dots {
            let [x, y] = frame.place(dot.at);
            let is_near = |other: &Place| (other[0] - x).hypot(other[1] - y) < TWINS;
            if named.iter().any(is_near) {
                continue;
            }
            if let Some(middle) = labels.beside([x, y], dot.name) {
                svg.text("label", "middle", middle, dot.name);
                named.push([x, y]);
            }
        }
    }

    /// Draws the groups and their colours in rows below the plot.
    fn legend(&self, svg: &mut Svg, [left, y]: Place, right: f64) {
        let mut groups: Vec<&Dot<'_>> = Vec::new();
        for dot in &self.dots {
            if !groups.iter().any(|known| known.group == dot.group) {
                groups.push(dot);
            }
        }
        let [mut x, mut y] = [left, y];
        for Dot { group, hue, .. } in groups {
            let width = 15.0 + group.chars().map(width_of).sum::<f64>();
            if x + width > right + 10.0 {
                [x, y] = [left, y + 17.0];
            }
            let class = format!("chip {}", color_class(*hue));
            svg.rectangle(&class, [x, y - 9.0], [10.0, 10.0]);
            svg.text("key", "start", [x + 15.0, y], group);
            x += width + 13.0;
        }
    }
}

/// Approximate width of a letter of the legend.
fn width_of(letter: char) -> f64 {
    match letter {
        'f' | 'i' | 'j' | 'l' | 'r' | 't' | '-' | ' ' => 4.6,
        'm' | 'w' => 11.0,
        _ => 7.6,
    }
}
