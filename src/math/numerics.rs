//! The arithmetic that decides hits.

use crate::language::words;

/// The algorithm and the numbers that decide hits.
///
/// The classic ones are the chapter's own algorithm. They are the baseline of tests and of costs.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Numerics {
    /// Exact decisions without offset or tolerance: a ray cannot hit the carrier that it leaves.
    #[default]
    Robust,
    /// The chapter's algorithm in world coordinates and 64-bit floats, with a small offset.
    Classic,
    /// The same in 32-bit floats.
    ClassicF32,
}

words!(Numerics {
    Robust: "robust",
    Classic: "classic",
    ClassicF32: "classic-f32",
});
