//! Texture files: only those in use are decoded, each once.

use std::collections::HashSet;
use std::sync::Arc;

use glam::DVec2;

use super::{Files, build::Parts};
use crate::language::{Node, Problem, Value};
use crate::texture::{DecodeError, Texture, TextureMap, check, decode};

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
    Ok(Texture::new(name, file(node), path, texels, divisor))
}

fn file(node: &Node) -> &str {
    node.value.as_ref().map_or("", Value::text)
}

fn path(node: &Node, files: &Files) -> std::path::PathBuf {
    files.locate(node.location.map_or(0, |at| at.source), file(node))
}

fn report(node: &Node, error: &DecodeError, problems: &mut Vec<Problem>) {
    let Some(at) = node.location else { return };
    let help = match error {
        DecodeError::Io { source, .. } if source.kind() == std::io::ErrorKind::NotFound => {
            "file names are relative to the scene file; is it spelled right?"
        }
        DecodeError::Io { .. } => "the file must be one that you may read",
        DecodeError::Format { .. } => "textures are PNG, JPEG, PPM or PGM files",
        DecodeError::Empty { .. } => "a texture needs at least one pixel",
    };
    problems.push(Problem::error(at, error.to_string(), "needed by this texture").help(help));
}

/// The texture of a rectangle, and whether the scene gives the size of its texels.
pub(super) fn map(
    node: &Node,
    parts: &Parts,
    problems: &mut Vec<Problem>,
) -> Option<(TextureMap, bool)> {
    let texture = parts.textures.find(node, "texture", problems)?;
    let entry = node.entry("texture")?;
    let given = entry.property("texel").map(|texel| texel.pair());
    let repeat = entry
        .property("mode")
        .is_some_and(|mode| mode.text() == "repeat");
    if !repeat {
        if given.is_some()
            && let Some(at) = entry.location
        {
            let message = "`texel` means nothing to a texture that is clamped";
            let problem = Problem::error(at, message, "stretched over the whole surface");
            problems.push(problem.help("remove `texel`, or say `mode=\"repeat\"`"));
        }
        return Some((TextureMap::clamp(texture, node.pair("dimensions")), false));
    }
    let Some(texel) = given.or(parts.pixel_size) else {
        if let Some(at) = entry.location {
            let problem = Problem::error(
                at,
                "a repeated texture needs the size of its texels",
                "this camera has no screen that could give one",
            );
            problems.push(problem.help("add `texel=0.01`: the world size of one texel"));
        }
        return None;
    };
    Some((
        TextureMap::repeat(texture, DVec2::new(texel.x, texel.y)),
        given.is_some(),
    ))
}
