//! How decisions were taken: a count that every thread keeps for itself.

use std::cell::Cell;
use std::iter::Sum;
use std::ops::{Add, Sub};

/// How many yes/no decisions were taken, and how.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, serde::Serialize)]
pub struct Decisions {
    /// By a rounded value that lay outside of its error bound.
    pub by_filter: u64,
    /// By exact arithmetic, because the rounded value lay within its error bound.
    pub exactly: u64,
    /// By a rule, because the exact value is zero: the ray meets an edge, or two surfaces are
    /// equally near.
    pub by_rule: u64,
}

thread_local! {
    static TAKEN: Cell<Decisions> = const {
        Cell::new(Decisions { by_filter: 0, exactly: 0, by_rule: 0 })
    };
}

impl Decisions {
    /// All that this thread has taken so far.
    #[must_use]
    pub fn of_this_thread() -> Self {
        TAKEN.get()
    }

    /// The number of all of them.
    #[must_use]
    pub fn all(&self) -> u64 {
        self.by_filter + self.exactly + self.by_rule
    }

    /// Notes decisions taken by the filter.
    pub(crate) fn filtered(count: u64) {
        TAKEN.with(|taken| {
            let decisions = taken.get();
            taken.set(Self { by_filter: decisions.by_filter + count, ..decisions });
        });
    }

    /// Notes a decision taken exactly; if it was a tie, a rule took it.
    #[cold]
    pub(crate) fn exact(tie: bool) {
        let mut decisions = TAKEN.get();
        if tie {
            decisions.by_rule += 1;
        } else {
            decisions.exactly += 1;
        }
        TAKEN.set(decisions);
    }
}

impl Add for Decisions {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            by_filter: self.by_filter + other.by_filter,
            exactly: self.exactly + other.exactly,
            by_rule: self.by_rule + other.by_rule,
        }
    }
}

impl Sub for Decisions {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self {
            by_filter: self.by_filter - other.by_filter,
            exactly: self.exactly - other.exactly,
            by_rule: self.by_rule - other.by_rule,
        }
    }
}

impl Sum for Decisions {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::default(), Self::add)
    }
}
