//! Answers about scenes and pictures.

mod check;
mod coincident;

pub use check::check;
