//! Which rungs are worth choosing.

use super::Measured;
use crate::measure::Timing;

/// Tells each rung which other is better, if one is: no slower, no less accurate, and better in one of
/// that. A difference of times within their deviations is none. Of those the fastest is named, which is
/// itself on the front.
pub(super) fn mark(rungs: &mut [Measured]) {
    let places = rungs.iter();
    let places: Vec<_> = places.map(|rung| (rung.cpu, rung.deviation.rmse)).collect();
    for (rung, better) in better(&places).into_iter().enumerate() {
        rungs[rung].dominated_by = better.map(|better| rungs[better].label.clone());
    }
}

/// For each rung the one on the front that is better, if any is.
///
/// Times that nobody can tell apart make no chain: of three of them the first may be like the second
/// and that like the third, and the third slower than the first. So a rung is on the front if none on
/// the front is better; what is better than a rung always comes before it here.
fn better(places: &[(Timing, f64)]) -> Vec<Option<usize>> {
    let mut order: Vec<_> = (0..places.len()).collect();
    order.sort_by(|one, other| {
        let [(time, error), (other_time, other_error)] = [places[*one], places[*other]];
        let by_error = error.total_cmp(&other_error);
        by_error.then(time.median.total_cmp(&other_time.median))
    });
    let mut better = vec![None; places.len()];
    let mut front: Vec<usize> = Vec::new();
    for rung in order {
        let dominating = front.iter().filter(|on| beats(places[**on], places[rung]));
        better[rung] = dominating
            .min_by(|one, other| places[**one].0.median.total_cmp(&places[**other].0.median))
            .copied();
        if better[rung].is_none() {
            front.push(rung);
        }
    }
    better
}

/// Whether the first of two is no slower, no less accurate, and better in one of that.
fn beats((time, error): (Timing, f64), (other_time, other_error): (Timing, f64)) -> bool {
    let alike = time.may_be(other_time);
    let no_slower = alike || time.median < other_time.median;
    no_slower && error <= other_error && (!alike || error < other_error)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_has_what_nothing_beats() {
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
        .map(|[time, error]| (Timing::of(&[time]), error));
        assert_eq!(
            better(&places),
            [None, None, Some(1), Some(1), None, Some(0), None],
            "twins do not dominate each other"
        );
    }

    #[test]
    fn noise_beats_nobody() {
        let runs = [[1.0, 1.1, 1.2], [1.05, 1.15, 1.25]];
        let places = runs.map(|runs| (Timing::of(&runs), 0.1));
        assert_eq!(better(&places), [None, None]);
        let slow = [places[0], (Timing::of(&[2.0, 2.1, 2.2]), 0.1)];
        assert_eq!(better(&slow), [None, Some(0)]);
        let once = [1.0, 1.01].map(|time| (Timing::of(&[time]), 0.1));
        assert_eq!(better(&once), [None, None], "a single run is no surer");
    }

    #[test]
    fn what_is_as_fast_and_more_accurate_is_better() {
        let places = [[1.0, 0.2], [1.01, 0.1]].map(|[time, error]| (Timing::of(&[time]), error));
        assert_eq!(better(&places), [Some(1), None]);
    }

    #[test]
    fn what_is_named_is_on_the_front() {
        // Each is as fast as the next and more accurate, but the first is slower than the last.
        let places = [[1.03, 0.1], [1.015, 0.2], [1.0, 0.3]];
        let places = places.map(|[time, error]| (Timing::of(&[time]), error));
        assert_eq!(better(&places), [None, Some(0), None]);
        // Both first ones are better than the last.
        let places = [[1.0, 0.3], [2.0, 0.1], [3.0, 0.4]];
        let places = places.map(|[time, error]| (Timing::of(&[time]), error));
        assert_eq!(better(&places), [None, None, Some(0)]);
    }
}
