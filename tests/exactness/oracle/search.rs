//! Searches for the largest share of a bound that is ever used.

use super::equality::SEED;
use super::place::Place;
use support::random::Random;

/// A bound that is never used to more than this share would be too wide.
const LEAST_USE: f64 = 0.3;

/// Fails if a bound is exceeded, or if no large share of it is found to be used.
pub(super) fn is_used(what: &str, share: impl Fn(&Place) -> Option<f64>) {
    let found = largest(&share);
    println!("largest share of the error of {what}: {found}");
    assert!(
        found > LEAST_USE,
        "{what}: only {found} of the bound is ever used"
    );
}

/// Many places are changed for as long as their shares get larger; again and again the better half goes
/// on, and for twice as long.
fn largest(share: &impl Fn(&Place) -> Option<f64>) -> f64 {
    const CLIMBERS: u64 = 16;
    let mut climbers: Vec<_> = (0..CLIMBERS)
        .map(|seed| Climber::start(Random::of(SEED, seed), share))
        .collect();
    let mut steps = 300;
    loop {
        for climber in &mut climbers {
            climber.climb(steps, share);
        }
        climbers.sort_by(|one, other| other.share.total_cmp(&one.share));
        if climbers.len() == 1 {
            return climbers[0].share;
        }
        climbers.truncate(climbers.len() / 2);
        steps *= 2;
    }
}

/// A place, and the share that it uses.
#[derive(Debug)]
struct Climber {
    random: Random,
    place: Place,
    share: f64,
}

impl Climber {
    /// The best of some places.
    fn start(mut random: Random, share: &impl Fn(&Place) -> Option<f64>) -> Self {
        const STARTS: u64 = 50;
        let place = Place::any(&mut random);
        let mut climber = Self {
            random,
            place,
            share: 0.0,
        };
        for _ in 0..STARTS {
            let place = Place::any(&mut climber.random);
            climber.go_if_better(place, share);
        }
        climber
    }

    fn climb(&mut self, steps: u64, share: &impl Fn(&Place) -> Option<f64>) {
        for _ in 0..steps {
            let place = self.place.changed(&mut self.random);
            self.go_if_better(place, share);
        }
    }

    fn go_if_better(&mut self, place: Place, share: &impl Fn(&Place) -> Option<f64>) {
        let Some(share) = place.is_unit().then(|| share(&place)).flatten() else {
            return;
        };
        assert!(share <= 1.0, "{share} times the bound: {place:?}");
        if share > self.share {
            (self.share, self.place) = (share, place);
        }
    }
}
