//! Parts that surfaces and projectors refer to while a scene is built.

use glam::{DVec2, DVec3};

use super::names::Names;
use crate::language::{Diagnostic, Node, ValueError};
use crate::material::Material;
use crate::texture::Texture;

/// The parts that surfaces and projectors refer to.
#[derive(Debug)]
pub(super) struct Parts {
    pub(super) textures: Names<Texture>,
    pub(super) materials: Names<Material>,
    /// The world size of a pixel of the chapter's screen, if the camera has one.
    pub(super) pixel_size: Option<DVec2>,
    /// The viewpoint.
    pub(super) eye: DVec3,
}

/// The part that a node describes; an error becomes a diagnostic.
pub(super) fn accepted<T>(
    node: &Node,
    made: Result<T, ValueError>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<T> {
    made.map_err(|error| diagnostics.extend(diagnostic(node, error)))
        .ok()
}

/// The diagnostic of an error, at the attribute that the error names.
pub(super) fn diagnostic(node: &Node, error: ValueError) -> Option<Diagnostic> {
    let mut attributes = node.schema.all_attributes();
    let attribute = attributes.find(|attribute| attribute.word == error.word);
    let is_default = |word| node.entry(word).is_none();
    let label = match (attribute, error.expected) {
        (Some(attribute), _) if is_default(error.word) && attribute.default.value().is_some() => {
            format!("expected another `{}` than the default", attribute.word)
        }
        (_, Some(expected)) => expected,
        (Some(attribute), None) => format!("expected {}", attribute.takes.words()),
        (None, None) => format!("expected another `{}`", node.word),
    };
    let at = node.place(error.word)?;
    Some(Diagnostic::error(at, error.reason, label).help(error.advice))
}
