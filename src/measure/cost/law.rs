//! What a dial buys for time.

use serde::Serialize;

use super::choice::most_accurate;
use super::{DIALS, Dial, Measured};
use crate::measure::Timing;

/// What a dial buys for time, by its own error.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Law {
    /// The dial.
    pub dial: &'static str,
    /// The rung whose own error is least, the cheapest of those that nobody can tell apart.
    pub most_accurate: String,
    /// How time and error go together.
    pub trade: Trade,
}

/// How the time that a dial takes and its own error go together.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Trade {
    /// Error falls as a power of the time.
    Power {
        /// The exponent of the time; below zero.
        of_time: f64,
        /// The exponent of the dial's number.
        of_value: f64,
        /// How many times as long a picture with half the error takes.
        halving: f64,
    },
    /// More accuracy takes no more time, as far as can be told.
    Free,
    /// The steps are words, and follow no law.
    Words,
}

/// A step of a dial that takes a number; all above zero.
#[derive(Debug, Clone, Copy)]
struct Point {
    time: Timing,
    value: f64,
    error: f64,
}

/// Steps whose times are this close, within their deviations, cost the same.
const ALIKE: f64 = 1.1;

/// The same of times that were taken once, whose deviations nobody knows.
const ALIKE_ONCE: f64 = 1.5;

/// The laws of all dials that were turned, if the reference is so far off itself.
pub(super) fn all(rungs: &[Measured], doubt: f64) -> Vec<Law> {
    let turned = DIALS.iter().filter(|dial| {
        let mut turned = rungs.iter().filter(|rung| rung.dial.is_some());
        turned.any(|rung| rung.own(dial.word).is_some())
    });
    turned.filter_map(|dial| law(dial, rungs, doubt)).collect()
}

fn law(dial: &Dial, rungs: &[Measured], doubt: f64) -> Option<Law> {
    let steps = rungs
        .iter()
        .filter_map(|rung| Some((rung, rung.own(dial.word)?)));
    let steps: Vec<_> = steps.collect();
    // What a picture is compared with to tell a dial's own error is not in doubt, but for the reference.
    let doubt = if dial.by_reference { doubt } else { 0.0 };
    let best = most_accurate(steps.iter().map(|(rung, own)| (*rung, own.rmse)), doubt)?;
    let points = steps.iter().filter_map(|(rung, own)| {
        let (time, value, error) = (rung.cpu, own.value?, own.rmse);
        let point = Point { time, value, error };
        let numbers = [time.median, value, error];
        numbers.iter().all(|it| *it > 0.0).then_some(point)
    });
    let points: Vec<_> = points.collect();
    let words = steps.iter().any(|(_, own)| own.value.is_none());
    Some(Law {
        dial: dial.word,
        most_accurate: best.label.clone(),
        trade: if words {
            Trade::Words
        } else {
            trade(&points, doubt)
        },
    })
}

/// How times, numbers and errors go together, if nobody can tell errors apart that differ by no more than
/// the doubt.
fn trade(points: &[Point], doubt: f64) -> Trade {
    let against = |x: fn(&Point) -> f64| exponent(points.iter().map(|it| [x(it), it.error]));
    let exponents = [against(|it| it.time.median), against(|it| it.value)];
    match exponents {
        [Some(of_time), Some(of_value)] if of_time < 0.0 && differ(points, doubt) => Trade::Power {
            of_time,
            of_value,
            halving: libm::exp2(-1.0 / of_time),
        },
        _ => Trade::Free,
    }
}

/// Whether errors differ by more than the doubt, and the longest time is longer than the shortest however
/// far both may be off.
fn differ(points: &[Point], doubt: f64) -> bool {
    let errors = || points.iter().map(|point| point.error);
    let least = errors().fold(f64::INFINITY, f64::min);
    let by_time = |one: &&Point, other: &&Point| one.time.median.total_cmp(&other.time.median);
    let ends = [points.iter().min_by(by_time), points.iter().max_by(by_time)];
    let [Some(shortest), Some(longest)] = ends.map(|end| end.map(|point| point.time)) else {
        return false;
    };
    let is_longer = match [shortest.deviation, longest.deviation] {
        [Some(short), Some(long)] => longest.median - long > ALIKE * (shortest.median + short),
        _ => longest.median > ALIKE_ONCE * shortest.median,
    };
    is_longer && errors().fold(0.0, f64::max) - least > doubt
}

/// The exponent of the power of the first numbers that fits the second ones best: least squares of
/// their logarithms. All have to be above zero; `None` of fewer than two different first ones.
#[must_use]
pub fn exponent(points: impl Iterator<Item = [f64; 2]>) -> Option<f64> {
    let points: Vec<_> = points.map(|point| point.map(libm::log)).collect();
    #[expect(clippy::cast_precision_loss, reason = "a few rungs")]
    let count = points.len() as f64;
    let mean = |axis: usize| points.iter().map(|point| point[axis]).sum::<f64>() / count;
    let [x, y] = [mean(0), mean(1)];
    let spread: f64 = points
        .iter()
        .map(|point| (point[0] - x) * (point[0] - x))
        .sum();
    let together: f64 = points
        .iter()
        .map(|point| (point[0] - x) * (point[1] - y))
        .sum();
    (spread > 0.0).then(|| together / spread)
}

#[cfg(test)]
mod tests {
    use super::super::measured::Own;
    use super::*;

    fn point([median, value, error]: [f64; 3], deviation: Option<f64>) -> Point {
        let time = Timing { median, deviation };
        Point { time, value, error }
    }

    #[test]
    fn a_law_needs_times_that_differ_however_far_they_are_off() {
        let is_told = |longest: f64, deviation| {
            let steps = [[10.0, 1.0, 0.1], [longest, 2.0, 0.05]];
            trade(&steps.map(|it| point(it, deviation)), 0.0) != Trade::Free
        };
        assert!(!is_told(11.0, Some(0.0)) && is_told(11.1, Some(0.0)));
        assert!(!is_told(14.0, Some(2.0)) && is_told(14.0, Some(1.0)));
        assert!(!is_told(15.0, None) && is_told(15.1, None), "once");
    }

    #[test]
    fn a_power_is_found_and_its_price_told() {
        // Twice the samples take twice the time and leave the error over the root of eight.
        let points = [1.0, 4.0, 16.0].map(|n: f64| [0.3 * n, n, 0.5 / (n * n * n).sqrt().sqrt()]);
        let points = points.map(|it| point(it, Some(0.0)));
        let Trade::Power {
            of_time,
            of_value,
            halving,
        } = trade(&points, 0.01)
        else {
            panic!("no power");
        };
        assert!((of_time + 0.75).abs() < 1e-9 && (of_value + 0.75).abs() < 1e-9);
        assert!((halving - 2.519_842).abs() < 1e-5, "{halving}");
    }

    #[test]
    fn what_takes_no_longer_is_free() {
        let alike = [[1.0, 0.1, 0.1], [1.05, 0.01, 0.01], [1.02, 0.001, 0.001]];
        let trade = |points: &[[f64; 3]], doubt| {
            let points = points.iter().map(|it| point(*it, Some(0.0)));
            trade(&points.collect::<Vec<_>>(), doubt)
        };
        assert_eq!(trade(&alike, 0.0), Trade::Free);
        assert_eq!(trade(&[], 0.0), Trade::Free);
        let worse = [[1.0, 1.0, 0.1], [2.0, 2.0, 0.2]];
        assert_eq!(
            trade(&worse, 0.0),
            Trade::Free,
            "longer and no more accurate"
        );
        let near = [[1.0, 1.0, 0.11], [2.0, 2.0, 0.1]];
        assert_eq!(
            trade(&near, 0.02),
            Trade::Free,
            "as far as anybody can tell"
        );
        assert_ne!(trade(&near, 0.005), Trade::Free);
    }

    /// Steps of a dial: what it is turned to if that is a number, the time, and the dial's own error.
    fn steps<const N: usize>(steps: [(Option<f64>, f64, f64); N]) -> [Measured; N] {
        steps.map(|(value, seconds, rmse)| Measured {
            own: vec![Own {
                dial: "samples",
                step: format!("{value:?}"),
                value,
                rmse,
            }],
            // Its error against the reference is of no account.
            ..Measured::example(&format!("{value:?} {seconds}"), seconds, 0.5)
        })
    }

    fn samples() -> &'static Dial {
        Dial::of("samples").expect("a dial")
    }

    #[test]
    fn a_law_is_that_of_the_own_errors_above_zero() {
        let steps = steps([
            (Some(1.0), 1.0, 0.4),
            (Some(2.0), 4.0, 0.1),
            (Some(3.0), 9.0, 0.0),
            (Some(4.0), 8.0, 0.0),
        ]);
        let law = law(samples(), &steps, 0.0).expect("a law");
        assert_eq!(law.most_accurate, "Some(4.0) 8");
        let Trade::Power {
            of_time, of_value, ..
        } = law.trade
        else {
            panic!("no power");
        };
        assert!((of_time + 1.0).abs() < 1e-9 && (of_value + 2.0).abs() < 1e-9);
        let pattern = Dial::of("pattern").expect("a dial");
        assert_eq!(super::law(pattern, &steps, 0.0), None, "it was not turned");
    }

    #[test]
    fn words_follow_no_law() {
        let steps = steps([(Some(1.0), 1.0, 0.4), (None, 4.0, 0.1)]);
        let law = law(samples(), &steps, 0.0).expect("a law");
        assert_eq!(law.trade, Trade::Words);
    }
}
