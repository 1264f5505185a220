//! The nodes of a tree of boxes.

use crate::math::Bounds;

/// A box with its content.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    pub(super) bounds: Bounds,
    pub(super) content: Content,
}

/// The content of a box.
#[derive(Debug, Clone, Copy)]
pub(super) enum Content {
    /// Two boxes, this one and the next.
    Boxes(u32),
    /// Surfaces: from the first up to but not the second.
    Surfaces(u32, u32),
}
