//! Which rungs are worth choosing.

use super::Measured;
use crate::measure::Timing;

/// Tells each rung which other is better, if one is: no slower, no less accurate, and better in one of
/// that. A difference of times within their deviations is none, nor is one of errors within the `doubt`
/// of the reference. Of those that are better the fastest is named, which is itself on the front; of several
/// as fast, the first.
pub(super) fn mark(rungs: &mut [Measured], doubt: f64) {
    let places = rungs.iter();
    let places: Vec<_> = places.map(|rung| (rung.cpu, rung.deviation.rmse)).collect();
    for (rung, better) in better(&places, doubt).into_iter().enumerate() {
        rungs[rung].dominated_by = better.map(|better| rungs[better].label.clone());
    }
}

/// For each rung the one on the front that is better, if any is.
///
/// What nobody can tell apart makes no chain: of three rungs the first may be like the second and that
/// like the third, and the third worse than the first. So a rung is on the front if none on the front is
/// better.
fn better(places: &[(Timing, f64)], doubt: f64) -> Vec<Option<usize>> {
    let beats = |one: usize, other: usize| beats(places[one], places[other], doubt);
    let mut open: Vec<_> = (0..places.len()).collect();
    let mut front: Vec<usize> = Vec::new();
    // Noise may make a ring of rungs of which each beats the next; the most accurate opens it.
    let next = |open: &[usize]| {
        open.iter().copied().min_by(|one, other| {
            let key = |rung: usize| (open.iter().any(|by| beats(*by, rung)), places[rung]);
            let [
                (beaten, (time, error)),
                (other_beaten, (other_time, other_error)),
            ] = [*one, *other].map(key);
            let by_error = error.total_cmp(&other_error);
            let by_time = time.median.total_cmp(&other_time.median);
            beaten.cmp(&other_beaten).then(by_error).then(by_time)
        })
    };
    while let Some(best) = next(&open) {
        front.push(best);
        open.retain(|rung| *rung != best && !beats(best, *rung));
    }
    let named = (0..places.len()).map(|rung| {
        let is_on_front = front.contains(&rung);
        let dominating = front.iter().copied();
        let dominating = dominating.filter(|on| !is_on_front && beats(*on, rung));
        let time = |rung: usize| places[rung].0;
        let fastest = dominating
            .clone()
            .min_by(|one, other| time(*one).median.total_cmp(&time(*other).median))?;
        dominating
            .filter(|rung| time(*rung).may_be(time(fastest)))
            .min()
    });
    named.collect()
}

/// Whether the first of two is no slower, no less accurate, and better in one of that.
fn beats(
    (time, error): (Timing, f64),
    (other_time, other_error): (Timing, f64),
    doubt: f64,
) -> bool {
    let as_fast = time.may_be(other_time);
    let as_accurate = (error - other_error).abs() <= doubt;
    let no_slower = as_fast || time.median < other_time.median;
    let no_less_accurate = as_accurate || error < other_error;
    no_slower && no_less_accurate && !(as_fast && as_accurate)
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
            better(&places, 0.0),
            [None, None, Some(1), Some(1), None, Some(0), None],
            "twins do not dominate each other"
        );
    }

    #[test]
    fn noise_beats_nobody() {
        let runs = [[1.0, 1.1, 1.2], [1.05, 1.15, 1.25]];
        let places = runs.map(|runs| (Timing::of(&runs), 0.1));
        assert_eq!(better(&places, 0.0), [None, None]);
        let slow = [places[0], (Timing::of(&[2.0, 2.1, 2.2]), 0.1)];
        assert_eq!(better(&slow, 0.0), [None, Some(0)]);
        let once = [1.0, 1.01].map(|time| (Timing::of(&[time]), 0.1));
        assert_eq!(better(&once, 0.0), [None, None], "a single run is no surer");
    }

    #[test]
    fn what_is_as_fast_and_more_accurate_is_better() {
        let places = [[1.0, 0.2], [1.01, 0.1]].map(|[time, error]| (Timing::of(&[time]), error));
        assert_eq!(better(&places, 0.0), [Some(1), None]);
    }

    #[test]
    fn what_is_named_is_on_the_front() {
        // Each is as fast as the next and more accurate, but the first is slower than the last.
        let places = [[1.03, 0.1], [1.015, 0.2], [1.0, 0.3]];
        let places = places.map(|[time, error]| (Timing::of(&[time]), error));
        assert_eq!(better(&places, 0.0), [None, Some(0), None]);
        // Both first ones are better than the last.
        let places = [[1.0, 0.3], [2.0, 0.1], [3.0, 0.4]];
        let places = places.map(|[time, error]| (Timing::of(&[time]), error));
        assert_eq!(better(&places, 0.0), [None, None, Some(0)]);
    }

    #[test]
    fn errors_closer_than_the_doubt_beat_nobody() {
        let of = |places: &[[f64; 2]], doubt| {
            let places = places.iter();
            let places: Vec<_> = places
                .map(|[time, error]| (Timing::of(&[*time]), *error))
                .collect();
            better(&places, doubt)
        };
        let near = [[2.0, 0.1], [1.0, 0.11], [1.01, 0.105]];
        assert_eq!(of(&near, 0.0), [None, Some(2), None]);
        assert_eq!(of(&near, 0.02), [Some(1), None, None], "the cheaper one");
        // Each is beaten by the next, which is faster and nearly as accurate; the first is told from
        // the third.
        let chain = [[3.0, 0.1], [2.0, 0.11], [1.0, 0.12]];
        assert_eq!(of(&chain, 0.015), [None, Some(2), None]);
        let far = [[1.0, 0.1], [1.0, 0.13]];
        assert_eq!(of(&far, 0.02), [None, Some(0)]);
    }

    #[test]
    fn of_several_as_fast_the_first_is_named() {
        let places = [[1.01, 0.1], [1.0, 0.1], [1.5, 0.09], [2.0, 0.1]];
        let places = places.map(|[time, error]| (Timing::of(&[time]), error));
        assert_eq!(better(&places, 0.0), [None, None, None, Some(0)]);
    }

    #[test]
    fn a_ring_of_noise_has_a_front() {
        // Each of the first four is faster than the next, and as accurate; the fourth is more accurate
        // than the last, and that than the first, and as fast, for nobody knows how fast it is.
        let ring = [
            ([1.0, 1.0], 0.022),
            ([2.0, 2.0], 0.0125),
            ([3.0, 3.0], 0.003),
            ([4.0, 4.0], 0.0),
            ([0.5, 4.5], 0.011),
        ];
        let places = ring.map(|(runs, error)| (Timing::of(&runs), error));
        let beaten = [1, 2, 3, 4, 0];
        for (rung, other) in beaten.into_iter().enumerate() {
            assert!(beats(places[rung], places[other], 0.01), "{rung}");
        }
        let expected = [None, Some(0), None, None, Some(3)];
        assert_eq!(better(&places, 0.01), expected);
    }
}
