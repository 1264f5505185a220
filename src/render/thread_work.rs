//! Work that is counted per thread, without probes.

use super::{Event, Probe};
use crate::math::Decisions;
use crate::texture::fetched_by_this_thread;

/// The counts of a thread at one moment.
#[derive(Debug, Clone, Copy)]
pub struct ThreadWork {
    decisions: Decisions,
    texel_fetches: u64,
}

impl ThreadWork {
    /// The counts of this thread until now.
    #[must_use]
    pub fn until_now() -> Self {
        Self {
            decisions: Decisions::of_this_thread(),
            texel_fetches: fetched_by_this_thread(),
        }
    }

    /// Reports to a probe the work that this thread has done since then.
    pub fn tell(self, probe: &mut impl Probe) {
        let now = Self::until_now();
        probe.on(Event::Decisions(now.decisions - self.decisions));
        probe.on(Event::TexelFetches(now.texel_fetches - self.texel_fetches));
    }
}
