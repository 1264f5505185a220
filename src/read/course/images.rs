//! Textures that a scene uses by the names of their files.

use std::collections::HashSet;

use super::{entity::Block, preset};
use crate::language::{Location, Node};
use crate::read::Files;
use crate::texture::Texture;

/// What the names of textures mean.
#[derive(Debug)]
pub(super) struct Images<'a> {
    files: &'a Files,
    /// The names that need no more thought: of the scene's textures, and of files that became one.
    known: HashSet<String>,
    /// The nodes of the files.
    nodes: Vec<Node>,
}

impl<'a> Images<'a> {
    /// With the textures that a scene has.
    pub(super) fn new(blocks: &[Block], files: &'a Files) -> Self {
        let textures = blocks
            .iter()
            .filter(|block| block.entity.schema == &Texture::SCHEMA);
        let known = textures
            .filter_map(|texture| texture.name.clone())
            .collect();
        Self {
            files,
            known,
            nodes: Vec::new(),
        }
    }

    /// Makes a file a texture that is called like it, if a name means a file.
    pub(super) fn mention(&mut self, name: &str, at: Location) {
        if !self.known.insert(name.to_owned()) {
            return;
        }
        // A name that may be a mistyped texture's is left to the builder, which knows them all.
        let is_file =
            name.contains(['.', '/', '\\']) || self.files.locate(at.source, name).is_file();
        if is_file {
            let mut node = Node::new(&Texture::SCHEMA, Some(name)).value(name);
            node.location = Some(at);
            self.nodes.push(preset::texture(node));
        }
    }

    /// The nodes of the files that were meant.
    pub(super) fn into_nodes(self) -> Vec<Node> {
        self.nodes
    }
}
