//! Counts of decisions, kept by each thread.

use std::cell::Cell;
use std::iter::Sum;
use std::ops::{Add, Sub};

/// The number of surface tests that rounded values did not decide.
///
/// The others need no count, and the innermost loops none.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, serde::Serialize)]
pub struct Decisions {
    /// Decided by exact arithmetic.
    pub exactly: u64,
    /// Decided by a rule, because the exact value is zero.
    ///
    /// The ray passes through an edge, starts on a plane, or hits two surfaces at one point.
    pub by_rule: u64,
}

thread_local! {
    static TAKEN: Cell<Decisions> = const { Cell::new(Decisions { exactly: 0, by_rule: 0 }) };
}

impl Decisions {
    /// The count of this thread so far.
    #[must_use]
    pub fn of_this_thread() -> Self {
        TAKEN.get()
    }

    /// Counts a decision by exact arithmetic, or by rule for a tie.
    #[cold]
    pub(crate) fn note(tie: bool) {
        let mut taken = TAKEN.get();
        if tie {
            taken.by_rule += 1;
        } else {
            taken.exactly += 1;
        }
        TAKEN.set(taken);
    }
}

impl Add for Decisions {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            exactly: self.exactly + other.exactly,
            by_rule: self.by_rule + other.by_rule,
        }
    }
}

impl Sub for Decisions {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self {
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
