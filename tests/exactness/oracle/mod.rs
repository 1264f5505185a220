//! The oracle: every decision of the geometry against exact arithmetic of its own.
//!
//! `HELIODON_ORACLE_CASES` sets the number of cases of each kind. `oracle/README.md` lists what is
//! tested and how inputs are aimed.

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
