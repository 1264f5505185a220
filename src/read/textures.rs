//! Texture files: only those in use are decoded, each once.

use std::collections::HashSet;
use std::io::ErrorKind;
use std::sync::Arc;

use glam::DVec2;

use super::{Files, build::Parts, files};
use crate::language::{Node, Problem, Value};
use crate::texture::{
    DecodeError, ImageFileError, LONGEST_SIDE, MOST_TEXELS, Texture, TextureMap, Wrap, check,
    decode,
};

/// The textures of a scene by name; `None` for one that is not used or cannot be read.
///
/// Of an unused one only the header is looked at, so that a mistyped file name is still found.
pub(super) fn load<'a>(
    nodes: impl Iterator<Item = &'a Node>,
    used: &HashSet<String>,
    files: &Files,
    problems: &mut Vec<Problem>,
) -> Vec<(String, Option<Arc<Texture>>)> {
    let mut textures = Vec::new();
    for node in nodes {
        let name = node.name.clone().unwrap_or_default();
        if !node.sound {
            textures.push((name, None));
            continue;
        }
        let texture = if used.contains(&name) {
            read(node, &name, files).map(|texture| Some(Arc::new(texture)))
        } else {
            check(&path(node, files)).map(|()| None)
        };
        textures.push((
            name,
            texture.unwrap_or_else(|error| {
                report(node, &error, problems);
                None
            }),
        ));
    }
    textures
}

fn read(node: &Node, name: &str, files: &Files) -> Result<Texture, DecodeError> {
    let path = path(node, files);
    let texels = decode(&path)?;
    let divisor = node
        .property("divisor")
        .map_or(255.0, |divisor| divisor.number());
    let source = node.location.map_or(0, |at| at.source);
    let file = files.name_in_scene(source, file(node));
    Ok(Texture::new(name, &file, path, texels, divisor))
}

fn file(node: &Node) -> &str {
    node.value.as_ref().map_or("", Value::text)
}

fn path(node: &Node, files: &Files) -> std::path::PathBuf {
    files.locate(node.location.map_or(0, |at| at.source), file(node))
}

fn report(node: &Node, DecodeError { path, fault }: &DecodeError, problems: &mut Vec<Problem>) {
    let Some(at) = node.location else { return };
    let name = path.display();
    let (message, help) = match fault {
        ImageFileError::Io(error) if error.kind() == ErrorKind::NotFound => (
            format!("there is no file {name}"),
            files::nearby(path, "file names are relative to the scene file"),
        ),
        ImageFileError::Io(error) => (
            format!("cannot read {name}: {}", files::reason(path, error)),
            "name a file that you may read".to_owned(),
        ),
        ImageFileError::Format(reason) => (
            format!("{name} is not a texture: {reason}"),
            "textures are PNG, JPEG, PPM and PGM files".to_owned(),
        ),
        ImageFileError::Damaged(reason) => (
            format!("{name} is damaged: {reason}"),
            "write or copy the file again".to_owned(),
        ),
        ImageFileError::Empty(width, height) => (
            format!("{name} is empty: {width} by {height} texels"),
            "a texture has at least one texel".to_owned(),
        ),
        ImageFileError::TooLarge(width, height) => (
            format!("{name} is too large: {width} by {height} texels"),
            format!("a texture has at most {LONGEST_SIDE} texels a side and {MOST_TEXELS} in all"),
        ),
    };
    problems.push(Problem::error(at, message, "expected an image file").help(help));
}

/// The texture of a rectangle, and whether the scene gives the size of its texels.
pub(super) fn map(
    node: &Node,
    parts: &Parts,
    problems: &mut Vec<Problem>,
) -> Option<(TextureMap, bool)> {
    let texture = parts.textures.find(node, "texture")?;
    let entry = node.entry("texture")?;
    let given = entry.property("texel").map(|texel| texel.pair());
    let mode = entry.property("mode");
    let wrap = mode.and_then(|mode| Wrap::from_word(mode.text()));
    if wrap != Some(Wrap::Repeat) {
        let stray = entry
            .properties
            .iter()
            .find(|given| given.attribute.word == "texel");
        if let Some(at) = stray.and_then(|stray| stray.location) {
            let message = "`texel` means nothing to a texture that is clamped";
            let problem = Problem::error(at, message, "expected only with `mode=\"repeat\"`");
            problems.push(problem.help("remove `texel`, or add `mode=\"repeat\"`"));
        }
        return Some((TextureMap::clamp(texture, node.pair("dimensions")), false));
    }
    let Some(texel) = given.or(parts.pixel_size) else {
        if let Some(at) = entry.location {
            let message = "a repeated texture lacks the size of its texels";
            let label = "expected `texel=…`, as the camera has no `screen` to take it from";
            let problem = Problem::error(at, message, label);
            problems.push(problem.help("add the world size of one texel, such as `texel=0.01`"));
        }
        return None;
    };
    Some((
        TextureMap::repeat(texture, DVec2::new(texel.x, texel.y)),
        given.is_some(),
    ))
}
