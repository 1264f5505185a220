//! Answers about scenes and pictures.

mod check;

pub use check::check;
