//! Named dots as a plot in characters.

use std::fmt;

use super::Scatter;
use super::frame::seconds;

const WIDTH: usize = 64;
const HEIGHT: usize = 14;

/// Names of dots in a table beside the plot: a letter, or a number if no letter is left.
pub(in crate::measure) fn names() -> impl Iterator<Item = String> {
    let numbered = letters().zip(1_usize..);
    numbered.map(|(letter, number)| match letter {
        '+' => number.to_string(),
        letter => letter.to_string(),
    })
}

/// Letters of dots in the plot.
fn letters() -> impl Iterator<Item = char> {
    ('a'..='z').chain('A'..='Z').chain(std::iter::repeat('+'))
}

impl fmt::Display for Scatter<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y] = self.axes();
        let mut cells = [[' '; WIDTH]; HEIGHT];
        for (dot, letter) in self.dots.iter().zip(letters()) {
            let column = cell_at(x.share(dot.at[0]), WIDTH);
            let row = cell_at(1.0 - y.share(dot.at[1]), HEIGHT);
            let cell = &mut cells[row][column];
            // Of two dots in one cell the first is shown.
            if *cell == ' ' {
                *cell = letter;
            }
        }
        let [across, up] = self.titles;
        writeln!(out, "  {up}")?;
        for (row, cells) in cells.iter().enumerate() {
            let mark = match row {
                row if row + 1 == HEIGHT && y.is_zero() => "0".to_owned(),
                row if row + 1 == HEIGHT => format!("{:.0e}", y.least),
                0 if !y.is_zero() => format!("{:.0e}", y.most),
                _ => String::new(),
            };
            let cells: String = cells.iter().collect();
            writeln!(out, "  {mark:>6} │{}", cells.trim_end())?;
        }
        writeln!(out, "         └{}", "─".repeat(WIDTH))?;
        let [least, most] = [x.least, x.most].map(|time| seconds(to_two_digits(time)));
        let rest = WIDTH - least.len();
        writeln!(out, "          {least}{most:>rest$}")?;
        writeln!(out, "          {across:>WIDTH$}")
    }
}

fn to_two_digits(number: f64) -> f64 {
    format!("{number:.1e}").parse().unwrap_or(number)
}

/// Cell of a share from 0 to 1.
fn cell_at(share: f64, cells: usize) -> usize {
    #[expect(clippy::cast_precision_loss, reason = "a few cells")]
    let scaled = share * (cells - 1) as f64;
    #[expect(clippy::cast_possible_truncation, reason = "a few cells")]
    #[expect(clippy::cast_sign_loss, reason = "not negative")]
    let cell = scaled.round().max(0.0) as usize;
    cell.min(cells - 1)
}
