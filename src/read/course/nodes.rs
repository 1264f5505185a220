//! Entities to nodes.

use glam::DVec3;

use super::entity::{Block, Given};
use super::images::Images;
use super::words::Role;
use crate::language::{Node, Problem, Schema, Value};
use crate::surface::TiledPlane;
use crate::texture::Texture;

/// The node that an entity is.
pub(super) fn node(block: &Block, images: &mut Images<'_>, problems: &mut Vec<Problem>) -> Node {
    let mut node = Node::new(schema(block), block.name.as_deref());
    node.word = block.entity.word;
    node.location = Some(block.head);
    node.sound = block.sound;
    if !node.sound {
        return node;
    }
    for given in &block.given {
        if let Some(value) = &given.value {
            node = add(node, block, given, value, images, problems);
        }
    }
    if node.schema == &TiledPlane::SCHEMA {
        node = complete_tiles(node);
    }
    if node.schema == &Texture::SCHEMA {
        node = super::preset::texture(node);
    }
    node
}

/// The kind of node; some entities are another kind without a certain attribute.
fn schema(block: &Block) -> &'static Schema {
    let entity = block.entity;
    match entity.without {
        Some((means, schema)) if !says(block, means) => schema,
        _ => entity.schema,
    }
}

fn says(block: &Block, means: &str) -> bool {
    let mut meant = block.given.iter().filter(|given| given.word.means == means);
    meant.any(|given| match (given.word.role, &given.value) {
        (Role::Shader, Some(number)) => shader(number).is_some(),
        (_, value) => value.is_some(),
    })
}

/// The node with one more attribute.
fn add(
    node: Node,
    block: &Block,
    given: &Given,
    value: &Value,
    images: &mut Images<'_>,
    problems: &mut Vec<Problem>,
) -> Node {
    let means = given.word.means;
    match given.word.role {
        Role::Attribute => node.with(means, value.clone()).last_at(given.at),
        Role::Texture => {
            images.mention(value.text(), given.at);
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
            problems.push(shader_warning(given, value, word));
            match word {
                Some(word) => node.with(means, word).last_at(given.at),
                None => node,
            }
        }
        Role::File => node.value(value.clone()),
        Role::PictureSize | Role::Mode | Role::Ignored => node,
    }
}

/// The formula with a number in the course's own examples.
fn shader(number: &Value) -> Option<&'static str> {
    [(0.0, "stripes"), (1.0, "color-wheel")]
        .into_iter()
        .find_map(|(known, word)| (number.number() == known).then_some(word))
}

fn shader_warning(given: &Given, number: &Value, word: Option<&str>) -> Problem {
    let label = match word {
        Some(word) => format!("drawn as {word:?}"),
        None => "drawn without a procedure".to_owned(),
    };
    let message = format!("procedure {number} was another one in every program");
    Problem::warning(given.at, message, label)
        .help("0 is drawn as \"stripes\" and 1 as \"color-wheel\", the course's own examples")
}

/// The node of a tiled plane with what every one has here.
fn complete_tiles(node: Node) -> Node {
    let node = node.with("start", "course");
    if node.entry("xdir").is_some() {
        return node;
    }
    // The first course's tiles had no direction: they lay along the axes.
    let normal = node.triple("normal");
    let along_x = normal.y == 0.0 && normal.z == 0.0;
    node.with("xdir", if along_x { DVec3::NEG_Z } else { DVec3::X })
}
