//! Error against time as a drawing.

use super::svg::Svg;
use super::table::{median, percent};
use super::{Cost, DIALS, Measured};

/// The colours and lines of the drawing, for light and dark pages.
pub(super) const STYLE: &str = include_str!("plot.css");

/// A logarithmic axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Axis {
    /// Its lower end.
    pub(super) least: f64,
    /// Its upper end.
    pub(super) most: f64,
}

impl Axis {
    /// The axes of time and of error of all rungs.
    pub(super) fn of(cost: &Cost) -> (Self, Self) {
        let times = cost.rungs.iter().map(|rung| rung.cpu.median);
        let errors = cost.rungs.iter().map(|rung| rung.deviation.rmse);
        let doubt = cost.reference.doubt.map(|doubt| doubt.rmse);
        (Self::around(times), Self::around(errors.chain(doubt)))
    }

    /// An axis around these numbers, as far as they are above zero.
    fn around(numbers: impl Iterator<Item = f64>) -> Self {
        let positive = numbers.filter(|number| *number > 0.0);
        let (least, most) = positive.fold((f64::INFINITY, 0.0_f64), |(least, most), number| {
            (least.min(number), most.max(number))
        });
        if least > most {
            return Self {
                least: 0.1,
                most: 1.0,
            };
        }
        Self {
            least: least / 1.4,
            most: most * 1.4,
        }
    }

    /// Where a number is, from 0 to 1; what is too small is at the lower end.
    pub(super) fn share(self, number: f64) -> f64 {
        let [least, most, number] =
            [self.least, self.most, number.max(self.least)].map(libm::log10);
        ((number - least) / (most - least)).clamp(0.0, 1.0)
    }

    /// The numbers 1, 2 and 5 times powers of ten on it; of a long axis the powers alone.
    fn marks(self) -> Vec<f64> {
        let decades = libm::log10(self.most / self.least);
        let steps: &[f64] = if decades > 2.5 {
            &[1.0]
        } else {
            &[1.0, 2.0, 5.0]
        };
        let marks = (-12..12).flat_map(|power| {
            let power = libm::pow(10.0, f64::from(power));
            steps.iter().map(move |step| step * power)
        });
        marks
            .filter(|mark| (self.least..=self.most).contains(mark))
            .collect()
    }
}

impl Cost {
    /// The plot as an SVG file.
    #[must_use]
    pub fn plot(&self) -> String {
        let size = [880.0, 500.0];
        let name_space = "xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" width=\"880\"";
        self.drawing(size, true).element(name_space, size, STYLE)
    }

    /// The plot as an element of a page that has the style.
    pub(super) fn plot_element(&self, class: &str, size: [f64; 2]) -> String {
        let class = format!("class=\"plot {class}\"");
        self.drawing(size, false).element(&class, size, "")
    }

    fn drawing(&self, [width, height]: [f64; 2], alone: bool) -> Svg {
        let mut svg = Svg::default();
        let (time, error) = Axis::of(self);
        let narrow = width < 600.0;
        let [left, right, top, bottom] = if narrow {
            [58.0, width - 14.0, 20.0, height - 78.0]
        } else {
            [72.0, width - 24.0, 24.0, height - 84.0]
        };
        let x = |seconds: f64| left + (right - left) * time.share(seconds);
        let y = |rmse: f64| bottom - (bottom - top) * error.share(rmse);
        if alone {
            svg.rectangle("sheet", [0.0, 0.0], [width, height]);
        }
        for mark in error.marks() {
            svg.line("grid", [left, y(mark)], [right, y(mark)]);
            svg.text("mark", "end", [left - 8.0, y(mark) + 4.0], &number(mark));
        }
        let mut last = f64::NEG_INFINITY;
        for mark in time.marks() {
            if x(mark) - last < 54.0 {
                continue;
            }
            last = x(mark);
            svg.line("grid", [x(mark), top], [x(mark), bottom]);
            svg.text("mark", "middle", [x(mark), bottom + 18.0], &seconds(mark));
        }
        if let Some(doubt) = self.reference.doubt {
            let height = bottom - y(doubt.rmse);
            svg.rectangle("doubt", [left, y(doubt.rmse)], [right - left, height]);
            let words = "error of the reference itself";
            svg.text("note", "start", [left + 8.0, y(doubt.rmse) + 15.0], words);
        }
        svg.text("title", "start", [left, top - 8.0], "RMSE (1 = white)");
        svg.text("title", "end", [right, bottom + 36.0], "processor time");
        let mut front: Vec<_> = self
            .rungs
            .iter()
            .filter(|rung| rung.is_on_front())
            .collect();
        front.sort_by(|one, other| one.cpu.median.total_cmp(&other.cpu.median));
        let mut steps: Vec<[f64; 2]> = Vec::new();
        for rung in front {
            let place = [x(rung.cpu.median), y(rung.deviation.rmse)];
            let before = steps.last().map(|last| [place[0], last[1]]);
            steps.extend(before);
            steps.push(place);
        }
        svg.path("front", &steps);
        let mut labels: Vec<([f64; 2], f64)> = Vec::new();
        // The scene as it is, comes last, on top of all others.
        for (number, rung) in self.rungs.iter().enumerate().rev() {
            let place = [x(rung.cpu.median), y(rung.deviation.rmse)];
            let class = format!("dot {}", color(rung.dial));
            svg.dot(&class, number, place, &story(rung));
            let label = match rung.value {
                Some(value) if rung.dial == Some("samples") => value.to_string(),
                // What else is set is the same for all steps of a dial.
                _ if rung.dial.is_some() => {
                    let words = rung.label.rsplit(' ').next();
                    words.unwrap_or_default().to_owned()
                }
                _ => rung.label.clone(),
            };
            let at = [place[0], place[1] - 11.0];
            #[expect(clippy::cast_precision_loss, reason = "a few letters")]
            let half = 3.6 * label.len() as f64 + 4.0;
            let free = |([x, y], other): &([f64; 2], f64)| {
                (x - at[0]).abs() > half + other || (y - at[1]).abs() > 15.0
            };
            let inside = at[0] - half > left - 40.0 && at[0] + half < width;
            let asked = rung.is_on_front() || rung.dial.is_none();
            if asked && inside && labels.iter().all(free) {
                svg.text("label", "middle", at, &label);
                labels.push((at, half));
            }
        }
        self.legend(&mut svg, [left, height - 22.0], right, narrow);
        svg
    }

    /// The dials and their colours, in a row below the plot.
    fn legend(&self, svg: &mut Svg, [left, y]: [f64; 2], right: f64, narrow: bool) {
        let mut seen: Vec<Option<&str>> = Vec::new();
        for rung in &self.rungs {
            if !seen.contains(&rung.dial) {
                seen.push(rung.dial);
            }
        }
        let letter = if narrow { 6.4 } else { 7.2 };
        let (mut x, mut y) = (left, y);
        for dial in seen {
            let title = dial.unwrap_or("the scene as it is");
            let title =
                if dial.is_none() && self.rungs.iter().filter(|r| r.dial.is_none()).count() > 1 {
                    "several dials"
                } else {
                    title
                };
            #[expect(clippy::cast_precision_loss, reason = "a few letters")]
            let width = 30.0 + letter * title.len() as f64;
            if x + width > right + 10.0 {
                (x, y) = (left, y + 17.0);
            }
            svg.rectangle(&format!("chip {}", color(dial)), [x, y - 9.0], [10.0, 10.0]);
            svg.text("key", "start", [x + 15.0, y], title);
            x += width;
        }
    }
}

/// The class with the colour of a dial.
pub(super) fn color(dial: Option<&str>) -> String {
    let place = DIALS.iter().position(|known| Some(known.word) == dial);
    place.map_or("plain".to_owned(), |place| format!("dial-{place}"))
}

/// What there is to say about a rung, in lines.
fn story(rung: &Measured) -> String {
    let deviation = &rung.deviation;
    let worth = match &rung.dominated_by {
        None => "on the Pareto front".to_owned(),
        Some(better) => format!("{better} is better"),
    };
    format!(
        "{}\n{} of processor time\nRMSE {:.6}\nlargest error {:.2} code values\n{} of the pixels off\n{worth}",
        rung.label,
        median(rung.cpu),
        deviation.rmse,
        deviation.change.largest,
        percent(deviation.change.pixels),
    )
}

fn number(number: f64) -> String {
    if number >= 0.001 {
        number.to_string()
    } else {
        format!("{number:e}")
    }
}

fn seconds(seconds: f64) -> String {
    let rounded = |number: f64| (1000.0 * number).round() / 1000.0;
    if seconds < 1.0 {
        format!("{} ms", rounded(1000.0 * seconds))
    } else {
        format!("{} s", rounded(seconds))
    }
}
