//! What was measured, as comma-separated values and as curves.

use std::error::Error;

use heliodon::measure::Curve;

/// What goes wrong with files of values.
pub type Failed = Box<dyn Error + Send + Sync>;

/// Pairs of numbers that belong together.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// What is varied beside them.
    pub panel: String,
    /// What they are about.
    pub name: String,
    /// What is turned, and how wrong it is.
    pub points: Vec<[f64; 2]>,
}

impl Series {
    /// A series of numbers, rounded as they are written.
    pub fn new(panel: &str, name: &str, points: Vec<[f64; 2]>) -> Self {
        Self {
            panel: panel.to_owned(),
            name: name.to_owned(),
            points: points.into_iter().map(|it| it.map(rounded)).collect(),
        }
    }

    /// Its curve in a figure.
    pub fn curve(&self, hue: usize, label: String) -> Curve {
        Curve {
            label,
            hue,
            is_bound: false,
            points: self.points.clone(),
        }
    }
}

/// The number to five digits.
fn rounded(number: f64) -> f64 {
    format!("{number:.4e}").parse().unwrap_or(number)
}

/// The series as comma-separated values below a line with the names of the columns.
pub fn written(columns: [&str; 4], all: &[Series]) -> Result<String, Failed> {
    let mut lines = csv::Writer::from_writer(Vec::new());
    lines.write_record(columns)?;
    for series in all {
        for point in &series.points {
            let [x, y] = point.map(|number| number.to_string());
            lines.write_record([&series.panel, &series.name, &x, &y])?;
        }
    }
    Ok(String::from_utf8(lines.into_inner()?)?)
}

/// The series that a text of comma-separated values holds.
pub fn read(text: &str) -> Result<Vec<Series>, Failed> {
    let mut all: Vec<Series> = Vec::new();
    for record in csv::Reader::from_reader(text.as_bytes()).records() {
        let record = record?;
        let column = |number: usize| record.get(number).unwrap_or_default();
        let point = [column(2).parse()?, column(3).parse()?];
        let last = all.last_mut();
        match last.filter(|last| [&last.panel, &last.name] == [column(0), column(1)]) {
            Some(series) => series.points.push(point),
            None => all.push(Series::new(column(0), column(1), vec![point])),
        }
    }
    Ok(all)
}
