//! What became of the cases.

use std::fmt;
use std::ops::AddAssign;

use heliodon::math::Decisions;

/// Counts of cases and of what was found wrong.
#[derive(Debug, Clone, Default)]
pub(crate) struct SampleAccumulator {
    /// Decisions compared.
    pub(crate) cases: u64,
    /// Of these, hits, or whatever else is not nothing.
    pub(crate) positive: u64,
    /// Cases in which production needed exact arithmetic, without a tie.
    pub(crate) exactly: u64,
    /// Cases that were decided by a rule.
    pub(crate) by_rule: u64,
    /// Rays at a seam that met nothing.
    pub(crate) none: u64,
    /// Rays at a seam that met more than one tile.
    pub(crate) several: u64,
    /// Rays that left a closed room.
    pub(crate) leaks: u64,
    /// Rays that met the sheet that they left, or one that they led away from.
    pub(crate) self_hits: u64,
    /// Whatever is not as exact arithmetic has it, the above included.
    pub(crate) mismatches: u64,
    /// The first few of them, in words.
    pub(crate) samples: Vec<String>,
}

impl SampleAccumulator {
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

    /// [`observe`](Self::observe) for what counts for itself.
    pub(crate) fn observe_within(&mut self, count: impl FnOnce(&mut Self)) {
        let before = Decisions::of_this_thread();
        count(self);
        let taken = Decisions::of_this_thread() - before;
        self.exactly += taken.exactly;
        self.by_rule += taken.by_rule;
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

impl AddAssign for SampleAccumulator {
    fn add_assign(&mut self, other: Self) {
        self.cases += other.cases;
        self.positive += other.positive;
        self.exactly += other.exactly;
        self.by_rule += other.by_rule;
        self.none += other.none;
        self.several += other.several;
        self.leaks += other.leaks;
        self.self_hits += other.self_hits;
        self.mismatches += other.mismatches;
        self.samples.extend(other.samples);
        self.samples.truncate(3);
    }
}
