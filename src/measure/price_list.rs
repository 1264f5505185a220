//! Costs of effects as text.

use std::fmt;

use super::prices::{Effort, Price, Prices};
use super::text::aligned;
use crate::language::joined;
use crate::measure::Timing;
use crate::plan::Effect;

/// Meaning of the columns of the list.
const LEGEND: &str = "  time     processor time of one thread
  ratio    time relative to the complete scene
  rays     rays of all kinds
  pixels   pixels that change by more than half a code value of 255
  largest  largest change of a channel, in code values of 255
";

impl fmt::Display for Prices {
    /// The list of effects with its legend, and the cost of simulating everything.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (list, everything) = (self.list(), self.everything_list());
        write!(out, "{list}\n{LEGEND}\n{everything}")
    }
}

impl Prices {
    /// Table and sentences about the scene without each effect.
    #[must_use]
    pub fn list(&self) -> String {
        let none = [String::new(), String::new(), String::new()];
        let row = |title: &str, effort: &Effort, [ratio, pixels, largest]: [String; 3]| {
            let (time, rays) = (effort.time.to_string(), effort.counts.rays().to_string());
            vec![format!("  {title}"), time, ratio, rays, pixels, largest]
        };
        let mut rows = vec![
            ["  without", "time", "ratio", "rays", "pixels", "largest"]
                .map(str::to_owned)
                .to_vec(),
            row("(nothing)", &self.whole, none),
        ];
        rows.extend(self.without.iter().map(|price| {
            let ratio = format!("× {:.2}", price.takes);
            let largest = format!("{:.1}", price.change.largest);
            let cells = [ratio, percent(price.change.pixels), largest];
            row(price.effect.title(), &price.effort, cells)
        }));
        let mut lines = aligned("<>>>>>", &rows);
        lines.push(String::new());
        lines.extend(self.without.iter().map(|price| price.in_words(&self.whole)));
        if self.without.is_empty() {
            lines.push("The scene calls for no effect.".to_owned());
        }
        lines.join("\n") + "\n"
    }

    /// Table and sentence about the scene with everything simulated.
    fn everything_list(&self) -> String {
        let heads = [
            "  simulated",
            "time",
            "ratio",
            "shadow rays",
            "tests",
            "tests / ray",
        ];
        let row = |title: &str, effort: &Effort, ratio: String| {
            let each = effort.tests_per_shadow_ray();
            vec![
                format!("  {title}"),
                effort.time.to_string(),
                ratio,
                effort.shadow_rays().to_string(),
                effort.counts.occlusion_tests.to_string(),
                each.map_or("-".to_owned(), |each| format!("{each:.2}")),
            ]
        };
        let ratio = self.everything.time.over(self.whole.time);
        let rows = [
            heads.map(str::to_owned).to_vec(),
            row("what is called for", &self.whole, String::new()),
            row("everything", &self.everything, format!("× {ratio:.2}")),
        ];
        let lines = aligned("<>>>>>", &rows).join("\n");
        let words = compared(self.everything.time, self.whole.time);
        format!("{lines}\n\nEverything simulated: {words}; the picture is the same.\n")
    }
}

impl Price {
    /// Saving and change as a sentence.
    fn in_words(&self, whole: &Effort) -> String {
        let gone = [&[self.effect], &self.also_off[..]].concat();
        let gone: Vec<_> = gone.into_iter().map(in_a_sentence).collect();
        let change = match self.change.pixels {
            0.0 => "no pixel changes".to_owned(),
            share => format!("{} of the pixels change", percent(share)),
        };
        let (gone, time) = (joined(&gone, "and"), compared(self.effort.time, whole.time));
        format!("Without {gone}: {time}; {change}.")
    }
}

/// A time relative to another; equal if the runs show no difference.
fn compared(this: Timing, other: Timing) -> String {
    let ratio = this.over(other);
    if this.is_like(other) {
        "as fast".to_owned()
    } else if ratio < 1.0 {
        format!("{:.0} % faster", 100.0 * (1.0 - ratio))
    } else if ratio < 2.0 {
        format!("{:.0} % slower", 100.0 * (ratio - 1.0))
    } else {
        format!("{ratio:.2} × the time")
    }
}

/// An effect with its article.
fn in_a_sentence(effect: Effect) -> String {
    let article = match effect {
        Effect::TransferCurve => "the ",
        _ => "",
    };
    article.to_owned() + effect.title()
}

/// A share in percent, to one digit behind the point.
fn percent(share: f64) -> String {
    match 100.0 * share {
        0.0 => "0 %".to_owned(),
        tiny if tiny < 0.1 => "< 0.1 %".to_owned(),
        some => format!("{some:.1} %"),
    }
}
