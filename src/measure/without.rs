//! A scene with one of its effects switched off.

use std::path::PathBuf;

use crate::film::Transfer;
use crate::language::{Node, Schema, Value, ValueError};
use crate::light::{Cone, Light, Slide};
use crate::plan::Effect;
use crate::read::{Options, read_bytes};
use crate::scene::Scene;
use crate::surface::{FinitePlane, TexturePlane};
use crate::texture::{Filter, Texture};

/// A scene with one effect switched off, by what its user could have written: the scene is
/// described, its nodes are changed, and their text is read.
///
/// Mirrors and glints share `specular`, so without mirrors there are no glints either; glints alone
/// are switched off by `shininess`. What has an `ior` mirrors by it, so without mirrors it has none.
/// Shadows and soft shadows are what surfaces receive, and go together.
///
/// # Errors
/// Refuses a scene that cannot be read again, because its textures cannot.
pub fn without(scene: &Scene, effect: Effect) -> Result<Scene, ValueError> {
    read_again(nodes(scene)?.into_iter().map(|node| off(node, effect)))
}

/// The scene as its own text has it.
///
/// # Errors
/// As [`without`].
pub fn round_trip(scene: &Scene) -> Result<Scene, ValueError> {
    read_again(nodes(scene)?.into_iter())
}

/// The nodes of a scene, which name textures as the current folder does.
fn nodes(scene: &Scene) -> Result<Vec<Node>, ValueError> {
    let mut nodes = scene.describe();
    let textures = nodes
        .iter_mut()
        .filter(|node| node.schema == &Texture::SCHEMA);
    for (node, texture) in textures.zip(&scene.textures) {
        let path = texture.path.to_str().ok_or_else(|| {
            let reason = format!("{} cannot be written in a scene", texture.path.display());
            ValueError::new("texture", reason, "give it a name in UTF-8")
        })?;
        node.value = Some(path.into());
    }
    Ok(nodes)
}

/// A node without what calls for an effect.
fn off(node: Node, effect: Effect) -> Node {
    match effect {
        Effect::Shadows | Effect::SoftShadows => unshadowed(node),
        Effect::Mirrors => without_attribute(with_number(node, "specular", 0.0), "ior"),
        Effect::Transparency => with_number(node, "transparency", 0.0),
        Effect::Refraction => without_attribute(node, "ior"),
        Effect::Glints => with_number(node, "shininess", 0.0),
        Effect::SpotCones => changed(node, &Cone::SCHEMA, &Light::SCHEMA),
        Effect::Projectors => changed(node, &Slide::SCHEMA, &Light::SCHEMA),
        Effect::Textures if node.schema == &Slide::SCHEMA => node,
        Effect::Textures => {
            let plane = changed(node, &TexturePlane::SCHEMA, &FinitePlane::SCHEMA);
            without_attribute(plane, "texture")
        }
        Effect::TextureFilter => {
            with_property(node, "texture-filter", Filter::Nearest.word().into())
        }
        Effect::Antialiasing => {
            let single = with_property(node, "samples", Value::Number(1.0));
            with_property(single, "max-error", Value::Number(0.0))
        }
        Effect::TransferCurve => with_property(node, "transfer", Transfer::None.word().into()),
    }
}

/// Without shadows on it.
fn unshadowed(mut node: Node) -> Node {
    let entries = node.attributes.iter_mut();
    for shadows in entries.filter(|entry| entry.attribute.word == "shadows") {
        let properties = shadows.properties.iter_mut();
        for receive in properties.filter(|entry| entry.attribute.word == "receive") {
            receive.value = Some(false.into());
        }
    }
    node
}

/// With an attribute set to a number, if it is given.
fn with_number(mut node: Node, word: &str, number: f64) -> Node {
    let entries = node.attributes.iter_mut();
    for entry in entries.filter(|entry| entry.attribute.word == word) {
        entry.value = Some(Value::Number(number));
    }
    node
}

/// Of one kind made another, which knows only some of its attributes.
fn changed(mut node: Node, from: &Schema, to: &'static Schema) -> Node {
    if node.schema == from {
        (node.schema, node.word) = (to, to.word);
        let known = |word| to.all_attributes().any(|attribute| attribute.word == word);
        node.attributes.retain(|entry| known(entry.attribute.word));
    }
    node
}

/// Without an attribute.
fn without_attribute(mut node: Node, word: &str) -> Node {
    node.attributes.retain(|entry| entry.attribute.word != word);
    node
}

/// With a property set to a value, if it is given.
fn with_property(mut node: Node, word: &str, value: Value) -> Node {
    let properties = node.properties.iter_mut();
    for property in properties.filter(|entry| entry.attribute.word == word) {
        property.value = Some(value.clone());
    }
    node
}

/// The scene that these nodes make, as text; textures that nothing wears any more are left out.
fn read_again(nodes: impl Iterator<Item = Node>) -> Result<Scene, ValueError> {
    let nodes: Vec<_> = nodes.collect();
    let worn: Vec<_> = nodes.iter().map(image_of).collect();
    let is_idle = |node: &Node| node.schema == &Texture::SCHEMA && !worn.contains(&node.name);
    let text: String = nodes
        .iter()
        .filter(|node| !is_idle(node))
        .map(ToString::to_string)
        .collect();
    let reading = read_bytes("scene", text.into(), PathBuf::new(), &Options::default());
    match reading {
        Ok(reading) => Ok(reading.scene),
        Err(scene_error) => {
            let problem = scene_error.diagnostics.into_iter().next();
            let reason = problem.map_or_else(String::new, |problem| problem.message);
            let reason = format!("the scene cannot be read again: {reason}");
            Err(ValueError::new(
                "texture",
                reason,
                "leave its files in place",
            ))
        }
    }
}

/// The name of the texture that a surface wears or a projector shows.
fn image_of(node: &Node) -> Option<String> {
    let image = node.entry("texture")?.value.as_ref()?;
    Some(image.text().to_owned())
}
