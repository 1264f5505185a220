//! How decisions were taken: a count that every thread keeps for itself.

use std::cell::Cell;
use std::iter::Sum;
use std::ops::{Add, Sub};

/// How many surface tests a rounded value with an error bound could not decide.
///
/// All others it did, so they need no count of their own, and the innermost loops none.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, serde::Serialize)]
pub struct Decisions {
    /// Decided by exact arithmetic.
    pub exactly: u64,
    /// Decided by a rule, because the exact value is zero: the ray meets an edge, starts on a
    /// plane, or meets two surfaces in the same place.
    pub by_rule: u64,
}

thread_local! {
    static TAKEN: Cell<Decisions> = const { Cell::new(Decisions { exactly: 0, by_rule: 0 }) };
}

impl Decisions {
    /// All that this thread has taken so far.
    #[must_use]
    pub fn of_this_thread() -> Self {
        TAKEN.get()
    }

    /// Notes a decision by exact arithmetic, or by rule if it was a tie.
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
