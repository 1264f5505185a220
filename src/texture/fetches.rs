//! How many texels were fetched: a count that every thread keeps for itself.

use std::cell::Cell;

thread_local! {
    static FETCHED: Cell<u64> = const { Cell::new(0) };
}

/// All texels that this thread has fetched so far.
///
/// They are counted where they are fetched, however deep in a surface, a shadow or a slide that is,
/// and however many of them a filter takes for one colour.
#[must_use]
pub fn fetched_by_this_thread() -> u64 {
    FETCHED.get()
}

/// Notes that so many texels were fetched.
#[inline]
pub(super) fn note(count: u64) {
    FETCHED.set(FETCHED.get() + count);
}
