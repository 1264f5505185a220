//! How far off a hit may be.

use std::iter::Sum;

use super::{Counts, Probe, RayKind, Unfollowed};
use crate::math::{Decisions, Rgb, UNIT};
use crate::surface::{Hit, Surface};

/// What rounding may have done to a path by the time it meets a surface.
///
/// For a ray from the eye this is a bound. Behind a mirror it is an estimate: to first order, for
/// the strongest curvature that a surface has anywhere.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Errors {
    /// How far the hit may lie from where it ought to, in world units.
    pub place: f64,
    /// By how much the ray's direction may be wrong, in radians.
    pub direction: f64,
    /// How many mirrors or panes the path has met before.
    pub bounces: u32,
}

impl Errors {
    /// The errors at the next hit of the path.
    #[must_use]
    pub fn at(self, hit: &Hit) -> Self {
        Self {
            place: self.place + self.direction * hit.t + hit.error,
            ..self
        }
    }

    /// The errors behind a surface that sends the path on.
    #[must_use]
    pub fn behind(self, surface: &dyn Surface) -> Self {
        // Mirroring a direction has about eight roundings.
        const MIRRORING: f64 = 8.0 * UNIT;
        let bend = surface.round().map_or(0.0, |[_, axes]| {
            // An ellipse is most curved at the ends of its long axis.
            2.0 * axes.max_element() / axes.min_element().powi(2)
        });
        Self {
            direction: self.direction + bend * self.place + MIRRORING,
            bounces: self.bounces + 1,
            ..self
        }
    }
}

/// What can be said of how right a picture is: counts, and the largest errors.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Certificate {
    /// How much work it was, and how it was decided.
    pub counts: Counts,
    /// The largest error of a hit that the eye sees directly, in world units.
    pub largest_error: f64,
    /// How much at most a ray could have added that was not followed because its ray from the eye had
    /// caused as many as it may; infinite if nothing bounds it.
    pub largest_residual: f64,
    /// The largest estimate for hits that it sees in mirrors and through panes, in world units.
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

    fn lamp_tests(&mut self, count: u64) {
        self.counts.lamp_tests(count);
    }

    fn texel_fetches(&mut self, count: u64) {
        self.counts.texel_fetches(count);
    }

    fn decisions(&mut self, decisions: Decisions) {
        self.counts.decisions(decisions);
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
