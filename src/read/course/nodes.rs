//! Nodes of the scene language from blocks.

use std::collections::HashSet;

use glam::DVec3;

use super::block::{Block, Given};
use super::preset;
use super::words::Role;
use crate::language::{Diagnostic, Location, Node, Schema, Value};
use crate::read::files::Files;
use crate::surface::TiledPlane;
use crate::texture::Texture;

/// The nodes of blocks, and of image files that surfaces name instead of textures.
pub(super) fn nodes(
    blocks: &[Block],
    files: &Files,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<Node> {
    let is_texture = |block: &&Block| block.entity.schema == &Texture::SCHEMA;
    let textures = blocks.iter().filter(is_texture);
    let mut converter = Converter {
        files,
        known: textures
            .filter_map(|texture| texture.name.clone())
            .collect(),
        images: Vec::new(),
        diagnostics,
    };
    let mut nodes: Vec<_> = blocks.iter().map(|block| converter.node(block)).collect();
    nodes.extend(converter.images);
    nodes
}

#[derive(Debug)]
struct Converter<'a> {
    files: &'a Files,
    /// The names of textures, and names that were checked.
    known: HashSet<String>,
    /// Texture nodes of image files.
    images: Vec<Node>,
    diagnostics: &'a mut Vec<Diagnostic>,
}

impl Converter<'_> {
    fn node(&mut self, block: &Block) -> Node {
        let mut node = Node::new(schema(block), block.name.as_deref());
        node.word = block.entity.word;
        node.location = Some(block.head);
        node.valid = block.valid;
        if !node.valid {
            return node;
        }
        for given in &block.given {
            if let Some(value) = &given.value {
                node = self.with(node, block, given, value);
            }
        }
        if node.schema == &TiledPlane::SCHEMA {
            node = with_implied_tiles(node);
        }
        if node.schema == &Texture::SCHEMA {
            node = preset::texture(node);
        }
        node
    }

    /// The node with one more attribute.
    fn with(&mut self, node: Node, block: &Block, given: &Given, value: &Value) -> Node {
        let means = given.word.means;
        match given.word.role {
            Role::Attribute => node.with(means, value.clone()).last_at(given.at),
            Role::Texture => {
                self.add_image(value.text(), given.at);
                let mode = if block.value("mode").is_some_and(|mode| mode.number() == 1.0) {
                    "repeat"
                } else {
                    "clamp"
                };
                let properties = [("mode", mode.into())];
                node.with_entry(means, Some(value.clone()), &properties)
                    .last_at(given.at)
            }
            Role::Shader => {
                let word = shader(value);
                self.diagnostics.push(shader_warning(given, value, word));
                match word {
                    Some(word) => node.with(means, word).last_at(given.at),
                    None => node,
                }
            }
            Role::File => node.value(value.clone()),
            Role::PictureSize | Role::Mode | Role::Ignored => node,
        }
    }

    /// Adds a texture of the same name if a texture's name is a file.
    fn add_image(&mut self, name: &str, at: Location) {
        if !self.known.insert(name.to_owned()) {
            return;
        }
        // The builder reports names that are neither a texture nor a file.
        let is_path = name.contains(['.', '/', '\\']);
        if is_path || self.files.locate(at.source, name).is_file() {
            let mut node = Node::new(&Texture::SCHEMA, Some(name)).value(name);
            node.location = Some(at);
            self.images.push(preset::texture(node));
        }
    }
}

/// The kind of a block's node, which can depend on one attribute.
fn schema(block: &Block) -> &'static Schema {
    let entity = block.entity;
    match entity.without {
        Some((means, schema)) if !has(block, means) => schema,
        _ => entity.schema,
    }
}

/// True if a block has an attribute with a meaning, and a known number of a shader.
fn has(block: &Block, means: &str) -> bool {
    let mut attributes = block.given.iter().filter(|given| given.word.means == means);
    attributes.any(|given| match (given.word.role, &given.value) {
        (Role::Shader, Some(number)) => shader(number).is_some(),
        (_, value) => value.is_some(),
    })
}

/// The formula of a number in the course's own examples.
fn shader(number: &Value) -> Option<&'static str> {
    [(0.0, "stripes"), (1.0, "color-wheel")]
        .into_iter()
        .find_map(|(known, word)| (number.number() == known).then_some(word))
}

fn shader_warning(given: &Given, number: &Value, word: Option<&str>) -> Diagnostic {
    let label = match word {
        Some(word) => format!("drawn as {word:?}"),
        None => "drawn without a procedure".to_owned(),
    };
    let message = format!("procedure {number} differed from program to program");
    Diagnostic::warning(given.at, message, label)
        .help("0 is drawn as \"stripes\" and 1 as \"color-wheel\", the course's own examples")
}

/// The node of a tiled plane with the attributes that the course implies.
fn with_implied_tiles(node: Node) -> Node {
    let node = node.with("start", "course");
    if node.entry("xdir").is_some() {
        return node;
    }
    // The first course's tiles had no direction and lay along the axes.
    let normal = node.triple("normal");
    let along_x = normal.y == 0.0 && normal.z == 0.0;
    node.with("xdir", if along_x { DVec3::NEG_Z } else { DVec3::X })
}
