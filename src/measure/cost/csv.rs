//! Results as comma-separated values.

use super::measurement::Measurement;
use super::run::Cost;

/// Contents of a cell.
type Cell = fn(&Measurement) -> String;

/// Columns; times are in seconds, `max` in code values of 255, `off` and `met` shares of the pixels.
const COLUMNS: [(&str, Cell); 22] = [
    ("rung", |step| step.label.clone()),
    ("dial", |step| step.setting.unwrap_or_default().to_owned()),
    ("value", |step| number(step.value)),
    ("runs", |step| step.runs.to_string()),
    ("cpu", |step| step.cpu.median.to_string()),
    ("cpu_mad", |step| number(step.cpu.deviation)),
    ("wall", |step| step.wall.median.to_string()),
    ("wall_mad", |step| number(step.wall.deviation)),
    ("rays", |step| step.rays.to_string()),
    ("hit_tests", |step| step.counts.hit_tests.to_string()),
    ("occlusion_tests", |step| {
        step.counts.occlusion_tests.to_string()
    }),
    ("texel_fetches", |step| {
        step.counts.texel_fetches.to_string()
    }),
    ("max", |step| step.deviation.change.largest.to_string()),
    ("off", |step| step.deviation.change.pixels.to_string()),
    ("met", |step| number(step.within_max_error)),
    ("rmse", |step| step.deviation.rmse.to_string()),
    ("own_rmse", |step| {
        number(step.own_of_varied().map(|own| own.rmse))
    }),
    ("psnr", |step| number(step.deviation.psnr)),
    ("ssim", |step| step.deviation.ssim.to_string()),
    ("flip", |step| step.deviation.flip.to_string()),
    ("efficiency", |step| number(step.efficiency)),
    ("dominated_by", |step| {
        step.dominated_by.clone().unwrap_or_default()
    }),
];

/// A number, or nothing if there is none.
fn number(number: Option<f64>) -> String {
    number.map_or(String::new(), |it| it.to_string())
}

impl Cost {
    /// Writes a line with the names of the columns, and one for each step.
    ///
    /// # Errors
    /// Passes on the errors of the writer.
    pub fn write_csv(&self, out: &mut dyn std::io::Write) -> std::io::Result<()> {
        let mut lines = csv::Writer::from_writer(out);
        lines.write_record(COLUMNS.map(|(name, _)| name))?;
        for step in &self.steps {
            lines.write_record(COLUMNS.map(|(_, cell)| cell(step)))?;
        }
        lines.flush()
    }
}
