//! The axes of a drawing.

use super::axis::Axis;
use super::svg::Svg;

/// A part of a drawing with two axes.
#[derive(Debug, Clone, Copy)]
pub(in crate::measure) struct Frame {
    /// Where its left and right sides are.
    pub(in crate::measure) across: [f64; 2],
    /// Where its top and bottom are.
    pub(in crate::measure) down: [f64; 2],
    /// The base line of the numbers below it.
    pub(in crate::measure) foot: f64,
    /// What goes from left to right.
    pub(in crate::measure) x: Axis,
    /// What goes from the bottom to the top.
    pub(in crate::measure) y: Axis,
}

/// How a number is written.
pub(in crate::measure) type Write = fn(f64) -> String;

impl Frame {
    /// Where two numbers are in the drawing.
    pub(in crate::measure) fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [[left, right], [top, bottom]] = [self.across, self.down];
        [
            left + (right - left) * self.x.share(x),
            bottom - (bottom - top) * self.y.share(y),
        ]
    }

    /// Draws a line and a number at each mark of both axes, those of the vertical one only if asked for.
    pub(in crate::measure) fn draw(&self, svg: &mut Svg, x: Write, y: Option<Write>) {
        /// How wide a letter is, and the least room between two numbers; what has less is left out.
        const LETTER: f64 = 6.8;
        const GAP: f64 = 8.0;
        let [[left, right], [top, bottom]] = [self.across, self.down];
        for mark in self.y.marks() {
            let [_, at] = self.place([self.x.least, mark]);
            svg.line("grid", [left, at], [right, at]);
            if let Some(write) = y {
                svg.text("mark", "end", [left - 8.0, at + 4.0], &write(mark));
            }
        }
        let mut last = f64::NEG_INFINITY;
        for mark in self.x.marks() {
            let [at, _] = self.place([mark, self.y.least]);
            let number = x(mark);
            #[expect(clippy::cast_precision_loss, reason = "a few letters")]
            let half = LETTER * number.chars().count() as f64 / 2.0;
            if at - half - last >= GAP {
                last = at + half;
                svg.line("grid", [at, top], [at, bottom]);
                svg.text("mark", "middle", [at, self.foot], &number);
            }
        }
    }
}

/// A number as short as it can be; a very small or large one to one digit.
pub(in crate::measure) fn number(number: f64) -> String {
    let rounded = (1e6 * number).round() / 1e6;
    if number == 0.0 || (0.001..100_000.0).contains(&number) {
        rounded.to_string()
    } else {
        format!("{number:.0e}")
    }
}

/// A time in seconds or thousandths of that.
pub(in crate::measure) fn seconds(seconds: f64) -> String {
    if seconds < 1.0 {
        format!("{} ms", number(1000.0 * seconds))
    } else {
        format!("{} s", number(seconds))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let written = [0.0, 0.1 + 0.2, 0.005, 2e-5, 1000.0, 1e6].map(number);
        assert_eq!(written, ["0", "0.3", "0.005", "2e-5", "1000", "1e6"]);
        assert_eq!(
            [0.02, 0.000_5, 5.0].map(seconds),
            ["20 ms", "0.5 ms", "5 s"]
        );
    }
}
