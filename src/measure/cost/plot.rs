//! Error against time as a drawing.

use super::words::percent;
use super::{Cost, DIALS, Measured};
use crate::measure::clock::in_words;
use crate::measure::plot::{Axis, Frame, HUES, Labels, STYLE, Svg, number, seconds};

/// The axes of time and of error of all rungs.
pub(super) fn axes(cost: &Cost) -> [Axis; 2] {
    let times = cost.rungs.iter().map(|rung| rung.cpu.median);
    let errors = cost.rungs.iter().map(|rung| rung.deviation.rmse);
    let doubt = cost.reference.doubt.map(|doubt| doubt.rmse);
    [Axis::around(times), Axis::around(errors.chain(doubt))]
}

impl Cost {
    /// The plot as an SVG file.
    #[must_use]
    pub fn plot(&self) -> String {
        let size = [880.0, 500.0];
        let mut svg = Svg::default();
        svg.rectangle("sheet", [0.0, 0.0], size);
        self.draw(&mut svg, size);
        svg.file(size, STYLE)
    }

    /// The plot as an element of a page that has the style.
    pub(super) fn plot_element(&self, class: &str, size: [f64; 2]) -> String {
        let mut svg = Svg::default();
        self.draw(&mut svg, size);
        svg.element(class, size)
    }

    fn draw(&self, svg: &mut Svg, [width, height]: [f64; 2]) {
        let is_narrow = width < 600.0;
        let [left, right, below] = if is_narrow {
            [52.0, 10.0, 92.0]
        } else {
            [72.0, 24.0, 84.0]
        };
        let [x, y] = axes(self);
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
        if let Some(doubt) = self.reference.doubt.filter(|doubt| doubt.rmse > 0.0) {
            let [_, at] = frame.place([x.least, doubt.rmse]);
            svg.rectangle("doubt", [left, at], [right - left, bottom - at]);
            let words = "error of the reference itself";
            svg.text("note", "start", [left + 8.0, bottom - 8.0], words);
            labels.avoid([left + 90.0, bottom - 12.0], [90.0, 8.0]);
        }
        svg.text("title", "start", [left, top - 9.0], "RMSE (1 = white)");
        svg.text("title", "end", [right, bottom + 36.0], "processor time");
        self.draw_front(svg, &frame);
        // The scene as it is, comes last, on top of all others.
        for (number, rung) in self.rungs.iter().enumerate().rev() {
            let class = format!("dot {}", color(rung.dial));
            svg.dot(&class, number, place(&frame, rung), &story(rung));
            // A little less up and down, so that nearly the same dots leave room above.
            labels.avoid(place(&frame, rung), [6.0, 5.0]);
        }
        self.label(svg, &frame, labels);
        self.legend(svg, [left, bottom + 62.0], right);
    }

    /// Draws the steps that join the rungs which nothing beats.
    fn draw_front(&self, svg: &mut Svg, frame: &Frame) {
        let front = self.rungs.iter().filter(|rung| rung.is_on_front());
        let mut front: Vec<_> = front.collect();
        front.sort_by(|one, other| one.cpu.median.total_cmp(&other.cpu.median));
        let mut steps: Vec<[f64; 2]> = Vec::new();
        for rung in front {
            let [x, y] = place(frame, rung);
            let before = steps.last().map(|last| [x, last[1]]);
            steps.extend(before);
            steps.push([x, y]);
        }
        svg.path("front", &steps);
    }

    /// Names rungs, as far as there is room: what stands alone and what nothing beats first.
    fn label(&self, svg: &mut Svg, frame: &Frame, mut labels: Labels) {
        /// Of dots that are closer than this, one has a name.
        const TWINS: f64 = 9.0;
        let mut rungs: Vec<_> = self.rungs.iter().collect();
        rungs.sort_by_key(|rung| (rung.dial.is_some(), !rung.is_on_front()));
        let mut named: Vec<[f64; 2]> = Vec::new();
        for rung in rungs {
            let [x, y] = place(frame, rung);
            let is_near = |other: &[f64; 2]| (other[0] - x).hypot(other[1] - y) < TWINS;
            if named.iter().any(is_near) {
                continue;
            }
            let name = name(rung);
            if let Some(middle) = labels.beside([x, y], name) {
                svg.text("label", "middle", middle, name);
                named.push([x, y]);
            }
        }
    }

    /// The dials and their colours, in rows below the plot.
    fn legend(&self, svg: &mut Svg, [left, y]: [f64; 2], right: f64) {
        let mut dials: Vec<Option<&str>> = Vec::new();
        for rung in &self.rungs {
            if !dials.contains(&rung.dial) {
                dials.push(rung.dial);
            }
        }
        let combined = self.rungs.iter().filter(|rung| rung.dial.is_none()).count() > 1;
        let [mut x, mut y] = [left, y];
        for dial in dials {
            let title = match dial {
                Some(dial) => dial,
                None if combined => "several dials",
                None => "the scene as it is",
            };
            let letters: f64 = title.chars().map(width_of).sum();
            let width = 15.0 + letters;
            if x + width > right + 10.0 {
                [x, y] = [left, y + 17.0];
            }
            svg.rectangle(&format!("chip {}", color(dial)), [x, y - 9.0], [10.0, 10.0]);
            svg.text("key", "start", [x + 15.0, y], title);
            x += width + 13.0;
        }
    }
}

fn place(frame: &Frame, rung: &Measured) -> [f64; 2] {
    frame.place([rung.cpu.median, rung.deviation.rmse])
}

/// About how wide a letter of the legend is.
fn width_of(letter: char) -> f64 {
    match letter {
        'f' | 'i' | 'j' | 'l' | 'r' | 't' | '-' | ' ' => 4.6,
        'm' | 'w' => 11.0,
        _ => 7.6,
    }
}

/// What a rung is called where its dial is told already, as by the colour of its dot.
fn name(rung: &Measured) -> &str {
    let own = rung.dial.and_then(|dial| rung.own(dial));
    own.map_or(&rung.label, |own| &own.step)
}

/// The class with the colour of a dial.
pub(super) fn color(dial: Option<&str>) -> String {
    let number = DIALS.iter().position(|known| Some(known.word) == dial);
    number.map_or("plain".to_owned(), |number| {
        format!("hue-{}", number % HUES)
    })
}

/// What there is to say about a rung, in lines.
fn story(rung: &Measured) -> String {
    let deviation = &rung.deviation;
    let worth = match &rung.dominated_by {
        None => "on the Pareto front".to_owned(),
        Some(better) => format!("{better} is better"),
    };
    let also = rung
        .own
        .iter()
        .filter(|own| rung.dial.is_some_and(|dial| dial != own.dial));
    let also: String = also
        .map(|own| format!("\nalso {}={}", own.dial, own.step))
        .collect();
    format!(
        "{}{also}\n{} of processor time\nRMSE {:.6}\nlargest error {:.2} code values\n{} of the pixels off\nFLIP {:.4}\n{worth}",
        rung.label,
        in_words(rung.cpu.median),
        deviation.rmse,
        deviation.change.largest,
        percent(deviation.change.pixels),
        deviation.flip,
    )
}
