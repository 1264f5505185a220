//! What can be said of how right a picture is.

use std::iter::Sum;

use super::{Event, Probe, Unfollowed};

/// What can be said of how right a picture is: the largest errors.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Certificate {
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
    fn on(&mut self, event: Event<'_>) {
        match event {
            Event::NotFollowed(_, Unfollowed::Capped(missed)) => {
                self.largest_residual = self.largest_residual.max(missed);
            }
            Event::Hit(_, _, errors) => {
                let largest = if errors.bounces == 0 {
                    &mut self.largest_error
                } else {
                    &mut self.largest_bounced_error
                };
                *largest = largest.max(errors.place);
            }
            _ => {}
        }
    }

    fn follows_errors(&self) -> bool {
        true
    }
}

impl Sum for Certificate {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::default(), |sum, next| Self {
            largest_error: sum.largest_error.max(next.largest_error),
            largest_residual: sum.largest_residual.max(next.largest_residual),
            largest_bounced_error: sum.largest_bounced_error.max(next.largest_bounced_error),
        })
    }
}
