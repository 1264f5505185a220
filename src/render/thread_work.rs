//! Work that is counted where it is done, out of the sight of onlookers.

use super::{Event, Probe};
use crate::math::Decisions;
use crate::texture::fetched_by_this_thread;

/// What a thread has done of that so far.
#[derive(Debug, Clone, Copy)]
pub struct ThreadWork {
    decisions: Decisions,
    texel_fetches: u64,
}

impl ThreadWork {
    /// All that this thread has done until now.
    #[must_use]
    pub fn until_now() -> Self {
        Self {
            decisions: Decisions::of_this_thread(),
            texel_fetches: fetched_by_this_thread(),
        }
    }

    /// Tells an onlooker what this same thread has done since then.
    pub fn tell(self, probe: &mut impl Probe) {
        let now = Self::until_now();
        probe.on(Event::Decisions(now.decisions - self.decisions));
        probe.on(Event::TexelFetches(now.texel_fetches - self.texel_fetches));
    }
}
