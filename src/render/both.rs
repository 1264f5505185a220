//! Two onlookers at once.

use std::iter::Sum;

use super::{Arrival, Errors, Probe, RayKind, Unfollowed};
use crate::math::{Decisions, Rgb};
use crate::surface::Hit;

/// Two onlookers, each of whom is told everything.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Both<A, B>(pub A, pub B);

impl<A: Probe, B: Probe> Probe for Both<A, B> {
    fn ray(&mut self, kind: RayKind, share: Rgb) {
        self.0.ray(kind, share);
        self.1.ray(kind, share);
    }

    fn not_followed(&mut self, kind: RayKind, why: Unfollowed) {
        self.0.not_followed(kind, why);
        self.1.not_followed(kind, why);
    }

    fn follows_errors(&self) -> bool {
        self.0.follows_errors() || self.1.follows_errors()
    }

    fn only_counts(&self) -> bool {
        self.0.only_counts() && self.1.only_counts()
    }

    fn met(&mut self, surface: usize, hit: &Hit, errors: Errors) {
        self.0.met(surface, hit, errors);
        self.1.met(surface, hit, errors);
    }

    fn light(&mut self, light: usize, arrival: Arrival) {
        self.0.light(light, arrival);
        self.1.light(light, arrival);
    }

    fn own_color(&mut self, color: Rgb, of_lamps: Rgb) {
        self.0.own_color(color, of_lamps);
        self.1.own_color(color, of_lamps);
    }

    fn own_share(&mut self, share: f64) {
        self.0.own_share(share);
        self.1.own_share(share);
    }

    fn came_back(&mut self, color: Rgb) {
        self.0.came_back(color);
        self.1.came_back(color);
    }

    fn hit_tests(&mut self, count: u64) {
        self.0.hit_tests(count);
        self.1.hit_tests(count);
    }

    fn occlusion_tests(&mut self, light: usize, count: u64) {
        self.0.occlusion_tests(light, count);
        self.1.occlusion_tests(light, count);
    }

    fn decisions(&mut self, decisions: Decisions) {
        self.0.decisions(decisions);
        self.1.decisions(decisions);
    }

    fn texel_fetches(&mut self, count: u64) {
        self.0.texel_fetches(count);
        self.1.texel_fetches(count);
    }
}

impl<A: Default + Sum, B: Default + Sum> Sum for Both<A, B> {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::default(), |sum, next| {
            Self(
                [sum.0, next.0].into_iter().sum(),
                [sum.1, next.1].into_iter().sum(),
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::{Certificate, Counts};

    #[test]
    fn both_are_told_everything() {
        let mut both = Both(Counts::default(), Both(Counts::default(), ()));
        both.ray(RayKind::Camera, Rgb::WHITE);
        both.ray(RayKind::Mirror, Rgb::WHITE);
        both.not_followed(RayKind::Mirror, Unfollowed::Capped(1.0));
        both.hit_tests(3);
        both.occlusion_tests(2, 5);
        both.texel_fetches(7);
        both.decisions(Decisions {
            exactly: 11,
            by_rule: 13,
        });
        let Both(first, Both(second, ())) = both;
        assert_eq!(first, second);
        assert_eq!(
            (first.rays(), first.capped_rays, first.hit_tests),
            (2, 1, 3)
        );
        assert_eq!((first.occlusion_tests_of(2), first.texel_fetches), (5, 7));
        assert_eq!(first.decisions.by_rule, 13);
        let certificate = Certificate::default;
        let twice = [&first, &second].map(|counts| Both(counts.clone(), certificate()));
        let twice: Both<Counts, Certificate> = twice.into_iter().sum();
        assert_eq!(twice.0.hit_tests, 6);
    }
}
