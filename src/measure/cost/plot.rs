//! Results as a plot of error against time.

use super::measurement::Measurement;
use super::run::Cost;
use super::varied::VARIED;
use crate::measure::plot::{Dot, Scatter};
use crate::measure::text::{duration, percent};

impl Cost {
    /// The plot as an SVG file.
    #[must_use]
    pub fn plot(&self) -> String {
        self.scatter().svg()
    }

    /// RMSE of each step against its processor time.
    pub(super) fn scatter(&self) -> Scatter<'_> {
        let combined = self.steps.iter().filter(|step| step.setting.is_none());
        let no_setting = if combined.count() > 1 {
            "several settings"
        } else {
            "the scene as it is"
        };
        let dot = |step| dot(step, no_setting);
        Scatter {
            titles: ["processor time", "RMSE (1 = white)"],
            dots: self.steps.iter().map(dot).collect(),
            noise_floor: self.reference.uncertainty.map(|own| own.rmse),
        }
    }
}

fn dot<'a>(step: &'a Measurement, no_setting: &'a str) -> Dot<'a> {
    Dot {
        at: [step.cpu.median, step.deviation.rmse],
        // The colour tells the setting.
        name: step.own_of_varied().map_or(&step.label, |own| &own.text),
        group: step.setting.unwrap_or(no_setting),
        hue: hue(step),
        tooltip: tooltip(step),
        is_on_front: step.dominated_by.is_none(),
    }
}

/// Number of the colour of the setting that is varied.
pub(super) fn hue(step: &Measurement) -> Option<usize> {
    let mut varied = VARIED.iter();
    varied.position(|kind| Some(kind.word) == step.setting)
}

/// Results of a step in lines.
fn tooltip(step: &Measurement) -> String {
    let deviation = &step.deviation;
    let front = match &step.dominated_by {
        None => "on the Pareto front".to_owned(),
        Some(better) => format!("{better} is better"),
    };
    let others = step.own.iter();
    let others = others.filter(|own| step.setting.is_some_and(|it| it != own.setting));
    let others = others.map(|own| format!("\nalso {}={}", own.setting, own.text));
    format!(
        "{}{}\n{} of processor time\nRMSE {:.6}\nlargest error {:.2} code values\n\
         {} of the pixels off\nFLIP {:.4}\n{front}",
        step.label,
        others.collect::<String>(),
        duration(step.cpu.median),
        deviation.rmse,
        deviation.change.largest,
        percent(deviation.change.pixels),
        deviation.flip,
    )
}
