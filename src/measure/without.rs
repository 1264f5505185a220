//! Scenes with an effect switched off.

use std::path::PathBuf;

use crate::film::Transfer;
use crate::language::{Entry, Node, Schema, Value, ValueError};
use crate::light::{Cone, Light, Slide};
use crate::plan::Effect;
use crate::read::{Options, read_bytes};
use crate::scene::Scene;
use crate::surface::{Plain, Textured};
use crate::texture::{Filter, Texture};

/// The scene without an effect: its text is changed as a user could do, and read again.
///
/// Mirrors take specular highlights along, with which they share `specular`, and refraction, whose
/// `ior` mirrors too. Shadows and soft shadows go together.
///
/// # Errors
/// Refuses a scene whose textures cannot be read again.
pub fn without(scene: &Scene, effect: Effect) -> Result<Scene, ValueError> {
    read_again(nodes(scene)?.into_iter().map(|node| off(node, effect)))
}

/// The scene, written as text and read again.
///
/// # Errors
/// As [`without`].
pub fn round_trip(scene: &Scene) -> Result<Scene, ValueError> {
    read_again(nodes(scene)?.into_iter())
}

/// Nodes of a scene with the paths of textures from the current folder.
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

/// A node without the attributes that call for an effect.
fn off(mut node: Node, effect: Effect) -> Node {
    match effect {
        Effect::Shadows | Effect::SoftShadows => {
            for shadows in entries(&mut node.attributes, "shadows") {
                set(&mut shadows.properties, "receive", false.into());
            }
        }
        Effect::Mirrors => {
            set(&mut node.attributes, "specular", Value::Number(0.0));
            remove(&mut node, "ior");
        }
        Effect::Transparency => set(&mut node.attributes, "transparency", Value::Number(0.0)),
        Effect::Refraction => remove(&mut node, "ior"),
        Effect::Glints => set(&mut node.attributes, "shininess", Value::Number(0.0)),
        Effect::SpotCones => convert(&mut node, &Cone::SCHEMA, &Light::SCHEMA),
        Effect::Projectors => convert(&mut node, &Slide::SCHEMA, &Light::SCHEMA),
        Effect::Textures if node.schema == &Slide::SCHEMA => {}
        Effect::Textures => {
            convert(&mut node, &Textured::PLANE, &Plain::FINITE_PLANE);
            remove(&mut node, "texture");
        }
        Effect::TextureFilter => {
            let nearest = Filter::Nearest.word().into();
            set(&mut node.properties, "texture-filter", nearest);
        }
        Effect::Antialiasing => {
            set(&mut node.properties, "samples", Value::Number(1.0));
            set(&mut node.properties, "max-error", Value::Number(0.0));
        }
        Effect::TransferCurve => {
            set(
                &mut node.properties,
                "transfer",
                Transfer::None.word().into(),
            );
        }
    }
    node
}

/// Entries with a word.
fn entries<'a>(entries: &'a mut [Entry], word: &str) -> impl Iterator<Item = &'a mut Entry> {
    entries
        .iter_mut()
        .filter(move |entry| entry.attribute.word == word)
}

/// Changes the value of an attribute or property, if it is given.
fn set(all: &mut [Entry], word: &str, value: Value) {
    for entry in entries(all, word) {
        entry.value = Some(value.clone());
    }
}

/// Removes an attribute.
fn remove(node: &mut Node, word: &str) {
    node.attributes.retain(|entry| entry.attribute.word != word);
}

/// Makes a node of one kind another, with the attributes that both have.
fn convert(node: &mut Node, from: &Schema, to: &'static Schema) {
    if node.schema == from {
        (node.schema, node.word) = (to, to.word);
        let known = |word| to.all_attributes().any(|attribute| attribute.word == word);
        node.attributes.retain(|entry| known(entry.attribute.word));
    }
}

/// Reads the text of nodes without the textures that none of them uses.
fn read_again(nodes: impl Iterator<Item = Node>) -> Result<Scene, ValueError> {
    let nodes: Vec<_> = nodes.collect();
    let used: Vec<_> = nodes.iter().map(image_of).collect();
    let is_idle = |node: &Node| node.schema == &Texture::SCHEMA && !used.contains(&node.name);
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

/// Name of the texture of a surface or projector.
fn image_of(node: &Node) -> Option<String> {
    let image = node.entry("texture")?.value.as_ref()?;
    Some(image.text().to_owned())
}
