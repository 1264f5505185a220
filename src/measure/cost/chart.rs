//! Error against time as a plot in characters.

use std::fmt::Write;

use super::Cost;
use super::plot::axes;
use crate::measure::plot::seconds;

/// What each rung is called in the table: its letter, or its number if there is none left.
pub(super) fn names() -> impl Iterator<Item = String> {
    let numbered = letters().zip(1_usize..);
    numbered.map(|(letter, number)| match letter {
        '+' => number.to_string(),
        letter => letter.to_string(),
    })
}

/// The letter of each rung in the plot.
fn letters() -> impl Iterator<Item = char> {
    ('a'..='z').chain('A'..='Z').chain(std::iter::repeat('+'))
}

const WIDTH: usize = 64;
const HEIGHT: usize = 14;

/// The plot.
pub(super) fn chart(cost: &Cost) -> String {
    let [time, error] = axes(cost);
    let mut cells = [[' '; WIDTH]; HEIGHT];
    for (rung, letter) in cost.rungs.iter().zip(letters()) {
        let column = place(time.share(rung.cpu.median), WIDTH);
        let row = place(1.0 - error.share(rung.deviation.rmse), HEIGHT);
        let cell = &mut cells[row][column];
        // Of two rungs at one place the first is shown.
        if *cell == ' ' {
            *cell = letter;
        }
    }
    let mut text = "  RMSE\n".to_owned();
    for (row, cells) in cells.iter().enumerate() {
        let mark = match row {
            row if row + 1 == HEIGHT && error.is_zero() => "0".to_owned(),
            row if row + 1 == HEIGHT => format!("{:.0e}", error.least),
            0 if !error.is_zero() => format!("{:.0e}", error.most),
            _ => String::new(),
        };
        let cells: String = cells.iter().collect();
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  {mark:>6} │{}", cells.trim_end());
    }
    let [least, most] = [time.least, time.most].map(|time| seconds(to_two_digits(time)));
    let _ = writeln!(text, "         └{}", "─".repeat(WIDTH));
    let _ = writeln!(
        text,
        "          {least}{most:>rest$} cpu",
        rest = WIDTH - least.len()
    );
    text
}

/// The number to two digits.
fn to_two_digits(number: f64) -> f64 {
    format!("{number:.1e}").parse().unwrap_or(number)
}

/// The cell of a share from 0 to 1.
fn place(share: f64, cells: usize) -> usize {
    #[expect(clippy::cast_precision_loss, reason = "a few cells")]
    let scaled = share * (cells - 1) as f64;
    #[expect(clippy::cast_possible_truncation, reason = "a few cells")]
    #[expect(clippy::cast_sign_loss, reason = "not negative")]
    let cell = scaled.round().max(0.0) as usize;
    cell.min(cells - 1)
}
