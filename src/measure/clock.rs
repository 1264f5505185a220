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

/// A time as it is told in a sentence: three digits, and milliseconds below one second.
pub(super) fn in_words(seconds: f64) -> String {
    let (number, unit) = if seconds < 0.9995 {
        (1000.0 * seconds, "ms")
    } else {
        (seconds, "s")
    };
    match number {
        tiny if tiny < 0.9995 => format!("{tiny:.3} {unit}"),
        small if small < 9.995 => format!("{small:.2} {unit}"),
        middle if middle < 99.95 => format!("{middle:.1} {unit}"),
        large => format!("{large:.0} {unit}"),
    }
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
