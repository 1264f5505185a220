//! Results as a table of 80 columns.

use std::fmt;

use super::measurement::Measurement;
use super::run::Cost;
use crate::measure::plot::names;
use crate::measure::text::{Unit, aligned, three_digits, wrapped};

/// Longest label beside its figures, such as `texture-filter=anisotropic`; a longer one has lines of
/// its own above them.
const LABEL: usize = 26;

/// Meaning of the columns.
const LEGEND: &str = "\
cpu     processor time of all threads
wall    elapsed time
max     largest error of a channel, in code values of 255
off     pixels with an error above half a code value
RMSE    root mean square error; 1 is white
FLIP    perceived difference, from 0 (none) to 1 (Andersson et al. 2020)
better  a setting at least as fast and as accurate; none on the Pareto front
";

impl fmt::Display for Cost {
    /// Table, legend, plot in characters, and results in sentences.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}\n{LEGEND}\n{}\n", self.rows(), self.scatter())?;
        writeln!(out, "{}\n", wrapped(&self.reference_words(), ""))?;
        for line in self.words().lines() {
            // A choice stays in one line, as a program may look for it.
            if line.starts_with("recommended: ") {
                writeln!(out, "{line}")?;
            } else {
                writeln!(out, "{}", wrapped(line, "  "))?;
            }
        }
        Ok(())
    }
}

impl Cost {
    /// Table with a row for each step, in 80 columns; the last column has the letter of a step that
    /// dominates it.
    #[must_use]
    pub fn rows(&self) -> String {
        let times = self.steps.iter().flat_map(|step| [step.cpu, step.wall]);
        let least = times.map(|time| time.median).min_by(f64::total_cmp);
        let unit = Unit::of(least.unwrap_or(1.0));
        let steps = self.steps.iter().zip(names());
        let wide = names().take(self.steps.len()).map(|name| name.len()).max();
        let wide = wide.unwrap_or(1);
        let head = |text: &str| {
            let cells = text.split(',').map(str::to_owned).collect::<Vec<_>>();
            (String::new(), cells)
        };
        let indent = " ".repeat(wide + 1);
        let mut rows = vec![
            head(&format!(
                "{indent}setting,cpu,wall,max,off,RMSE,FLIP,better"
            )),
            head(&format!(",{0},{0},/255,%", unit.word)),
        ];
        rows.extend(steps.map(|(step, name)| {
            let title = format!("{name:wide$} {}", step.label);
            let mut cells = self.cells(step, unit).to_vec();
            let is_long = step.label.chars().count() > LABEL;
            let above = is_long.then(|| wrapped(&title, &indent) + "\n");
            cells.insert(0, if is_long { String::new() } else { title });
            (above.unwrap_or_default(), cells)
        }));
        let (above, rows): (Vec<_>, Vec<_>) = rows.into_iter().unzip();
        let lines = above.into_iter().zip(aligned("<>>>>>><", &rows));
        lines.map(|(above, line)| above + &line + "\n").collect()
    }

    /// Figures of a step.
    fn cells(&self, step: &Measurement, unit: Unit) -> [String; 7] {
        let deviation = &step.deviation;
        let rmse = match deviation.rmse {
            0.0 => "0".to_owned(),
            tiny if tiny < 0.001 => format!("{tiny:.2e}"),
            some => format!("{some:.5}"),
        };
        let mut all = self.steps.iter().zip(names());
        let better = all.find(|(other, _)| step.dominated_by.as_ref() == Some(&other.label));
        [
            three_digits(step.cpu.median / unit.seconds),
            three_digits(step.wall.median / unit.seconds),
            brief(deviation.change.largest),
            brief(100.0 * deviation.change.pixels),
            rmse,
            format!("{:.4}", deviation.flip),
            better.map_or("none".to_owned(), |(_, name)| name),
        ]
    }
}

/// A number to three digits, with two behind the point at most.
fn brief(number: f64) -> String {
    match number {
        0.0 => "0".to_owned(),
        tiny if tiny < 0.005 => "<0.01".to_owned(),
        small if small < 1.0 => format!("{small:.2}"),
        some => three_digits(some),
    }
}
