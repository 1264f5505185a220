//! Schemas of the nodes of KDL scene files.

use crate::language::{Attribute, Naming, Schema, Takes};
use crate::scene::Scene;

/// The `include` node, which belongs to files, not to scenes.
pub(super) const INCLUDE: Schema = Schema {
    word: "include",
    about: "Another scene file, whose nodes replace this node.",
    naming: Naming::None,
    value: Some(&Attribute::new(
        "file",
        Takes::Path,
        "a KDL file, relative to this file",
    )),
    properties: &[],
    attributes: &[],
};

/// The schemas of all nodes of KDL scene files.
pub fn schemas() -> impl Iterator<Item = &'static Schema> {
    Scene::schemas().chain([&INCLUDE])
}
