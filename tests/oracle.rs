//! The oracle: every decision of the geometry against exact arithmetic of its own.
//!
//! `HELIODON_ORACLE_CASES` sets the number of cases of each kind. What is tested, how inputs are
//! aimed, and how to see the tests bite, is told in `tests/oracle/README.md`.

mod oracle {
    pub(crate) mod cases;
    pub(crate) mod decisions;
    pub(crate) mod floors;
    pub(crate) mod random;
    pub(crate) mod rational;
    pub(crate) mod rooms;
    pub(crate) mod tally;
    pub(crate) mod truth;

    mod balls;
    mod chance;
    mod closed;
    mod equality;
    mod penumbras;
    mod place;
    mod proofs;
    mod search;
    mod shades;
    mod unit_vectors;
    mod values;
}
