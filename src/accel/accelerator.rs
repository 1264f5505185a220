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
    pub const FEWEST: usize = 64;

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
