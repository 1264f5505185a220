//! The cost of accuracy as a table.

use std::fmt;
use std::fmt::Write;

use super::{Cost, Measured, chart};
use crate::measure::Deviation;
use crate::measure::clock::{Unit, three_digits};

/// How wide a line is at most, as terminals are.
const WIDTH: usize = 80;

/// How long a label may be beside its figures; `texture-filter=anisotropic` is. A longer one has lines
/// of its own above them.
const LABEL: usize = 26;

/// How many figures there are of each rung.
const COLUMNS: usize = 7;

/// What stands above them.
const HEADS: [&str; COLUMNS] = ["cpu", "wall", "max", "off", "RMSE", "FLIP", "better"];

impl fmt::Display for Cost {
    /// The table of rungs, the plot in characters, and both in words.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (rows, chart, words) = (self.rows(), chart::chart(self), self.words());
        write!(out, "{rows}\n{chart}\n{words}")
    }
}

impl Cost {
    /// A table with a row for each rung, which fits into 80 columns. In its last column stands the letter
    /// of the rung that is better, or that the rung is on the Pareto front.
    #[must_use]
    pub fn rows(&self) -> String {
        let times = self.rungs.iter().flat_map(|rung| [rung.cpu, rung.wall]);
        let least = times.map(|time| time.median).min_by(f64::total_cmp);
        let unit = Unit::of(least.unwrap_or(1.0));
        let units = [unit.word, unit.word, "/255", "%", "", "", "is"];
        let mut rows = vec![Row::head("rung", HEADS), Row::head("", units)];
        let rungs = self.rungs.iter().zip(chart::names());
        rows.extend(rungs.map(|(rung, name)| Row {
            name,
            label: rung.label.clone(),
            cells: self.cells(rung, unit),
        }));
        let widest = |text: &dyn Fn(&Row) -> &str, most: usize| {
            let widths = rows.iter().map(|row| text(row).chars().count());
            widths.filter(|wide| *wide <= most).max().unwrap_or(0)
        };
        let name = widest(&|row| &row.name, WIDTH);
        let label = widest(&|row| &row.label, LABEL);
        let cells: [_; COLUMNS] =
            std::array::from_fn(|column| widest(&|row| &row.cells[column], WIDTH));
        let lines = rows.iter().flat_map(|row| row.lines(name, label, cells));
        lines
            .map(|line| line.trim_end().to_owned() + "\n")
            .collect()
    }

    /// The figures of a rung.
    fn cells(&self, rung: &Measured, unit: Unit) -> [String; COLUMNS] {
        let Deviation {
            change, rmse, flip, ..
        } = rung.deviation;
        let rmse = match rmse {
            0.0 => "0".to_owned(),
            tiny if tiny < 0.001 => format!("{tiny:.2e}"),
            some => format!("{some:.5}"),
        };
        [
            three_digits(rung.cpu.median / unit.seconds),
            three_digits(rung.wall.median / unit.seconds),
            brief(change.largest),
            brief(100.0 * change.pixels),
            rmse,
            format!("{flip:.4}"),
            self.better(rung),
        ]
    }

    /// The name in the table of the rung that is better than this one.
    fn better(&self, rung: &Measured) -> String {
        let mut others = self.rungs.iter().zip(chart::names());
        let better = others.find(|(other, _)| rung.dominated_by.as_ref() == Some(&other.label));
        better.map_or("none".to_owned(), |(_, name)| name)
    }
}

/// A row of the table.
struct Row {
    name: String,
    label: String,
    cells: [String; COLUMNS],
}

impl Row {
    fn head(label: &str, cells: [&str; COLUMNS]) -> Self {
        Self {
            name: String::new(),
            label: label.to_owned(),
            cells: cells.map(str::to_owned),
        }
    }

    /// The row's lines, with columns of these widths.
    fn lines(&self, name: usize, label: usize, cells: [usize; COLUMNS]) -> Vec<String> {
        let mut lines = vec![format!("{:<name$}", self.name)];
        let width = |text: &str| text.chars().count();
        for word in self.label.split(' ') {
            match lines.last_mut() {
                Some(line) if width(line) + 1 + width(word) <= WIDTH => {
                    line.push(' ');
                    line.push_str(word);
                }
                _ => lines.push(format!("{:name$} {word}", "")),
            }
        }
        if width(&self.label) > label {
            lines.push(String::new());
        }
        if let Some(last) = lines.last_mut() {
            *last = format!("{last:<wide$}", wide = name + 1 + label);
            let [numbers @ .., better] = &self.cells;
            for (number, wide) in numbers.iter().zip(cells) {
                // Writing to a String cannot fail.
                let _ = write!(last, "  {number:>wide$}");
            }
            let _ = write!(last, "  {better}");
        }
        lines
    }
}

/// A number to three digits, and two behind the point at most.
fn brief(number: f64) -> String {
    match number {
        0.0 => "0".to_owned(),
        tiny if tiny < 0.005 => "<0.01".to_owned(),
        small if small < 1.0 => format!("{small:.2}"),
        some => three_digits(some),
    }
}
