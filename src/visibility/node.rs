//! Nodes of a bounding volume hierarchy.

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
    /// Two child nodes: this one and the next.
    Boxes(u32),
    /// A range of surfaces; the second number is exclusive.
    Surfaces(u32, u32),
}
