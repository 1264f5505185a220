//! Which rung to take.

use serde::Serialize;

use super::{Cost, Measured};
use crate::language::Range;
use crate::measure::clock::in_words;

/// What a limit is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Metric {
    /// The root mean square error; 1 is the largest code value.
    Rmse,
    /// The largest error in code values.
    Max,
    /// The share of the pixels that are off by more than half a code value.
    Off,
    /// The peak signal-to-noise ratio in decibels; more is better.
    Psnr,
    /// The structural similarity; more is better.
    Ssim,
    /// How different the pictures look, from 0 to 1.
    Flip,
}

/// How good a picture has to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    /// What is limited.
    pub metric: Metric,
    /// The worst that is good enough.
    pub value: f64,
}

/// A rung that is the best by some rule.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Best {
    /// What it is called; `None` if no rung meets the rule.
    pub label: Option<String>,
    /// The rule, and what it comes to, in words.
    pub why: String,
}

impl Metric {
    /// Their words, and the limits that a picture may have to keep to.
    const ALL: [(&'static str, Self, Range); 6] = [
        ("rmse", Self::Rmse, Range::Between(0.0, 1.0)),
        ("max", Self::Max, Range::Between(0.0, 255.0)),
        ("off", Self::Off, Range::Between(0.0, 1.0)),
        ("psnr", Self::Psnr, Range::NotNegative),
        ("ssim", Self::Ssim, Range::Between(0.0, 1.0)),
        ("flip", Self::Flip, Range::Between(0.0, 1.0)),
    ];
}

impl Limit {
    /// A limit such as `rmse=1e-3` or `max=1`.
    ///
    /// # Errors
    /// Tells what was expected.
    pub fn new(text: &str) -> Result<Self, String> {
        let parts = text.split_once('=');
        let (word, number) = parts.ok_or("expected a measure and its limit, such as rmse=1e-3")?;
        let known = Metric::ALL.iter().find(|(known, ..)| *known == word.trim());
        let (word, metric, range) = *known.ok_or_else(|| {
            let words = Metric::ALL.map(|(word, ..)| word).join(", ");
            format!("expected one of {words} before ={number}")
        })?;
        let value: Option<f64> = number.trim().parse().ok();
        let value = value
            .filter(|value| range.contains(*value))
            .ok_or_else(|| {
                let numbers = range.words("a", "number");
                format!("expected {numbers} after {word}=")
            })?;
        Ok(Self { metric, value })
    }

    /// Whether a rung is good enough.
    #[must_use]
    pub fn is_met(self, rung: &Measured) -> bool {
        let deviation = &rung.deviation;
        match self.metric {
            Metric::Rmse => deviation.rmse <= self.value,
            Metric::Max => deviation.change.largest <= self.value,
            Metric::Off => deviation.change.pixels <= self.value,
            Metric::Psnr => deviation.psnr.is_none_or(|psnr| psnr >= self.value),
            Metric::Ssim => deviation.ssim >= self.value,
            Metric::Flip => deviation.flip <= self.value,
        }
    }

    fn words(self) -> String {
        let value = self.value;
        match self.metric {
            Metric::Rmse => format!("an RMSE of at most {value}"),
            Metric::Max => format!("a largest error of at most {value} code values"),
            Metric::Off => format!("at most {value} of all pixels off by more than half a code"),
            Metric::Psnr => format!("a PSNR of at least {value} dB"),
            Metric::Ssim => format!("an SSIM of at least {value}"),
            Metric::Flip => format!("a FLIP of at most {value}"),
        }
    }
}

impl Cost {
    /// The rung that is good enough and takes the least processor time.
    #[must_use]
    pub fn cheapest(&self, limit: Limit) -> Best {
        let words = limit.words();
        match cheapest(&self.rungs, limit) {
            Some(rung) => Best {
                why: cheapest_words(rung, &words),
                label: Some(rung.label.clone()),
            },
            None => Best {
                label: None,
                why: format!("no rung has {words}"),
            },
        }
    }

    /// The most accurate rung that is drawn while no more than so many seconds go by.
    #[must_use]
    pub fn within(&self, budget: f64) -> Best {
        let doubt = self.reference.doubt.map_or(0.0, |doubt| doubt.rmse);
        match within(&self.rungs, budget, doubt) {
            Some(rung) => Best {
                label: Some(rung.label.clone()),
                why: format!(
                    "the most accurate within {budget} s on the clock takes {} and has an RMSE of {:.5}",
                    in_words(rung.wall.median),
                    rung.deviation.rmse
                ),
            },
            None => Best {
                label: None,
                why: format!("no rung takes {budget} s or less on the clock"),
            },
        }
    }
}

/// The cheapest rung whose root mean square error is one code value; if there is none, the most
/// accurate.
pub(super) fn recommended(rungs: &[Measured], doubt: f64) -> Best {
    let limit = Limit {
        metric: Metric::Rmse,
        value: 1.0 / 255.0,
    };
    if let Some(rung) = cheapest(rungs, limit) {
        return Best {
            label: Some(rung.label.clone()),
            why: cheapest_words(rung, "an RMSE of at most one code value"),
        };
    }
    let rungs = rungs.iter().map(|rung| (rung, rung.deviation.rmse));
    Best {
        label: most_accurate(rungs, doubt).map(|rung| rung.label.clone()),
        why: "no rung has an RMSE of at most one code value; this is the most accurate".to_owned(),
    }
}

fn cheapest_words(rung: &Measured, limit: &str) -> String {
    let time = in_words(rung.cpu.median);
    format!("the cheapest with {limit} takes {time} of processor time")
}

fn cheapest(rungs: &[Measured], limit: Limit) -> Option<&Measured> {
    first_as_fast(rungs.iter().filter(|rung| limit.is_met(rung)))
}

/// The rung that takes the least processor time; of several that nobody can tell from it, the first.
fn first_as_fast<'a>(
    mut rungs: impl Iterator<Item = &'a Measured> + Clone,
) -> Option<&'a Measured> {
    let times = rungs.clone().map(|rung| rung.cpu);
    let least = times.min_by(|one, other| one.median.total_cmp(&other.median))?;
    rungs.find(|rung| rung.cpu.may_be(least))
}

fn within(rungs: &[Measured], budget: f64, doubt: f64) -> Option<&Measured> {
    let fast = rungs.iter().filter(|rung| rung.wall.median <= budget);
    most_accurate(fast.map(|rung| (rung, rung.deviation.rmse)), doubt)
}

/// Of rungs with these errors, the cheapest of those that nobody can tell from the most accurate.
pub(super) fn most_accurate<'a>(
    rungs: impl Iterator<Item = (&'a Measured, f64)> + Clone,
    doubt: f64,
) -> Option<&'a Measured> {
    let errors = rungs.clone().map(|(_, error)| error);
    let least = errors.min_by(f64::total_cmp)?;
    let best = rungs.filter(|(_, error)| *error <= least + doubt);
    first_as_fast(best.map(|(rung, _)| rung))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rungs() -> [Measured; 4] {
        [
            Measured::example("slow", 4.0, 0.001),
            Measured::example("fast", 1.0, 0.1),
            Measured::example("perfect", 8.0, 0.0),
            Measured::example("middle", 2.0, 0.001),
        ]
    }

    #[test]
    fn the_cheapest_that_is_good_enough_is_named() {
        for (limit, expected) in [
            ("rmse=0.2", "fast"),
            ("rmse=0.1", "fast"),
            ("rmse=0.05", "middle"),
            ("rmse=0.0001", "perfect"),
            ("max=100", "fast"),
            ("max=99", "middle"),
            ("max=0.5", "perfect"),
            ("off=1", "fast"),
            ("off=0.5", "middle"),
            ("off=0", "perfect"),
            ("psnr=20", "fast"),
            ("psnr=21", "middle"),
            ("psnr=61", "perfect"),
            ("ssim=0.9", "fast"),
            ("ssim=0.91", "middle"),
            ("ssim=1", "perfect"),
            ("flip=0.1", "fast"),
            ("flip=0.09", "middle"),
            ("flip=0", "perfect"),
        ] {
            let rungs = rungs();
            let best = cheapest(&rungs, Limit::new(limit).expect("a limit"));
            assert_eq!(
                best.map(|rung| rung.label.as_str()),
                Some(expected),
                "{limit}"
            );
        }
        let [slow, ..] = rungs();
        assert!(cheapest(&[slow], Limit::new("ssim=1").expect("a limit")).is_none());
    }

    #[test]
    fn the_most_accurate_within_a_time_is_named() {
        for (budget, expected) in [
            (0.4, None),
            (0.5, Some("fast")),
            (1.9, Some("middle")),
            (3.0, Some("middle")),
            (4.0, Some("perfect")),
        ] {
            let rungs = rungs();
            let best = within(&rungs, budget, 0.0);
            assert_eq!(best.map(|rung| rung.label.as_str()), expected, "{budget}");
        }
    }

    #[test]
    fn of_errors_that_nobody_can_tell_apart_the_cheapest_is_named() {
        let rungs = [
            Measured::example("slow", 4.0, 0.0100),
            Measured::example("fast", 1.0, 0.0104),
            Measured::example("faster", 0.5, 0.0108),
        ];
        for (doubt, expected) in [(0.0, "slow"), (0.0005, "fast"), (0.001, "faster")] {
            let best = within(&rungs, 9.0, doubt).map(|rung| rung.label.as_str());
            assert_eq!(best, Some(expected), "{doubt}");
            let best = recommended(&rungs, doubt).label;
            assert_eq!(best.as_deref(), Some(expected), "{doubt}");
        }
    }

    #[test]
    fn of_rungs_that_are_as_fast_the_first_is_named() {
        let rungs = [
            Measured::example("slow", 2.0, 0.001),
            Measured::example("as it is", 1.01, 0.001),
            Measured::example("by chance", 1.0, 0.001),
        ];
        let limit = Limit::new("rmse=0.01").expect("a limit");
        let named = [cheapest(&rungs, limit), within(&rungs, 9.0, 0.0)];
        for best in named.map(|rung| rung.map(|rung| rung.label.as_str())) {
            assert_eq!(best, Some("as it is"));
        }
        assert_eq!(recommended(&rungs, 0.0).label.as_deref(), Some("as it is"));
    }

    #[test]
    fn an_error_of_one_code_value_is_recommended_or_else_the_least() {
        let [slow, fast, perfect, middle] = rungs();
        let code = Measured::example("one code value", 1.5, 1.0 / 255.0);
        let above = Measured::example("above", 1.2, 1.1 / 255.0);
        let best = recommended(
            &[slow, fast.clone(), perfect, middle, code, above.clone()],
            0.0,
        );
        assert_eq!(best.label.as_deref(), Some("one code value"));
        let best = recommended(&[fast, above], 0.0);
        assert_eq!(best.label.as_deref(), Some("above"));
        assert!(best.why.starts_with("no rung has"), "{}", best.why);
    }

    #[test]
    fn a_limit_is_a_measure_and_a_number() {
        let limit = Limit::new("max=1").expect("a limit");
        assert_eq!((limit.metric, limit.value), (Metric::Max, 1.0));
        for (text, expected) in [
            ("1e-3", "such as rmse=1e-3"),
            (
                "error=1",
                "expected one of rmse, max, off, psnr, ssim, flip",
            ),
            ("max=one", "a number"),
            ("rmse=-1", "expected a number from 0 to 1 after rmse="),
            ("max=NaN", "expected a number from 0 to 255 after max="),
            ("max=256", "expected a number from 0 to 255 after max="),
            ("off=200", "expected a number from 0 to 1 after off="),
            ("psnr=inf", "expected a number of 0 or more after psnr="),
            ("ssim=2", "expected a number from 0 to 1 after ssim="),
            ("flip=2", "expected a number from 0 to 1 after flip="),
        ] {
            let error = Limit::new(text).expect_err("no limit");
            assert!(error.contains(expected), "{text}: {error}");
        }
    }
}
