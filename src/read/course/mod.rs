//! The course's old block grammar.

use super::Files;
use crate::language::{Node, Problem};

/// Whether a text is written in the block grammar.
pub(super) fn looks_like(_text: &str) -> bool {
    false
}

/// Reads a scene's nodes.
pub(super) fn read(_source: usize, _files: &Files, _problems: &mut Vec<Problem>) -> Vec<Node> {
    Vec::new()
}
