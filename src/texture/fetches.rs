//! Counts of texel fetches, one for each thread.

use std::cell::Cell;

thread_local! {
    static FETCHED: Cell<u64> = const { Cell::new(0) };
}

/// The number of texels that the current thread has fetched.
///
/// It counts each texel of a filter, for surfaces, shadows and slides alike.
#[must_use]
pub fn fetched_by_this_thread() -> u64 {
    FETCHED.get()
}

/// Adds to the number of texels that the current thread has fetched.
#[inline]
pub(super) fn add_fetches(count: u64) {
    FETCHED.set(FETCHED.get() + count);
}
