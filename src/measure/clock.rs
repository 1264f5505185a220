//! Time of repeated work.

use std::fmt;
use std::time::Instant;

use cpu_time::{ProcessTime, ThreadTime};
use serde::Serialize;

use super::text::decimals;

/// Time of the same work in several runs, in seconds.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Timing {
    /// Median of the runs.
    pub median: f64,
    /// Median absolute deviation from it; `None` of a single run.
    pub deviation: Option<f64>,
}

/// Relative difference of two times up to which they count as equal.
const SETTLED: f64 = 0.02;

impl Timing {
    /// Median and deviation of these runs, in seconds; zero without any.
    #[must_use]
    pub(super) fn of(runs: &[f64]) -> Self {
        let median = median_of(runs.to_vec());
        let far = runs.iter().map(|run| (run - median).abs());
        Self {
            median,
            deviation: (runs.len() > 1).then(|| median_of(far.collect())),
        }
    }

    /// Ratio of this time to another.
    #[must_use]
    pub fn over(self, other: Self) -> f64 {
        self.median / other.median
    }

    /// True if the runs agree within 2 %; false of fewer than two.
    pub(super) fn has_settled(self) -> bool {
        self.deviation
            .is_some_and(|deviation| deviation <= SETTLED * self.median)
    }

    /// True if two times differ by no more than their deviations, or than 2 %, since a few runs may
    /// agree by chance; false of single runs.
    pub(super) fn is_like(self, other: Self) -> bool {
        let known = self.deviation.is_some() && other.deviation.is_some();
        known && self.may_be(other)
    }

    /// As [`is_like`](Self::is_like), with a deviation of zero for a single run.
    pub(super) fn may_be(self, other: Self) -> bool {
        let deviations = [self, other].map(|timing| timing.deviation.unwrap_or(0.0));
        let least = SETTLED * self.median.min(other.median);
        (self.median - other.median).abs() <= least.max(deviations[0] + deviations[1])
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

/// Does some work and returns its processor time in this thread, in seconds; the load of the machine
/// does not count.
pub(super) fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = ThreadTime::now();
    let done = work();
    (start.elapsed().as_secs_f64(), done)
}

/// Does some work and returns the processor time of all threads of the process and the elapsed time,
/// in seconds.
pub(super) fn timed_in_all_threads<T>(work: impl FnOnce() -> T) -> ([f64; 2], T) {
    let (cpu, wall) = (ProcessTime::now(), Instant::now());
    let done = work();
    let seconds = [cpu.elapsed(), wall.elapsed()].map(|time| time.as_secs_f64());
    (seconds, done)
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
        assert!(!single.is_like(single), "of a single run");
    }

    #[test]
    fn a_timing_settles_when_its_runs_agree() {
        assert!(!Timing::of(&[]).has_settled());
        assert!(!Timing::of(&[1.0]).has_settled(), "of a single run");
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
