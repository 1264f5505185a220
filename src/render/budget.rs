//! What one ray from the eye may cause, and may lack.

use super::Unfollowed;

/// The most mirrored and transmitted rays that one ray from the eye may cause.
///
/// Two facing perfect mirrors would go on for ever; smaller, and long rows of mirror images end
/// too early; larger, and a path needs more stack than a thread has.
const MOST_BOUNCES: u32 = 1000;

/// What is left for the rays that one ray from the eye causes.
#[derive(Debug)]
pub(super) struct Budget {
    /// How many more there may be.
    rays: u32,
    /// How much light may still be missed.
    light: f64,
}

impl Budget {
    /// No rays, and no light to miss.
    pub(super) const NOTHING: Self = Self {
        rays: 0,
        light: 0.0,
    };

    /// All that a ray from the eye may cause, which may miss this much light.
    pub(super) fn new(light: f64) -> Self {
        Self {
            rays: MOST_BOUNCES,
            light,
        }
    }

    /// Spends a ray that could bring this much light; if it does not set out, what it could have
    /// brought is missed.
    ///
    /// # Errors
    /// Tells why it does not.
    pub(super) fn spend(&mut self, most: f64) -> Result<(), Unfollowed> {
        if most <= self.light {
            self.light -= most;
            return Err(Unfollowed::TooFaint(most));
        }
        self.rays = self.rays.checked_sub(1).ok_or(Unfollowed::Capped(most))?;
        Ok(())
    }

    /// Puts a share aside, so that the one of two rays that is followed first cannot use up all.
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

    /// Adds what was put aside to what is left.
    pub(super) fn take_back(&mut self, aside: Self) {
        self.rays += aside.rays;
        self.light += aside.light;
    }
}
