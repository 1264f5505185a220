//! The prices of effects as text.

use std::fmt;
use std::fmt::Write;

use super::clock::decimals;
use super::{Effort, Price, Prices, Timing};
use crate::language::joined;
use crate::plan::Effect;

impl fmt::Display for Prices {
    /// The list of effects, what simulating everything costs, and both in words.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (list, elision) = (self.list(), self.elision());
        write!(out, "{list}\n{elision}")
    }
}

impl Prices {
    /// A table of what is switched off and what that saves and changes, and the table in words.
    #[must_use]
    pub fn list(&self) -> String {
        let mut text = format!(
            "  {:<15}{:>20}{:>9}{:>14}{:>11}{:>14}\n",
            "without", "time", "takes", "rays", "pixels", "by at most"
        );
        line(&mut text, "(as it is)", &self.whole, "", "", "");
        for price in &self.without {
            let takes = format!("× {:.2}", price.takes);
            let pixels = percent(price.change.pixels);
            let most = format!("{:.1} codes", price.change.largest);
            let title = price.effect.title();
            line(&mut text, title, &price.effort, &takes, &pixels, &most);
        }
        text.push('\n');
        for price in &self.without {
            text.push_str(&price.in_words(&self.whole));
            text.push('\n');
        }
        if self.without.is_empty() {
            text.push_str("The scene calls for no effect, so there is none to be switched off.\n");
        }
        text
    }

    /// A table of what simulating everything costs, and the table in words.
    #[must_use]
    pub fn elision(&self) -> String {
        let mut text = format!(
            "  {:<15}{:>20}{:>9}{:>14}{:>14}{:>8}\n",
            "simulated", "time", "takes", "shadow rays", "shadow tests", "a ray"
        );
        let takes = self.everything.time.over(self.whole.time);
        let rows = [
            ("called for", &self.whole, String::new()),
            ("everything", &self.everything, format!("× {takes:.2}")),
        ];
        for (what, effort, takes) in rows {
            let each = effort.tests_per_shadow_ray();
            let each = each.map_or_else(|| "-".to_owned(), |each| format!("{each:.2}"));
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "  {what:<15}{:>20}{takes:>9}{:>14}{:>14}{each:>8}",
                effort.time.to_string(),
                effort.shadow_rays(),
                effort.counts.occlusion_tests,
            );
        }
        let _ = writeln!(
            text,
            "\nSimulating everything {}, and the picture is the same.",
            how_long(self.everything.time, self.whole.time)
        );
        text
    }
}

impl Price {
    /// The price as a sentence.
    fn in_words(&self, whole: &Effort) -> String {
        let gone = [&[self.effect], &self.also_off[..]].concat();
        let gone: Vec<_> = gone.into_iter().map(in_a_sentence).collect();
        let change = match self.change.pixels {
            0.0 => "no pixel changes".to_owned(),
            share => format!("{} of its pixels change", percent(share)),
        };
        format!(
            "Without {} this picture {}; {change}.",
            joined(&gone, "and"),
            how_long(self.effort.time, whole.time)
        )
    }
}

impl fmt::Display for Timing {
    /// Median and deviation in milliseconds, to three digits of the median.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let median = 1000.0 * self.median;
        let decimals = decimals(median);
        write!(out, "{median:.decimals$}")?;
        if let Some(deviation) = self.deviation {
            write!(out, " ± {:.decimals$}", 1000.0 * deviation)?;
        }
        out.write_str(" ms")
    }
}

fn line(text: &mut String, title: &str, effort: &Effort, takes: &str, pixels: &str, most: &str) {
    let (time, rays) = (effort.time.to_string(), effort.counts.rays());
    let line = format!("  {title:<15}{time:>20}{takes:>9}{rays:>14}{pixels:>11}{most:>14}");
    text.push_str(line.trim_end());
    text.push('\n');
}

/// How long something takes beside something else; about as long if the runs show no difference.
fn how_long(this: Timing, other: Timing) -> String {
    if this.is_like(other) {
        return "takes about as long".to_owned();
    }
    format!("takes {:.2} times as long", this.over(other))
}

/// An effect as a sentence has it.
fn in_a_sentence(effect: Effect) -> String {
    let article = match effect {
        Effect::TransferCurve => "the ",
        _ => "",
    };
    article.to_owned() + effect.title()
}

fn percent(share: f64) -> String {
    match 100.0 * share {
        0.0 => "0 %".to_owned(),
        tiny if tiny < 0.1 => "< 0.1 %".to_owned(),
        some => format!("{some:.1} %"),
    }
}
