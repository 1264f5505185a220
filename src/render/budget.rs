//! The budget of a camera ray: rays that it may cause, and light that it may miss.

use super::Unfollowed;

/// The largest number of reflected and transmitted rays per camera ray.
///
/// It ends paths between two perfect mirrors. With a smaller limit, long rows of mirror images end
/// too early. With a larger one, a path needs more stack than a thread has.
const MOST_BOUNCES: u32 = 1000;

/// The remaining budget of the rays that one camera ray causes.
#[derive(Debug)]
pub(super) struct Budget {
    /// The number of further rays.
    rays: u32,
    /// The light that may still be missed.
    light: f64,
}

impl Budget {
    /// An empty budget.
    pub(super) const NOTHING: Self = Self {
        rays: 0,
        light: 0.0,
    };

    /// The full budget of a camera ray that may miss this much light.
    pub(super) fn new(light: f64) -> Self {
        Self {
            rays: MOST_BOUNCES,
            light,
        }
    }

    /// Decides whether to follow a ray that could add at most this much light.
    ///
    /// A followed ray reduces the number of rays. A ray that is too faint reduces the light that
    /// may be missed.
    ///
    /// # Errors
    /// Returns the reason for which the ray is not followed.
    pub(super) fn spend(&mut self, most: f64) -> Result<(), Unfollowed> {
        if most <= self.light {
            self.light -= most;
            return Err(Unfollowed::TooFaint(most));
        }
        self.rays = self.rays.checked_sub(1).ok_or(Unfollowed::Capped(most))?;
        Ok(())
    }

    /// Reserves a share, so that the first of two rays cannot use up the whole budget.
    pub(super) fn put_aside(&mut self, share: f64) -> Self {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a share of a small count"
        )]
        let rays = (f64::from(self.rays) * share) as u32;
        let aside = Self {
            rays,
            light: self.light * share,
        };
        self.rays -= aside.rays;
        self.light -= aside.light;
        aside
    }

    /// Returns a reserved share to the budget.
    pub(super) fn take_back(&mut self, aside: Self) {
        self.rays += aside.rays;
        self.light += aside.light;
    }
}
