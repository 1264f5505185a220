//! The arithmetic that decides hits.

use crate::language::words;

/// The algorithm and the numbers that decide hits.
///
/// The classic ones are the chapter's own algorithm. They are the baseline of tests and of costs.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Numerics {
    /// Exact decisions: a ray cannot hit the carrier that it leaves. No offset.
    #[default]
    Robust,
    /// The chapter's algorithm in 64-bit world coordinates, with a small offset.
    Classic,
    /// The same in 32-bit floats.
    ClassicF32,
}

words!(Numerics {
    Robust: "robust",
    Classic: "classic",
    ClassicF32: "classic-f32",
});
