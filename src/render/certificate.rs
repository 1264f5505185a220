//! What can be said of how right a picture is.

use std::iter::Sum;

use super::{Counts, Errors, Probe, RayKind, Unfollowed};
use crate::math::{Decisions, Rgb};
use crate::surface::Hit;

/// What can be said of how right a picture is: counts, and the largest errors.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Certificate {
    /// How much work it was, and how it was decided.
    pub counts: Counts,
    /// The largest error of a hit that the eye sees directly, in world units.
    pub largest_error: f64,
    /// How much at most a ray could have added that was not followed because its ray from the eye had
    /// caused as many as it may; infinite if nothing bounds it.
    pub largest_residual: f64,
    /// The largest estimate for hits that it sees in mirrors and through panes, in world units;
    /// infinite if rounding may have led a ray anywhere.
    pub largest_bounced_error: f64,
}

impl Probe for Certificate {
    fn ray(&mut self, kind: RayKind, share: Rgb) {
        self.counts.ray(kind, share);
    }

    fn not_followed(&mut self, kind: RayKind, why: Unfollowed) {
        self.counts.not_followed(kind, why);
        if let Unfollowed::Capped(missed) = why {
            self.largest_residual = self.largest_residual.max(missed);
        }
    }

    fn follows_errors(&self) -> bool {
        true
    }

    fn met(&mut self, surface: usize, hit: &Hit, errors: Errors) {
        self.counts.met(surface, hit, errors);
        let largest = if errors.bounces == 0 {
            &mut self.largest_error
        } else {
            &mut self.largest_bounced_error
        };
        *largest = largest.max(errors.place);
    }

    fn hit_tests(&mut self, count: u64) {
        self.counts.hit_tests(count);
    }

    fn occlusion_tests(&mut self, light: usize, count: u64) {
        self.counts.occlusion_tests(light, count);
    }

    fn decisions(&mut self, decisions: Decisions) {
        self.counts.decisions(decisions);
    }

    fn texel_fetches(&mut self, count: u64) {
        self.counts.texel_fetches(count);
    }
}

impl Sum for Certificate {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::default(), |sum, next| Self {
            counts: [sum.counts, next.counts].into_iter().sum(),
            largest_error: sum.largest_error.max(next.largest_error),
            largest_residual: sum.largest_residual.max(next.largest_residual),
            largest_bounced_error: sum.largest_bounced_error.max(next.largest_bounced_error),
        })
    }
}
