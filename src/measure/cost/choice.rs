//! Choice of a step by accuracy or time.

use serde::Serialize;

use super::measurement::Measurement;
use crate::language::Range;
use crate::measure::Deviation;
use crate::measure::text::duration;

/// Least accuracy of a picture, such as an RMSE of at most 0.001.
#[derive(Debug, Clone, Copy)]
pub struct Limit {
    metric: &'static Metric,
    value: f64,
}

/// Measure of the error of a picture.
#[derive(Debug)]
struct Metric {
    word: &'static str,
    /// Limits that make sense.
    range: Range,
    /// Title, with the sign between it and a limit.
    title: &'static str,
    of: fn(&Deviation) -> f64,
    /// True if more is better.
    is_quality: bool,
}

const METRICS: [Metric; 6] = [
    error("rmse", 1.0, "RMSE ≤", |it| it.rmse),
    error("max", 255.0, "largest error in code values ≤", |it| {
        it.change.largest
    }),
    error("off", 1.0, "share of pixels off ≤", |it| it.change.pixels),
    Metric {
        range: Range::NotNegative,
        ..quality("psnr", "PSNR in dB ≥", |it| {
            it.psnr.unwrap_or(f64::INFINITY)
        })
    },
    quality("ssim", "SSIM ≥", |it| it.ssim),
    error("flip", 1.0, "FLIP ≤", |it| it.flip),
];

const fn error(
    word: &'static str,
    most: f64,
    title: &'static str,
    of: fn(&Deviation) -> f64,
) -> Metric {
    Metric {
        word,
        range: Range::Between(0.0, most),
        title,
        of,
        is_quality: false,
    }
}

const fn quality(word: &'static str, title: &'static str, of: fn(&Deviation) -> f64) -> Metric {
    Metric {
        is_quality: true,
        ..error(word, 1.0, title, of)
    }
}

impl Limit {
    /// Reads a limit such as `rmse=1e-3` or `max=1`.
    ///
    /// # Errors
    /// Returns what was expected instead.
    pub fn new(text: &str) -> Result<Self, String> {
        let parts = text.split_once('=');
        let (word, number) = parts.ok_or("expected a measure and its limit, such as rmse=1e-3")?;
        let metric = METRICS.iter().find(|metric| metric.word == word.trim());
        let metric = metric.ok_or_else(|| {
            let words: Vec<_> = METRICS.iter().map(|metric| metric.word).collect();
            format!("expected one of {} before ={number}", words.join(", "))
        })?;
        let value = number.trim().parse().ok();
        let value = value.filter(|value| metric.range.contains(*value));
        let value = value.ok_or_else(|| {
            let numbers = metric.range.words("a", "number");
            format!("expected {numbers} after {}=", metric.word)
        })?;
        Ok(Self { metric, value })
    }

    fn is_met(self, step: &Measurement) -> bool {
        let value = (self.metric.of)(&step.deviation);
        if self.metric.is_quality {
            value >= self.value
        } else {
            value <= self.value
        }
    }

    /// The limit as a formula.
    fn formula(self) -> String {
        format!("{} {}", self.metric.title, self.value)
    }
}

/// A step that is the best by some rule.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Best {
    /// Its label; `None` if no step meets the rule.
    pub label: Option<String>,
    /// The rule and its result in words.
    pub why: String,
}

impl Best {
    fn new(step: Option<&Measurement>, why: String) -> Self {
        Self {
            label: step.map(|step| step.label.clone()),
            why,
        }
    }
}

/// The accurate enough step with the least processor time.
pub(super) fn cheapest(steps: &[Measurement], limit: Limit) -> Best {
    let step = first_as_fast(steps.iter().filter(|step| limit.is_met(step)));
    let why = match step {
        Some(step) => cheapest_words(step, &limit.formula()),
        None => format!("no setting has {}", limit.formula()),
    };
    Best::new(step, why)
}

/// The most accurate step that takes at most `budget` seconds.
pub(super) fn within(steps: &[Measurement], budget: f64, noise: f64) -> Best {
    let fast = steps.iter().filter(|step| step.wall.median <= budget);
    let step = most_accurate(fast.map(|step| (step, step.deviation.rmse)), noise);
    let why = match step {
        Some(step) => {
            let (time, rmse) = (duration(step.wall.median), step.deviation.rmse);
            format!("most accurate within {budget} s: RMSE {rmse:.5} in {time}")
        }
        None => format!("no setting takes {budget} s or less"),
    };
    Best::new(step, why)
}

/// The cheapest step with an RMSE of at most one code value, else the most accurate.
pub(super) fn recommended(steps: &[Measurement], noise: f64) -> Best {
    const LIMIT: &str = "RMSE ≤ 1/255";
    let good = |step: &&Measurement| step.deviation.rmse <= 1.0 / 255.0;
    if let Some(step) = first_as_fast(steps.iter().filter(good)) {
        return Best::new(Some(step), cheapest_words(step, LIMIT));
    }
    let all = steps.iter().map(|step| (step, step.deviation.rmse));
    let why = format!("most accurate; no setting has {LIMIT}");
    Best::new(most_accurate(all, noise), why)
}

fn cheapest_words(step: &Measurement, limit: &str) -> String {
    let time = duration(step.cpu.median);
    format!("cheapest with {limit}: {time} of processor time")
}

/// The step with the least processor time; of several as fast, the first.
fn first_as_fast<'a>(
    mut steps: impl Iterator<Item = &'a Measurement> + Clone,
) -> Option<&'a Measurement> {
    let times = steps.clone().map(|step| step.cpu);
    let least = times.min_by(|one, other| one.median.total_cmp(&other.median))?;
    steps.find(|step| step.cpu.may_be(least))
}

/// The cheapest of the steps whose errors are within the noise of the least one.
pub(super) fn most_accurate<'a>(
    steps: impl Iterator<Item = (&'a Measurement, f64)> + Clone,
    noise: f64,
) -> Option<&'a Measurement> {
    let errors = steps.clone().map(|(_, error)| error);
    let least = errors.min_by(f64::total_cmp)?;
    let best = steps.filter(|(_, error)| *error <= least + noise);
    first_as_fast(best.map(|(step, _)| step))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn steps() -> [Measurement; 4] {
        [
            Measurement::example("slow", 4.0, 0.001),
            Measurement::example("fast", 1.0, 0.1),
            Measurement::example("perfect", 8.0, 0.0),
            Measurement::example("middle", 2.0, 0.001),
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
            let steps = steps();
            let best = cheapest(&steps, Limit::new(limit).expect("a limit")).label;
            assert_eq!(best.as_deref(), Some(expected), "{limit}");
        }
        let [slow, ..] = steps();
        let none = cheapest(&[slow], Limit::new("ssim=1").expect("a limit"));
        assert_eq!(none.label, None);
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
            let steps = steps();
            let best = within(&steps, budget, 0.0).label;
            assert_eq!(best.as_deref(), expected, "{budget}");
        }
    }

    #[test]
    fn of_errors_within_the_noise_the_cheapest_is_named() {
        let steps = [
            Measurement::example("slow", 4.0, 0.0100),
            Measurement::example("fast", 1.0, 0.0104),
            Measurement::example("faster", 0.5, 0.0108),
        ];
        for (noise, expected) in [(0.0, "slow"), (0.0005, "fast"), (0.001, "faster")] {
            for best in [within(&steps, 9.0, noise), recommended(&steps, noise)] {
                assert_eq!(best.label.as_deref(), Some(expected), "{noise}");
            }
        }
    }

    #[test]
    fn of_steps_that_are_as_fast_the_first_is_named() {
        let steps = [
            Measurement::example("slow", 2.0, 0.001),
            Measurement::example("as it is", 1.01, 0.001),
            Measurement::example("by chance", 1.0, 0.001),
        ];
        let limit = Limit::new("rmse=0.01").expect("a limit");
        let named = [cheapest(&steps, limit), within(&steps, 9.0, 0.0)];
        for best in named {
            assert_eq!(best.label.as_deref(), Some("as it is"));
        }
        assert_eq!(recommended(&steps, 0.0).label.as_deref(), Some("as it is"));
    }

    #[test]
    fn an_error_of_one_code_value_is_recommended_or_else_the_least() {
        let [slow, fast, perfect, middle] = steps();
        let code = Measurement::example("one code value", 1.5, 1.0 / 255.0);
        let above = Measurement::example("above", 1.2, 1.1 / 255.0);
        let best = recommended(
            &[slow, fast.clone(), perfect, middle, code, above.clone()],
            0.0,
        );
        assert_eq!(best.label.as_deref(), Some("one code value"));
        let best = recommended(&[fast, above], 0.0);
        assert_eq!(best.label.as_deref(), Some("above"));
        assert!(best.why.contains("no setting has"), "{}", best.why);
    }

    #[test]
    fn a_limit_is_a_measure_and_a_number() {
        let limit = Limit::new("max=1").expect("a limit");
        assert_eq!((limit.metric.word, limit.value), ("max", 1.0));
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
