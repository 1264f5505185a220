//! How long something takes.

use std::time::Instant;

use cpu_time::{ProcessTime, ThreadTime};
use serde::Serialize;

/// What the same work took in several runs, in seconds.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Timing {
    /// The median of the runs.
    pub median: f64,
    /// The median of how far the runs are from that; `None` of a single run.
    pub deviation: Option<f64>,
}

/// The share of a time up to which nobody can tell it from another.
const SETTLED: f64 = 0.02;

impl Timing {
    /// What these runs took, in seconds; zero without any.
    #[must_use]
    pub fn of(runs: &[f64]) -> Self {
        let median = median_of(runs.to_vec());
        let far = runs.iter().map(|run| (run - median).abs());
        Self {
            median,
            deviation: (runs.len() > 1).then(|| median_of(far.collect())),
        }
    }

    /// How many times as long this is as another.
    #[must_use]
    pub fn over(self, other: Self) -> f64 {
        self.median / other.median
    }

    /// Whether more runs would tell little: the deviation is known and no more than a fiftieth.
    #[must_use]
    pub fn has_settled(self) -> bool {
        let deviation = self.deviation;
        deviation.is_some_and(|deviation| deviation <= SETTLED * self.median)
    }

    /// Whether this and another are no further apart than their deviations, or than a fiftieth, for a
    /// few runs may agree by chance; not known of a single run.
    #[must_use]
    pub fn is_like(self, other: Self) -> bool {
        let known = self.deviation.is_some() && other.deviation.is_some();
        known && self.may_be(other)
    }

    /// Whether nobody can tell this and another apart: as [`is_like`](Self::is_like), and of single runs
    /// if they are no further apart than a fiftieth.
    #[must_use]
    pub fn may_be(self, other: Self) -> bool {
        let deviations = [self, other].map(|timing| timing.deviation.unwrap_or(0.0));
        let least = SETTLED * self.median.min(other.median);
        (self.median - other.median).abs() <= least.max(deviations[0] + deviations[1])
    }
}

/// Does some work and tells how many seconds a processor spent on it in this thread; what others do
/// on the machine does not count.
pub(super) fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = ThreadTime::now();
    let done = work();
    (start.elapsed().as_secs_f64(), done)
}

/// Does some work and tells how many seconds all processors together spent on it, in all threads of
/// this process, and how many seconds went by.
pub(super) fn timed_in_all_threads<T>(work: impl FnOnce() -> T) -> ([f64; 2], T) {
    let (cpu, wall) = (ProcessTime::now(), Instant::now());
    let done = work();
    let seconds = [cpu.elapsed(), wall.elapsed()].map(|time| time.as_secs_f64());
    (seconds, done)
}

/// A unit of time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unit {
    /// What it is called.
    pub(super) word: &'static str,
    /// How long it is.
    pub(super) seconds: f64,
}

impl Unit {
    /// The unit for a time: seconds from one second on, milliseconds from a tenth of one on.
    pub(super) fn of(seconds: f64) -> Self {
        let (word, seconds) = match seconds {
            long if long >= 0.999_5 => ("s", 1.0),
            middle if middle >= 0.000_099_95 => ("ms", 1e-3),
            _ => ("µs", 1e-6),
        };
        Self { word, seconds }
    }
}

/// A time as it is told in a sentence.
pub(super) fn in_words(seconds: f64) -> String {
    let unit = Unit::of(seconds);
    format!("{} {}", three_digits(seconds / unit.seconds), unit.word)
}

/// A number to three digits, or more before the point.
pub(super) fn three_digits(number: f64) -> String {
    format!("{number:.*}", decimals(number))
}

/// How many digits after the point make three of a number, or more before it.
pub(super) fn decimals(number: f64) -> usize {
    let rounded = format!("{number:.2e}");
    let exponent: Option<i32> = rounded.split_once('e').and_then(|(_, it)| it.parse().ok());
    usize::try_from(2 - exponent.unwrap_or(0)).unwrap_or(0)
}

fn median_of(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    match values.get(middle) {
        None => 0.0,
        Some(upper) if values.len() % 2 == 1 => *upper,
        Some(upper) => f64::midpoint(values[middle - 1], *upper),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_slow_run_counts_for_little() {
        let timing = Timing::of(&[5.0, 1.0, 3.0, 2.0, 900.0]);
        assert_eq!((timing.median, timing.deviation), (3.0, Some(2.0)));
        let timing = Timing::of(&[1.0, 2.0, 4.0, 8.0]);
        assert_eq!((timing.median, timing.deviation), (3.0, Some(1.5)));
        assert_eq!(Timing::of(&[]).median, 0.0);
        let single = Timing::of(&[2.0]);
        assert_eq!((single.median, single.deviation), (2.0, None));
        assert!(!single.is_like(single), "nobody knows");
    }

    #[test]
    fn a_time_is_told_with_three_digits() {
        for (seconds, expected) in [
            (0.000_000_5, "0.500 µs"),
            (0.000_012_34, "12.3 µs"),
            (0.000_099_96, "0.100 ms"),
            (0.000_308_1, "0.308 ms"),
            (0.003_081, "3.08 ms"),
            (0.009_996, "10.0 ms"),
            (0.068_24, "68.2 ms"),
            (0.099_96, "100 ms"),
            (0.629_4, "629 ms"),
            (0.999_6, "1.00 s"),
            (1.594, "1.59 s"),
            (12.34, "12.3 s"),
            (99.96, "100 s"),
            (1234.0, "1234 s"),
        ] {
            assert_eq!(in_words(seconds), expected);
        }
    }

    #[test]
    fn a_timing_settles_when_its_runs_agree() {
        assert!(!Timing::of(&[]).has_settled());
        assert!(!Timing::of(&[1.0]).has_settled(), "nobody knows");
        assert!(Timing::of(&[1.0, 1.03]).has_settled());
        assert!(!Timing::of(&[1.0, 1.05]).has_settled());
        assert!(Timing::of(&[1.0, 1.05, 1.01]).has_settled());
    }

    #[test]
    fn timings_are_alike_within_their_deviations() {
        let of = |median, deviation| Timing {
            median,
            deviation: Some(deviation),
        };
        assert!(of(3.0, 0.5).is_like(of(4.0, 0.5)));
        assert!(!of(3.0, 0.5).is_like(of(4.0, 0.25)));
        assert!(
            of(3.0, 0.0).is_like(of(3.05, 0.0)),
            "two runs agree by chance"
        );
        assert!(!of(3.0, 0.0).is_like(of(3.07, 0.0)));
    }
}
