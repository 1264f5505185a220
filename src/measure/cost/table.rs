//! The cost of accuracy as text.

use std::fmt;
use std::fmt::Write;

use super::{Best, Blame, Cost, Law, Measured, SurfaceShare, Trade, chart};
use crate::measure::Timing;

impl fmt::Display for Cost {
    /// The table of rungs, the plot in characters, and both in words.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (rows, chart, words) = (self.rows(), chart::chart(self), self.words());
        write!(out, "{rows}\n{chart}\n{words}")
    }
}

impl Cost {
    /// A table with a row for each rung. In its last column stands which rung is better, or that
    /// the rung is on the Pareto front.
    #[must_use]
    pub fn rows(&self) -> String {
        let labels = self.rungs.iter().map(|rung| rung.label.chars().count());
        let wide = labels.max().unwrap_or(0).max(8);
        let mut text = format!(
            "    {:<wide$}{:>18}{:>10}{:>12}{:>8}{:>9}{:>10}{:>7}{:>8}{:>8}  {}\n",
            "rung", "cpu", "wall", "rays", "max", "off", "RMSE", "PSNR", "SSIM", "FLIP", "better is"
        );
        for (rung, letter) in self.rungs.iter().zip(chart::letters()) {
            let Measured { deviation, .. } = rung;
            let psnr = deviation
                .psnr
                .map_or("-".to_owned(), |psnr| format!("{psnr:.1}"));
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "  {letter} {:<wide$}{:>18}{:>10}{:>12}{:>8.2}{:>9}{:>10.6}{psnr:>7}{:>8.4}{:>8.4}  {}",
                rung.label,
                rung.cpu.to_string(),
                median(rung.wall),
                rung.rays,
                deviation.change.largest,
                percent(deviation.change.pixels),
                deviation.rmse,
                deviation.ssim,
                deviation.flip,
                rung.dominated_by.as_deref().unwrap_or("none"),
            );
        }
        text
    }

    /// What the table comes to, a sentence a line.
    #[must_use]
    pub fn words(&self) -> String {
        let mut lines = vec![self.reference_words(), String::new()];
        lines.push(self.recommended.words("recommended"));
        lines.extend(self.laws.iter().map(|law| law.words(&self.rungs)));
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
                 values at most.",
                doubt.rmse, doubt.largest
            ),
        }
    }

    /// How the times were taken.
    #[must_use]
    pub fn runs_words(&self) -> String {
        let threads = match self.threads {
            1 => "1 thread".to_owned(),
            threads => format!("{threads} threads"),
        };
        let runs = || self.rungs.iter().map(|rung| rung.runs);
        match (runs().min().unwrap_or(1), runs().max().unwrap_or(1)) {
            (_, 1) => format!("one run on {threads}"),
            (least, most) if least < most => {
                format!("medians of {least} to {most} runs on {threads}")
            }
            (_, most) => format!("medians of {most} runs on {threads}"),
        }
    }
}

impl Best {
    /// The rung and why, after a word for it.
    #[must_use]
    pub fn words(&self, title: &str) -> String {
        let label = self.label.as_deref().unwrap_or("none");
        format!("{title}: {label}; {}", self.why)
    }
}

impl Law {
    /// The law as a sentence.
    #[must_use]
    pub fn words(&self, rungs: &[Measured]) -> String {
        let (dial, best) = (self.dial, &self.most_accurate);
        match self.trade {
            Trade::Power {
                of_time,
                of_value,
                halving,
            } => format!(
                "{dial}: half the error takes {halving:.1} times as long; error goes with time to \
                 the power of {of_time:.2}, and with {dial} to that of {of_value:.2}"
            ),
            Trade::Free => {
                format!("{dial}: its steps buy no accuracy for time; the most accurate is {best:?}")
            }
            Trade::Words => {
                let steps = rungs.iter().filter_map(|rung| {
                    let own = rung.own(dial)?;
                    let error = match own.rmse {
                        tiny if tiny > 0.0 && tiny < 1e-4 => format!("{tiny:.1e}"),
                        error => format!("{error:.6}"),
                    };
                    let time = median(rung.cpu);
                    Some(format!("{} errs by {error} in {time}", rung.label))
                });
                let steps: Vec<_> = steps.collect();
                format!("{dial}: by itself {}", steps.join(", "))
            }
        }
    }
}

impl Blame {
    /// Where the dial errs as a sentence.
    #[must_use]
    pub fn words(&self) -> String {
        let mut text = format!("{} errs most", self.rung);
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

/// A median in milliseconds.
pub(super) fn median(timing: Timing) -> String {
    format!("{:.1} ms", 1000.0 * timing.median)
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
