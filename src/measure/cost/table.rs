//! The cost of accuracy as text.

use std::fmt;
use std::fmt::Write;

use super::{Best, Blame, Cost, Law, Measured, SurfaceShare, Trade, chart};
use crate::measure::Timing;
use crate::measure::clock::in_words;

/// The names of the columns of the table.
const COLUMNS: [&str; 11] = [
    "rung",
    "cpu",
    "wall",
    "rays",
    "max",
    "off",
    "RMSE",
    "PSNR",
    "SSIM",
    "FLIP",
    "better is",
];

impl fmt::Display for Cost {
    /// The table of rungs, the plot in characters, and both in words.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (rows, chart, words) = (self.rows(), chart::chart(self), self.words());
        write!(out, "{rows}\n{chart}\n{words}")
    }
}

impl Cost {
    /// A table with a row for each rung. In its last column stands the letter of the rung that is
    /// better, or that the rung is on the Pareto front.
    #[must_use]
    pub fn rows(&self) -> String {
        let mut rows = vec![COLUMNS.map(str::to_owned)];
        rows.extend(self.rungs.iter().map(|rung| self.cells(rung)));
        let widest = |column: usize| rows.iter().map(|row| row[column].chars().count()).max();
        let widths: [_; COLUMNS.len()] = std::array::from_fn(|column| widest(column).unwrap_or(0));
        let mut text = String::new();
        for (letter, [label, numbers @ .., better]) in
            std::iter::once(' ').chain(chart::letters()).zip(&rows)
        {
            // Writing to a String cannot fail.
            let _ = write!(text, "  {letter} {label:<wide$}", wide = widths[0]);
            for (number, wide) in numbers.iter().zip(&widths[1..]) {
                let _ = write!(text, "  {number:>wide$}");
            }
            let _ = writeln!(text, "  {better}");
        }
        text
    }

    /// A rung's row.
    fn cells(&self, rung: &Measured) -> [String; COLUMNS.len()] {
        let [cpu, wall, rays, max, off, rmse, psnr, ssim, flip] = figures(rung);
        let (label, better) = (rung.label.clone(), self.better(rung));
        [
            label, cpu, wall, rays, max, off, rmse, psnr, ssim, flip, better,
        ]
    }

    /// The letter of the rung that is better than this one, or its label if there are not enough letters.
    fn better(&self, rung: &Measured) -> String {
        let Some(better) = &rung.dominated_by else {
            return "none".to_owned();
        };
        let letters = self.rungs.iter().zip(chart::letters());
        let found = letters.filter(|(rung, letter)| rung.label == *better && *letter != '+');
        let mut found = found.map(|(_, letter)| letter.to_string());
        found.next().unwrap_or_else(|| better.clone())
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
                 values where its halves differ most. Rungs whose RMSE differ by no more are equally \
                 accurate.",
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

/// The figures of a rung's row: processor time, time, rays, and how far it is off.
pub(super) fn figures(rung: &Measured) -> [String; 9] {
    let deviation = &rung.deviation;
    let psnr = deviation
        .psnr
        .map_or("–".to_owned(), |psnr| format!("{psnr:.1}"));
    [
        rung.cpu.to_string(),
        median(rung.wall),
        rung.rays.to_string(),
        format!("{:.2}", deviation.change.largest),
        percent(deviation.change.pixels),
        format!("{:.6}", deviation.rmse),
        psnr,
        format!("{:.4}", deviation.ssim),
        format!("{:.4}", deviation.flip),
    ]
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
                "{dial}: half the error takes {halving:.1} times as long; error goes with time to \
                 the power of {of_time:.2}, and with {dial} to that of {of_value:.2}"
            ),
            Trade::Free => {
                let best = rungs.iter().find(|rung| rung.label == self.most_accurate);
                let step = best.and_then(|rung| rung.own(dial));
                let step = step.map_or("", |own| &own.step);
                format!("{dial}: its steps buy no accuracy for time; the most accurate is {step}")
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
