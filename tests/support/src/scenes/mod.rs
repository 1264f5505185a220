//! Random scenes, each a function of its number alone, and the writer of all of them.

pub mod crowds;
pub mod lamps;
pub mod mixtures;
mod writer;

pub use writer::{Writer, triple};
