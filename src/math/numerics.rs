//! The arithmetic that decides what a ray meets.

use crate::language::words;

/// Which algorithm and which numbers say where rays meet surfaces.
///
/// The classic ones are the chapter's own algorithm; they are kept so that tests and costs have
/// something to be measured against.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Numerics {
    /// No offset and no tolerance: a ray cannot meet the sheet that it leaves.
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
