//! Grid of a plot and the numbers on its axes.

use super::axis::Axis;
use super::svg::{Place, Svg};

/// Part of a drawing with two axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    /// Left and right sides.
    pub(super) across: [f64; 2],
    /// Top and bottom.
    pub(super) down: [f64; 2],
    /// Base line of the numbers below it.
    pub(super) foot: f64,
    pub(super) x: Axis,
    pub(super) y: Axis,
}

/// Formats a number of an axis.
pub(super) type Write = fn(f64) -> String;

impl Frame {
    /// Place of a pair of numbers in the drawing.
    pub(super) fn place(&self, [x, y]: [f64; 2]) -> Place {
        let [[left, right], [top, bottom]] = [self.across, self.down];
        [
            left + (right - left) * self.x.share(x),
            bottom - (bottom - top) * self.y.share(y),
        ]
    }

    /// Draws a grid line and a number at each mark; numbers of the vertical axis only if asked for.
    pub(super) fn draw(&self, svg: &mut Svg, x: Write, y: Option<Write>) {
        /// Width of a character, and least room between two numbers; others are left out.
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

/// A number as short as possible; a very small or large one to one digit.
pub(super) fn number(number: f64) -> String {
    let rounded = (1e6 * number).round() / 1e6;
    if number == 0.0 || (0.001..100_000.0).contains(&number) {
        rounded.to_string()
    } else {
        format!("{number:.0e}")
    }
}

/// A time in seconds or milliseconds.
pub(super) fn seconds(seconds: f64) -> String {
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
