//! What became of the cases.

use std::fmt;
use std::ops::AddAssign;

use heliodon::math::Decisions;

/// Counts of cases and of what was found wrong.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tally {
    /// Decisions compared.
    pub(crate) cases: u64,
    /// Of these, hits, or whatever else is not nothing.
    pub(crate) positive: u64,
    /// Cases in which production needed exact arithmetic, without a tie.
    pub(crate) exactly: u64,
    /// Cases that were decided by a rule.
    pub(crate) by_rule: u64,
    /// Decisions other than the exact ones.
    pub(crate) mismatches: u64,
    /// The first few of them, in words.
    pub(crate) samples: Vec<String>,
}

impl Tally {
    /// Takes a decision and notes whether doubles sufficed for it.
    pub(crate) fn observe<T>(&mut self, decision: impl FnOnce() -> T) -> T {
        let before = Decisions::of_this_thread();
        let decided = decision();
        let taken = Decisions::of_this_thread() - before;
        if taken.by_rule > 0 {
            self.by_rule += 1;
        } else if taken.exactly > 0 {
            self.exactly += 1;
        }
        decided
    }

    /// Compares a decision with the exact one.
    pub(crate) fn compare<T: PartialEq + fmt::Debug>(
        &mut self,
        decided: &T,
        exact: &T,
        positive: bool,
        what: impl FnOnce() -> String,
    ) {
        self.cases += 1;
        self.positive += u64::from(positive);
        if decided != exact {
            self.wrong(|| format!("{decided:?} instead of {exact:?}: {}", what()));
        }
    }

    /// Notes something that must not be.
    pub(crate) fn wrong(&mut self, what: impl FnOnce() -> String) {
        const KEPT: usize = 3;
        self.mismatches += 1;
        if self.samples.len() < KEPT {
            self.samples.push(what());
        }
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.cases += other.cases;
        self.positive += other.positive;
        self.exactly += other.exactly;
        self.by_rule += other.by_rule;
        self.mismatches += other.mismatches;
        self.samples.extend(other.samples);
        self.samples.truncate(3);
    }
}
