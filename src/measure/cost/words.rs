//! The cost of accuracy in sentences.

use super::{Best, Blame, Cost, Law, Measured, SurfaceShare, Trade};
use crate::measure::clock::in_words;

impl Cost {
    /// What the table comes to, a sentence a line.
    #[must_use]
    pub fn words(&self) -> String {
        let mut lines = vec![self.reference_words(), String::new()];
        lines.push(self.recommended.words("recommended"));
        lines.extend(self.laws.iter().map(|law| law.words(&self.rungs)));
        lines.extend(self.met_words());
        lines.extend(self.blames.iter().map(Blame::words));
        lines.join("\n") + "\n"
    }

    /// What the pictures were compared with.
    #[must_use]
    pub fn reference_words(&self) -> String {
        let about = &self.reference.about;
        match self.reference.doubt {
            None => format!("Reference: {about}; nobody knows how far it is off itself."),
            Some(doubt) => format!(
                "Reference: {about}; off itself by an RMSE of about {:.6}, and by {:.2} code \
                 values where its halves differ most. Rungs whose RMSE differ by no more are equally \
                 accurate.",
                doubt.rmse, doubt.largest
            ),
        }
    }

    /// How often each `max-error` was met, if there is one: of the dial's steps, or else of all rungs.
    #[must_use]
    pub fn met_words(&self) -> Option<String> {
        let of_rung = |rung: &Measured, step: &str| {
            let share = 100.0 * rung.met?;
            Some(format!("{share:.2} % ({step})"))
        };
        let rungs = self.rungs.iter();
        let steps = rungs.filter_map(|rung| of_rung(rung, &rung.own("max-error")?.step));
        let mut met: Vec<_> = steps.collect();
        if met.is_empty() {
            let rungs = self.rungs.iter();
            met = rungs
                .filter_map(|rung| of_rung(rung, &rung.label))
                .collect();
        }
        (!met.is_empty()).then(|| format!("max-error: met in {} of the pixels", met.join(", ")))
    }

    /// How the times were taken.
    #[must_use]
    pub fn runs_words(&self) -> String {
        let threads = match self.threads {
            1 => "1 thread".to_owned(),
            threads => format!("{threads} threads"),
        };
        let runs = || self.rungs.iter().map(|rung| rung.runs);
        let runs = match (runs().min().unwrap_or(1), runs().max().unwrap_or(1)) {
            (_, 1) => return format!("one run on {threads}"),
            (least, most) if least < most => format!("{least} to {most}"),
            (_, most) => most.to_string(),
        };
        let times = self.rungs.iter().map(|rung| rung.cpu);
        let far = times.filter_map(|time| Some(time.deviation? / time.median));
        let far = far.fold(0.0, f64::max);
        format!(
            "medians of {runs} runs on {threads}, deviations up to {}",
            percent(far)
        )
    }
}

impl Best {
    /// The rung and why, after a word for it.
    #[must_use]
    pub fn words(&self, title: &str) -> String {
        format!("{title}: {}; {}", self.title(), self.why)
    }

    /// The rung's label, or that there is none.
    pub(super) fn title(&self) -> &str {
        self.label.as_deref().unwrap_or("none")
    }
}

impl Law {
    /// The law as a sentence.
    #[must_use]
    pub fn words(&self, rungs: &[Measured]) -> String {
        let dial = self.dial;
        match self.trade {
            Trade::Power {
                of_time,
                of_value,
                halving,
            } => format!(
                "{dial}: half the error takes {halving:.2} times as long; error goes with time to \
                 the power of {of_time:.2}, and with {dial} to that of {of_value:.2}"
            ),
            Trade::Free => {
                let best = rungs.iter().find(|rung| rung.label == self.most_accurate);
                let step = best.and_then(|rung| rung.own(dial));
                let step = step.map_or("", |own| &own.step);
                format!(
                    "{dial}: as far as can be told its steps buy no accuracy for time; the most \
                     accurate is {step}"
                )
            }
            Trade::Words => {
                let steps = rungs.iter().filter_map(|rung| {
                    let own = rung.own(dial)?;
                    let error = match own.rmse {
                        tiny if tiny > 0.0 && tiny < 1e-4 => format!("{tiny:.1e}"),
                        error => format!("{error:.6}"),
                    };
                    let time = in_words(rung.cpu.median);
                    Some(format!("{} errs by {error} in {time}", own.step))
                });
                let steps: Vec<_> = steps.collect();
                format!("{dial}: by itself {}", steps.join(", "))
            }
        }
    }
}

impl Blame {
    /// What the dial is turned to where it errs, such as `samples=1`.
    pub(super) fn setting(&self) -> String {
        format!("{}={}", self.dial, self.step)
    }

    /// Where the dial errs as a sentence.
    #[must_use]
    pub fn words(&self) -> String {
        let mut text = format!("{} errs most", self.setting());
        let spots = self
            .spots
            .iter()
            .filter(|share| share.error >= 0.01)
            .take(3);
        for (number, share) in spots.enumerate() {
            let comma = if number == 0 { " " } else { ", " };
            let [error, pixels] = [share.error, share.pixels].map(percent);
            let spot = share.spot;
            let of = if number == 0 {
                " of its squared error"
            } else {
                ""
            };
            let all = if number == 0 { " of all pixels" } else { "" };
            text += &format!("{comma}{} ({error}{of} in {pixels}{all})", spot.words());
        }
        if let Some(SurfaceShare { title, error }) = &self.surface {
            text += &format!("; {} on {title}", percent(*error));
        }
        let [column, row] = self.worst;
        text + &format!("; worst at pixel {column},{row}")
    }
}

/// A share of all as percents.
pub(super) fn percent(share: f64) -> String {
    match 100.0 * share {
        0.0 => "0 %".to_owned(),
        tiny if tiny < 0.01 => "< 0.01 %".to_owned(),
        some if some < 10.0 => format!("{some:.2} %"),
        some => format!("{some:.1} %"),
    }
}
