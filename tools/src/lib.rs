//! The parts of the programs in `src/bin` that tests read as well.

pub mod effects;
pub mod laws;
