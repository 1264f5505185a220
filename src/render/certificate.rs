//! The certificate of a picture: its largest errors.

use std::iter::Sum;

use super::{Event, Probe, Unfollowed};

/// The largest errors of a picture.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Certificate {
    /// The largest error bound of the hit of a camera ray, in world units.
    pub largest_error: f64,
    /// The largest bound of the light that a capped ray could have added to its pixel.
    ///
    /// A ray is capped if its camera ray has caused the largest number of rays. Infinite if there
    /// is no bound.
    pub largest_residual: f64,
    /// The largest estimated error of a reflected or transmitted ray's hit.
    ///
    /// In world units. Infinite if there is no estimate.
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
