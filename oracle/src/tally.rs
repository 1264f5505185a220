//! What became of the cases.

use std::fmt;
use std::ops::AddAssign;

use heliodon::math::Decisions;

/// Counts of cases and of what was found wrong.
#[derive(Debug, Clone, Default)]
pub struct Tally {
    /// Decisions compared.
    pub cases: u64,
    /// Of these, hits, or whatever else is not nothing.
    pub positive: u64,
    /// Cases in which production needed exact arithmetic, without a tie.
    pub exactly: u64,
    /// Cases that were decided by a rule.
    pub by_rule: u64,
    /// Rays at a seam that met nothing.
    pub none: u64,
    /// Rays at a seam that met more than one tile.
    pub several: u64,
    /// Rays that left a closed room.
    pub leaks: u64,
    /// Rays that met the sheet that they left, or one that they led away from.
    pub self_hits: u64,
    /// Whatever is not as exact arithmetic has it, the above included.
    pub mismatches: u64,
    /// The first few of them, in words.
    pub samples: Vec<String>,
}

impl Tally {
    /// Takes a decision and notes whether doubles sufficed for it.
    pub fn observe<T>(&mut self, decision: impl FnOnce() -> T) -> T {
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
    pub fn observe_within(&mut self, count: impl FnOnce(&mut Self)) {
        let before = Decisions::of_this_thread();
        count(self);
        let taken = Decisions::of_this_thread() - before;
        self.exactly += taken.exactly;
        self.by_rule += taken.by_rule;
    }

    /// Compares a decision with the exact one.
    pub fn compare<T: PartialEq + fmt::Debug>(
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
    pub fn wrong(&mut self, what: impl FnOnce() -> String) {
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
        self.none += other.none;
        self.several += other.several;
        self.leaks += other.leaks;
        self.self_hits += other.self_hits;
        self.mismatches += other.mismatches;
        self.samples.extend(other.samples);
        self.samples.truncate(3);
    }
}
