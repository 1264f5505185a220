//! The cost of accuracy as comma-separated values.

use super::Cost;

/// The columns. Times are in seconds, `max` in code values, `off` and `met` are shares of the pixels.
pub(super) const COLUMNS: [&str; 22] = [
    "rung",
    "dial",
    "value",
    "runs",
    "cpu",
    "cpu_mad",
    "wall",
    "wall_mad",
    "rays",
    "hit_tests",
    "occlusion_tests",
    "texel_fetches",
    "max",
    "off",
    "met",
    "rmse",
    "own_rmse",
    "psnr",
    "ssim",
    "flip",
    "efficiency",
    "dominated_by",
];

impl Cost {
    /// A line for each rung, after one with the names of the columns; what there is not is empty.
    ///
    /// # Errors
    /// Whatever the writer fails with.
    pub fn write_csv(&self, out: &mut dyn std::io::Write) -> std::io::Result<()> {
        let mut lines = csv::Writer::from_writer(out);
        lines.write_record(COLUMNS)?;
        for rung in &self.rungs {
            let number = |number: Option<f64>| number.map_or(String::new(), |it| it.to_string());
            let own = rung.dial.and_then(|dial| rung.own(dial));
            lines.write_record([
                rung.label.clone(),
                rung.dial.unwrap_or_default().to_owned(),
                number(rung.value),
                rung.runs.to_string(),
                rung.cpu.median.to_string(),
                number(rung.cpu.deviation),
                rung.wall.median.to_string(),
                number(rung.wall.deviation),
                rung.rays.to_string(),
                rung.counts.hit_tests.to_string(),
                rung.counts.occlusion_tests.to_string(),
                rung.counts.texel_fetches.to_string(),
                rung.deviation.change.largest.to_string(),
                rung.deviation.change.pixels.to_string(),
                number(rung.met),
                rung.deviation.rmse.to_string(),
                number(own.map(|own| own.rmse)),
                number(rung.deviation.psnr),
                rung.deviation.ssim.to_string(),
                rung.deviation.flip.to_string(),
                number(rung.efficiency),
                rung.dominated_by.clone().unwrap_or_default(),
            ])?;
        }
        lines.flush()
    }
}
