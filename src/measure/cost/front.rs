//! Pareto front of accuracy and time.

use super::measurement::Measurement;
use crate::measure::Timing;

/// Time and error of a step.
#[derive(Debug, Clone, Copy)]
struct Point {
    time: Timing,
    error: f64,
}

/// Names for each step another one that dominates it: no slower, no less accurate, and better in one.
///
/// Times within their deviations count as equal, and errors within the `noise` of the reference. Of
/// those that dominate a step the fastest is named, of several as fast the first.
pub(super) fn mark(steps: &mut [Measurement], noise: f64) {
    let points: Vec<_> = steps
        .iter()
        .map(|step| Point {
            time: step.cpu,
            error: step.deviation.rmse,
        })
        .collect();
    for (step, by) in dominating(&points, noise).into_iter().enumerate() {
        steps[step].dominated_by = by.map(|by| steps[by].label.clone());
    }
}

/// For each point one on the front that dominates it, if any does.
fn dominating(points: &[Point], noise: f64) -> Vec<Option<usize>> {
    // Equality within noise is not transitive: the first of three may equal the second and that the
    // third, and the third be worse than the first. So a point is on the front if none on it
    // dominates it. Noise may even make a ring of points of which each dominates the next; the most
    // accurate opens it.
    let dominates = |one: usize, other: usize| points[one].dominates(points[other], noise);
    let mut open: Vec<_> = (0..points.len()).collect();
    let mut front: Vec<usize> = Vec::new();
    let next = |open: &[usize]| {
        open.iter().copied().min_by(|one, other| {
            let is_dominated = |it: usize| open.iter().any(|by| dominates(*by, it));
            let [a, b] = [one, other].map(|it| points[*it]);
            (is_dominated(*one).cmp(&is_dominated(*other)))
                .then(a.error.total_cmp(&b.error))
                .then(a.time.median.total_cmp(&b.time.median))
        })
    };
    while let Some(best) = next(&open) {
        front.push(best);
        open.retain(|it| *it != best && !dominates(best, *it));
    }
    let time = |it: usize| points[it].time;
    let named = (0..points.len()).map(|it| {
        let is_on_front = front.contains(&it);
        let all = front.iter().copied();
        let all: Vec<_> = all
            .filter(|by| !is_on_front && dominates(*by, it))
            .collect();
        let by_time =
            |one: &usize, other: &usize| time(*one).median.total_cmp(&time(*other).median);
        let fastest = all.iter().copied().min_by(by_time)?;
        all.into_iter()
            .filter(|by| time(*by).may_be(time(fastest)))
            .min()
    });
    named.collect()
}

impl Point {
    /// True if it is no slower, no less accurate, and better in one of them.
    fn dominates(self, other: Self, noise: f64) -> bool {
        let as_fast = self.time.may_be(other.time);
        let as_accurate = (self.error - other.error).abs() <= noise;
        let no_slower = as_fast || self.time.median < other.time.median;
        let no_less_accurate = as_accurate || self.error < other.error;
        no_slower && no_less_accurate && !(as_fast && as_accurate)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point([time, error]: [f64; 2]) -> Point {
        several(&[time], error)
    }

    fn several(runs: &[f64], error: f64) -> Point {
        let time = Timing::of(runs);
        Point { time, error }
    }

    #[test]
    fn the_front_has_what_nothing_dominates() {
        // Time and error.
        let places = [
            [1.0, 0.5],
            [2.0, 0.2],
            [2.0, 0.3],
            [3.0, 0.2],
            [4.0, 0.1],
            [5.0, 0.9],
            [1.0, 0.5],
        ]
        .map(point);
        assert_eq!(
            dominating(&places, 0.0),
            [None, None, Some(1), Some(1), None, Some(0), None],
            "twins do not dominate each other"
        );
    }

    #[test]
    fn noise_dominates_nothing() {
        let runs = [[1.0, 1.1, 1.2], [1.05, 1.15, 1.25]];
        let places = runs.map(|runs| several(&runs, 0.1));
        assert_eq!(dominating(&places, 0.0), [None, None]);
        let slow = [places[0], several(&[2.0, 2.1, 2.2], 0.1)];
        assert_eq!(dominating(&slow, 0.0), [None, Some(0)]);
        let once = [1.0, 1.01].map(|time| point([time, 0.1]));
        assert_eq!(
            dominating(&once, 0.0),
            [None, None],
            "a single run is no surer"
        );
    }

    #[test]
    fn what_is_as_fast_and_more_accurate_is_better() {
        let places = [[1.0, 0.2], [1.01, 0.1]].map(point);
        assert_eq!(dominating(&places, 0.0), [Some(1), None]);
    }

    #[test]
    fn what_is_named_is_on_the_front() {
        // Each is as fast as the next and more accurate, but the first is slower than the last.
        let places = [[1.03, 0.1], [1.015, 0.2], [1.0, 0.3]];
        let places = places.map(point);
        assert_eq!(dominating(&places, 0.0), [None, Some(0), None]);
        // Both first ones are better than the last.
        let places = [[1.0, 0.3], [2.0, 0.1], [3.0, 0.4]];
        let places = places.map(point);
        assert_eq!(dominating(&places, 0.0), [None, None, Some(0)]);
    }

    #[test]
    fn errors_closer_than_the_noise_dominate_nothing() {
        let of = |places: &[[f64; 2]], noise| {
            let places: Vec<_> = places.iter().map(|place| point(*place)).collect();
            dominating(&places, noise)
        };
        let near = [[2.0, 0.1], [1.0, 0.11], [1.01, 0.105]];
        assert_eq!(of(&near, 0.0), [None, Some(2), None]);
        assert_eq!(of(&near, 0.02), [Some(1), None, None], "the cheaper one");
        // Each is dominated by the next, which is faster and nearly as accurate; the first differs
        // from the third.
        let chain = [[3.0, 0.1], [2.0, 0.11], [1.0, 0.12]];
        assert_eq!(of(&chain, 0.015), [None, Some(2), None]);
        let far = [[1.0, 0.1], [1.0, 0.13]];
        assert_eq!(of(&far, 0.02), [None, Some(0)]);
    }

    #[test]
    fn of_several_as_fast_the_first_is_named() {
        let places = [[1.01, 0.1], [1.0, 0.1], [1.5, 0.09], [2.0, 0.1]];
        let places = places.map(point);
        assert_eq!(dominating(&places, 0.0), [None, None, None, Some(0)]);
    }

    #[test]
    fn a_ring_of_noise_has_a_front() {
        // Each of the first four is faster than the next, and as accurate; the fourth is more accurate
        // than the last, and that than the first, and as fast, since its times differ by far.
        let ring = [
            ([1.0, 1.0], 0.022),
            ([2.0, 2.0], 0.0125),
            ([3.0, 3.0], 0.003),
            ([4.0, 4.0], 0.0),
            ([0.5, 4.5], 0.011),
        ];
        let places = ring.map(|(runs, error)| several(&runs, error));
        let dominated = [1, 2, 3, 4, 0];
        for (step, other) in dominated.into_iter().enumerate() {
            assert!(places[step].dominates(places[other], 0.01), "{step}");
        }
        let expected = [None, Some(0), None, None, Some(3)];
        assert_eq!(dominating(&places, 0.01), expected);
    }
}
