//! Two probes at once.

use std::iter::Sum;

use super::{Event, Probe};

/// Two probes, each of which observes every event.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Both<A, B>(pub A, pub B);

impl<A: Probe, B: Probe> Probe for Both<A, B> {
    #[inline(always)]
    fn on(&mut self, event: Event<'_>) {
        self.0.on(event);
        self.1.on(event);
    }

    fn follows_errors(&self) -> bool {
        self.0.follows_errors() || self.1.follows_errors()
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
    use crate::math::{Decisions, Rgb};
    use crate::render::{Certificate, Counts, RayKind, Unfollowed};

    #[test]
    fn both_observe_every_event() {
        let mut both = Both(Counts::default(), Both(Counts::default(), ()));
        both.on(Event::Ray(RayKind::Camera, Rgb::WHITE));
        both.on(Event::Ray(RayKind::Mirror, Rgb::WHITE));
        both.on(Event::NotFollowed(RayKind::Mirror, Unfollowed::Capped(1.0)));
        both.on(Event::HitTests(3));
        both.on(Event::OcclusionTests(2, 5));
        both.on(Event::TexelFetches(7));
        both.on(Event::Decisions(Decisions {
            exactly: 11,
            by_rule: 13,
        }));
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
