//! How long something takes.

use cpu_time::ThreadTime;
use serde::Serialize;

/// What the same work took in several runs, in seconds.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Timing {
    /// The median of the runs.
    pub median: f64,
    /// The median of how far the runs are from that.
    pub deviation: f64,
}

impl Timing {
    /// What these runs took, in seconds; zero without any.
    #[must_use]
    pub fn of(runs: &[f64]) -> Self {
        let median = median_of(runs.to_vec());
        let far = runs.iter().map(|run| (run - median).abs());
        Self {
            median,
            deviation: median_of(far.collect()),
        }
    }

    /// How many times as long this is as another.
    #[must_use]
    pub fn over(self, other: Self) -> f64 {
        self.median / other.median
    }

    /// Whether this and another are no further apart than runs of each are from each other.
    #[must_use]
    pub fn is_like(self, other: Self) -> bool {
        (self.median - other.median).abs() <= self.deviation + other.deviation
    }
}

/// Does some work and tells how many seconds a processor spent on it in this thread; what others do
/// on the machine does not count.
pub(super) fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = ThreadTime::now();
    let done = work();
    (start.elapsed().as_secs_f64(), done)
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
        assert_eq!((timing.median, timing.deviation), (3.0, 2.0));
        let timing = Timing::of(&[1.0, 2.0, 4.0, 8.0]);
        assert_eq!((timing.median, timing.deviation), (3.0, 1.5));
        assert_eq!(Timing::of(&[]).median, 0.0);
    }

    #[test]
    fn timings_are_alike_within_their_deviations() {
        let of = |median, deviation| Timing { median, deviation };
        assert!(of(3.0, 0.5).is_like(of(4.0, 0.5)));
        assert!(!of(3.0, 0.5).is_like(of(4.0, 0.25)));
    }
}
