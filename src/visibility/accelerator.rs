//! Search structures for the surfaces that a ray may hit.

/// The search structure for the surfaces that a ray may hit.
///
/// The picture does not depend on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Accelerator {
    /// Tests every surface; for camera rays, those whose screen bounds hold the pixel.
    List,
    /// Tests the surfaces whose boxes the ray passes.
    Tree,
}

impl Accelerator {
    /// The fewest surfaces for which a tree is built.
    ///
    /// Measured with `benches/many_planes.rs` in millions of instructions for three pictures of 160
    /// by 120 pixels, by a list and by a tree: 49 and 69 for 64 surfaces, 83 and 88 for 128, 200
    /// and 104 for 256. Below it the screen bounds of the list are faster than a tree. Above 128
    /// surfaces shadow rays have no lists per receiver, so without a tree they test every surface.
    pub const FEWEST: usize = 129;

    /// The name in reports.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::List => "list",
            Self::Tree => "tree",
        }
    }

    /// The faster one for this number of surfaces.
    #[must_use]
    pub fn for_count(count: usize) -> Self {
        if count < Self::FEWEST {
            Self::List
        } else {
            Self::Tree
        }
    }
}
