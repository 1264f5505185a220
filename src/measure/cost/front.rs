//! Which rungs are worth choosing.

use super::Measured;
use crate::measure::Timing;

/// Tells each rung which other is better, if one is: at least as accurate, at least as fast, and
/// better in one of that. A difference of times within their deviations is none. Of those the
/// fastest is named, which is itself on the front.
pub(super) fn mark(rungs: &mut [Measured]) {
    let places = rungs.iter();
    let places: Vec<_> = places.map(|rung| (rung.cpu, rung.deviation.rmse)).collect();
    let better: Vec<_> = (0..places.len())
        .map(|rung| better(&places, rung))
        .collect();
    for (rung, better) in better.into_iter().enumerate() {
        rungs[rung].dominated_by = better.map(|better| rungs[better].label.clone());
    }
}

/// The rung on the front that is better than this one, if any is.
fn better(places: &[(Timing, f64)], rung: usize) -> Option<usize> {
    let dominates = |other: usize, rung: usize| {
        let ((time, error), (other_time, other_error)) = (places[rung], places[other]);
        let no_worse = other_time.median <= time.median && other_error <= error;
        let faster = other_time.median < time.median && !other_time.is_like(time);
        no_worse && (faster || other_error < error)
    };
    let on_front = |rung: usize| !(0..places.len()).any(|other| dominates(other, rung));
    let better = (0..places.len()).filter(|other| dominates(*other, rung) && on_front(*other));
    better.min_by(|one, other| places[*one].0.median.total_cmp(&places[*other].0.median))
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
        let better: Vec<_> = (0..places.len())
            .map(|rung| better(&places, rung))
            .collect();
        assert_eq!(
            better,
            [None, None, Some(1), Some(1), None, Some(0), None],
            "twins do not dominate each other"
        );
    }

    #[test]
    fn noise_beats_nobody() {
        let runs = [[1.0, 1.1, 1.2], [1.05, 1.15, 1.25]];
        let places = runs.map(|runs| (Timing::of(&runs), 0.1));
        assert_eq!([0, 1].map(|rung| better(&places, rung)), [None, None]);
        let slow = [places[0], (Timing::of(&[2.0, 2.1, 2.2]), 0.1)];
        assert_eq!(better(&slow, 1), Some(0));
    }
}
