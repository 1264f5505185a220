//! How surfaces are found.

/// How the surfaces that a ray may meet are found among all. The picture does not depend on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Accelerator {
    /// Every surface is asked, or every one that can appear in a part of the picture.
    List,
    /// Surfaces are asked whose boxes the ray passes.
    Tree,
}

impl Accelerator {
    /// The fewest surfaces for which a tree is built.
    ///
    /// Measured with `benches/many_planes.rs` in millions of instructions for three pictures of 160
    /// by 120 pixels, by a list and by a tree: 49 and 69 for 64 surfaces, 83 and 88 for 128, 200 and 104
    /// for 256. Smaller, and a camera's list of what is where would have been faster; larger, and
    /// shadows, which have no lists of their own beyond 128 surfaces, ask all of them.
    pub const FEWEST: usize = 129;

    /// What it is called.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::List => "list",
            Self::Tree => "tree",
        }
    }

    /// What is best for this number of surfaces.
    #[must_use]
    pub fn for_count(count: usize) -> Self {
        if count < Self::FEWEST {
            Self::List
        } else {
            Self::Tree
        }
    }
}
