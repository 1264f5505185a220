//! Results in sentences.

use super::attribution::Breakdown;
use super::choice::Best;
use super::law::{Law, Trade};
use super::measurement::Measurement;
use super::run::Cost;
use crate::measure::text::{duration, percent};

/// Title of the relations of error and time.
const ERROR_AND_TIME: &str =
    "Own error of a setting: RMSE against the picture with that setting at its best";

/// Title of the places of errors.
const PLACES: &str =
    "Places of the errors of a setting: share of the squared error (of the pixels)";

impl Cost {
    /// Titles and lines about each setting; sections without lines are left out.
    pub(super) fn sections(&self) -> impl Iterator<Item = (&'static str, Vec<String>)> {
        let laws = self.laws.iter().map(|law| law.words(&self.steps));
        let laws = laws.chain(self.max_error_words()).collect();
        let places = self.breakdowns.iter().map(Breakdown::words).collect();
        let sections: [(_, Vec<_>); 2] = [(ERROR_AND_TIME, laws), (PLACES, places)];
        sections.into_iter().filter(|(_, lines)| !lines.is_empty())
    }

    /// Results beside the table in sentences, one a line.
    #[must_use]
    pub fn words(&self) -> String {
        let mut text = String::new();
        for (title, lines) in self.sections() {
            text += &format!("{title}\n{}\n\n", lines.join("\n"));
        }
        text + &self.recommended.words("recommended") + "\n"
    }

    /// Origin of the reference, and its own error.
    pub(super) fn reference_words(&self) -> String {
        let about = &self.reference.about;
        match self.reference.uncertainty {
            None => format!("Reference: {about}; its own error is unknown."),
            Some(own) => format!(
                "Reference: {about}. Its own error is estimated as half the difference of its \
                 halves: RMSE {:.6}, at most {:.2} code values. Settings whose RMSE differ by less \
                 count as equally accurate.",
                own.rmse, own.largest
            ),
        }
    }

    /// Share of the pixels that keep `max-error`: of the steps of that setting, else of all steps.
    #[must_use]
    pub fn max_error_words(&self) -> Option<String> {
        let shares = |name: &dyn Fn(&Measurement) -> Option<String>| -> Vec<_> {
            let named = |step: &Measurement| Some((100.0 * step.within_max_error?, name(step)?));
            let steps = self.steps.iter().filter_map(named);
            steps
                .map(|(share, name)| format!("{share:.2} % ({name})"))
                .collect()
        };
        let mut kept = shares(&|step| Some(step.own("max-error")?.text.clone()));
        if kept.is_empty() {
            kept = shares(&|step| Some(step.label.clone()));
        }
        let kept = (!kept.is_empty()).then(|| kept.join(", "))?;
        Some(format!("max-error: kept in {kept} of the pixels"))
    }

    /// Number of runs and threads, and how far times deviate.
    #[must_use]
    pub fn runs_words(&self) -> String {
        let threads = match self.threads {
            1 => "1 thread".to_owned(),
            threads => format!("{threads} threads"),
        };
        let runs = || self.steps.iter().map(|step| step.runs);
        let runs = match (runs().min().unwrap_or(1), runs().max().unwrap_or(1)) {
            (_, 1) => return format!("one run on {threads}"),
            (least, most) if least < most => format!("{least} to {most}"),
            (_, most) => most.to_string(),
        };
        let times = self.steps.iter().map(|step| step.cpu);
        let far = times.filter_map(|time| Some(time.deviation? / time.median));
        let far = percent(far.fold(0.0, f64::max));
        format!("medians of {runs} runs on {threads}, deviations up to {far}")
    }
}

impl Best {
    /// The choice after a title, with its reason.
    #[must_use]
    pub fn words(&self, title: &str) -> String {
        format!("{title}: {}; {}", self.title(), self.why)
    }

    /// The label of the step, or `none`.
    pub(super) fn title(&self) -> &str {
        self.label.as_deref().unwrap_or("none")
    }
}

impl Law {
    /// Relation of error and time after the name of the setting.
    fn words(&self, steps: &[Measurement]) -> String {
        let setting = self.setting;
        match self.trade {
            Trade::Power {
                of_time,
                of_value,
                halving,
            } => format!(
                "{setting}: half the error takes {halving:.2} × the time; \
                 error ∝ time^{of_time:.2} ∝ {setting}^{of_value:.2}"
            ),
            Trade::Free => {
                let best = steps.iter().find(|step| step.label == self.most_accurate);
                let best = best.and_then(|step| step.own(setting));
                let text = best.map_or("", |own| &own.text);
                format!(
                    "{setting}: no measurable trade of time for accuracy; most accurate: {text}"
                )
            }
            Trade::Words => {
                let values = steps.iter().filter_map(|step| {
                    let own = step.own(setting)?;
                    let error = match own.rmse {
                        0.0 => "0".to_owned(),
                        tiny if tiny < 1e-4 => format!("{tiny:.1e}"),
                        error => format!("{error:.6}"),
                    };
                    let time = duration(step.cpu.median);
                    Some(format!("{error} in {time} ({})", own.text))
                });
                let values: Vec<_> = values.collect();
                format!("{setting}: own error {}", values.join(", "))
            }
        }
    }
}

impl Breakdown {
    /// `Places` of the error after the setting and its value.
    fn words(&self) -> String {
        let shares = self.features.iter().filter(|share| share.error >= 0.01);
        let shares = shares.take(3).map(|share| {
            let [error, pixels] = [share.error, share.pixels].map(percent);
            format!("{error} {} ({pixels})", share.feature.words())
        });
        let mut parts = vec![shares.collect::<Vec<_>>().join(", ")];
        if let Some(surface) = &self.surface {
            parts.push(format!("{} on {}", percent(surface.error), surface.title));
        }
        let [column, row] = self.worst;
        parts.push(format!("worst pixel {column},{row}"));
        format!("{}={}: {}", self.setting, self.text, parts.join("; "))
    }
}
