//! Textures from nodes. Only textures in use are decoded, each once.

use std::collections::HashSet;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use glam::DVec2;

use super::files::{Files, nearby, reason};
use super::parts::Parts;
use crate::image_file::{ImageFileError, LONGEST_SIDE, MOST_PIXELS};
use crate::language::{Diagnostic, Node, Value};
use crate::texture::{Texture, TextureMap, Wrap, check, decode};

/// The textures of a scene by name; `None` for one that is unused or has errors.
///
/// The header of an unused file is checked, which finds mistyped file names.
pub(super) fn load<'a>(
    nodes: impl Iterator<Item = &'a Node>,
    used: &HashSet<String>,
    files: &Files,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<(String, Option<Arc<Texture>>)> {
    let mut textures = Vec::new();
    for node in nodes {
        let name = node.name.clone().unwrap_or_default();
        let path = path(node, files);
        let texture = if !node.valid {
            Ok(None)
        } else if used.contains(&name) {
            read(node, &name, &path, files).map(Some)
        } else {
            check(&path).map(|()| None)
        };
        let texture = texture.unwrap_or_else(|error| {
            diagnostics.extend(diagnostic(node, &path, &error));
            None
        });
        textures.push((name, texture));
    }
    textures
}

fn read(
    node: &Node,
    name: &str,
    path: &Path,
    files: &Files,
) -> Result<Arc<Texture>, ImageFileError> {
    let texels = decode(path)?;
    let divisor = node.property("divisor");
    let divisor = divisor.map_or(255.0, |divisor| divisor.number());
    let file = files.name_in_scene(source(node), file(node));
    let texture = Texture::new(name, &file, path.to_owned(), texels, divisor);
    Ok(Arc::new(texture))
}

fn source(node: &Node) -> usize {
    node.location.map_or(0, |at| at.source)
}

fn file(node: &Node) -> &str {
    node.value.as_ref().map_or("", Value::text)
}

fn path(node: &Node, files: &Files) -> PathBuf {
    files.locate(source(node), file(node))
}

fn diagnostic(node: &Node, path: &Path, error: &ImageFileError) -> Option<Diagnostic> {
    let name = path.display();
    let (message, help) = match error {
        ImageFileError::Io(error) if error.kind() == ErrorKind::NotFound => (
            format!("there is no file {name}"),
            nearby(path, "file names are relative to the scene file"),
        ),
        ImageFileError::Io(error) => (
            format!("cannot read {name}: {}", reason(path, error)),
            "name a file that you may read".to_owned(),
        ),
        ImageFileError::Format(reason) => (
            format!("cannot read {name}: {reason}"),
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
            format!("a texture has at most {LONGEST_SIDE} texels a side and {MOST_PIXELS} in all"),
        ),
    };
    Some(Diagnostic::error(node.location?, message, "expected an image file").help(help))
}

/// The texture of a rectangle, and whether the scene gives the size of its texels.
pub(super) fn map(
    node: &Node,
    parts: &Parts,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<(TextureMap, bool)> {
    let texture = parts.textures.find(node, "texture")?;
    let entry = node.entry("texture")?;
    let given = entry.property("texel").map(|texel| texel.pair());
    let mode = entry.property("mode");
    let wrap = mode.and_then(|mode| Wrap::from_word(mode.text()));
    if wrap != Some(Wrap::Repeat) {
        let mut properties = entry.properties.iter();
        let texel = properties.find(|property| property.attribute.word == "texel");
        if let Some(at) = texel.and_then(|texel| texel.location) {
            let message = "`texel` has no effect on a clamped texture";
            let error = Diagnostic::error(at, message, "expected only with `mode=\"repeat\"`");
            diagnostics.push(error.help("remove `texel`, or add `mode=\"repeat\"`"));
        }
        return Some((TextureMap::clamp(texture, node.pair("dimensions")), false));
    }
    let Some(texel) = given.or(parts.pixel_size) else {
        if let Some(at) = entry.location {
            let message = "the repeated texture has no texel size";
            let label = "expected `texel=…`; a camera with `look-at` gives no default";
            let error = Diagnostic::error(at, message, label);
            diagnostics.push(error.help("add the world size of one texel, such as `texel=0.01`"));
        }
        return None;
    };
    let texel = DVec2::new(texel.x, texel.y);
    Some((TextureMap::repeat(texture, texel), given.is_some()))
}
