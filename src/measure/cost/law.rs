//! Error of a setting as a function of time.

use serde::Serialize;

use super::choice::most_accurate;
use super::measurement::Measurement;
use super::varied::VARIED;
use crate::measure::Timing;
use crate::scene::SettingKind;

/// Relation of the own error of a setting and its time.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Law {
    /// The setting.
    pub setting: &'static str,
    /// Label of the step with the least own error, the cheapest of those that cannot be told apart.
    pub most_accurate: String,
    /// Relation of error and time.
    pub trade: Trade,
}

/// Relation of the own error of a setting and its time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Trade {
    /// Error falls as a power of the time.
    Power {
        /// Exponent of the time; below zero.
        of_time: f64,
        /// Exponent of the setting's value.
        of_value: f64,
        /// Ratio of times of a picture with half the error.
        halving: f64,
    },
    /// More accuracy takes no measurable time.
    Free,
    /// The values are words, and follow no law.
    Words,
}

/// A step of a setting that takes a number; all above zero.
#[derive(Debug, Clone, Copy)]
struct Point {
    time: Timing,
    value: f64,
    error: f64,
}

/// Ratio of times, within their deviations, up to which they count as equal.
const ALIKE: f64 = 1.1;

/// The same ratio of times of a single run, whose deviations are unknown.
const ALIKE_ONCE: f64 = 1.5;

/// Laws of all settings that are varied alone; `noise` is the RMSE of the reference.
pub(super) fn all(steps: &[Measurement], noise: f64) -> Vec<Law> {
    let is_varied = |kind: &&SettingKind| {
        let mut varied = steps.iter().filter(|step| step.setting.is_some());
        varied.any(|step| step.own(kind.word).is_some())
    };
    let varied = VARIED.into_iter().filter(is_varied);
    varied.filter_map(|kind| law(kind, steps, noise)).collect()
}

fn law(kind: &SettingKind, steps: &[Measurement], noise: f64) -> Option<Law> {
    let own = steps
        .iter()
        .filter_map(|step| Some((step, step.own(kind.word)?)));
    let own: Vec<_> = own.collect();
    // The noise of the reference is in errors against it alone.
    let noise = if kind.by_reference { noise } else { 0.0 };
    let best = most_accurate(own.iter().map(|(step, own)| (*step, own.rmse)), noise)?;
    let points = own.iter().filter_map(|(step, own)| {
        let (time, value, error) = (step.cpu, own.value?, own.rmse);
        let numbers = [time.median, value, error];
        let point = Point { time, value, error };
        numbers.iter().all(|it| *it > 0.0).then_some(point)
    });
    let points: Vec<_> = points.collect();
    Some(Law {
        setting: kind.word,
        most_accurate: best.label.clone(),
        trade: if own.iter().any(|(_, own)| own.value.is_none()) {
            Trade::Words
        } else {
            trade(&points, noise)
        },
    })
}

/// Fits powers to points whose errors cannot be told apart within the noise.
fn trade(points: &[Point], noise: f64) -> Trade {
    let against = |x: fn(&Point) -> f64| exponent(points.iter().map(|it| [x(it), it.error]));
    match [against(|it| it.time.median), against(|it| it.value)] {
        [Some(of_time), Some(of_value)] if of_time < 0.0 && differ(points, noise) => Trade::Power {
            of_time,
            of_value,
            halving: libm::exp2(-1.0 / of_time),
        },
        _ => Trade::Free,
    }
}

/// True if errors differ by more than the noise, and the extreme times by more than their
/// deviations.
fn differ(points: &[Point], noise: f64) -> bool {
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
    is_longer && errors().fold(0.0, f64::max) - least > noise
}

/// Exponent `p` of the best fit `y ∝ x^p` of points `[x, y]`, by least squares of their logarithms.
///
/// All numbers have to be above zero; `None` of fewer than two different `x`.
#[must_use]
pub fn exponent(points: impl Iterator<Item = [f64; 2]>) -> Option<f64> {
    let points: Vec<_> = points.map(|point| point.map(libm::log)).collect();
    #[expect(clippy::cast_precision_loss, reason = "a few points")]
    let count = points.len() as f64;
    let [x, y] = [0, 1].map(|axis| points.iter().map(|point| point[axis]).sum::<f64>() / count);
    let from_mean = points.iter().map(|point| [point[0] - x, point[1] - y]);
    let spread: f64 = from_mean.clone().map(|[x, _]| x * x).sum();
    let together: f64 = from_mean.map(|[x, y]| x * y).sum();
    (spread > 0.0).then(|| together / spread)
}

#[cfg(test)]
mod tests {
    use super::super::attribution::OwnError;
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
        let trade = |points: &[[f64; 3]], noise| {
            let points = points.iter().map(|it| point(*it, Some(0.0)));
            trade(&points.collect::<Vec<_>>(), noise)
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
        assert_eq!(trade(&near, 0.02), Trade::Free, "within the noise");
        assert_ne!(trade(&near, 0.005), Trade::Free);
    }

    /// Steps of a setting: its value if that is a number, the time, and its own error.
    fn steps<const N: usize>(steps: [(Option<f64>, f64, f64); N]) -> [Measurement; N] {
        steps.map(|(value, seconds, rmse)| Measurement {
            own: vec![OwnError {
                setting: "samples",
                text: format!("{value:?}"),
                value,
                rmse,
            }],
            // Its error against the reference is of no account.
            ..Measurement::example(&format!("{value:?} {seconds}"), seconds, 0.5)
        })
    }

    fn samples() -> &'static SettingKind {
        SettingKind::varied("samples").expect("a setting")
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
        let pattern = SettingKind::varied("pattern").expect("a setting");
        assert_eq!(super::law(pattern, &steps, 0.0), None, "it was not varied");
    }

    #[test]
    fn words_follow_no_law() {
        let steps = steps([(Some(1.0), 1.0, 0.4), (None, 4.0, 0.1)]);
        let law = law(samples(), &steps, 0.0).expect("a law");
        assert_eq!(law.trade, Trade::Words);
    }
}
