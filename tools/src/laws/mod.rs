//! The laws in `docs/accuracy.md`: the error of each setting at each of its values.

mod cut_off;
mod edges;
pub mod figures;
mod filters;
mod numerics;
pub mod series;
pub mod variants;
