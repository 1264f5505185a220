//! `heliodon convert`.

use std::path::{Path, PathBuf};

use clap::Args;

use super::error::CommandError;
use super::messages::Messages;
use super::{Status, input};
use crate::film::save;
use crate::texture::Texture;

/// Convert a scene to KDL that renders to the same bytes.
///
/// Made for scenes in the course's block grammar: everything that its programs assumed is written
/// out. Includes are inserted; comments and unused textures are left out.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    input: input::OneScene,
    /// KDL file to write; `-` writes to standard output.
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

pub(super) fn run(options: &Options, messages: &Messages) -> Status {
    let text = convert(options, messages).map(|text| (text, Status::Done));
    messages.finish(&options.input.scene, false, text)
}

/// Writes the scene to its file, or returns the text for standard output.
fn convert(options: &Options, messages: &Messages) -> Result<String, CommandError> {
    let (input, output) = (&options.input, &options.output);
    let scene = input.read(messages)?.scene;
    let write = |folder: &Path| scene.to_kdl(false, |texture| name_from(folder, texture));
    if output.as_os_str() == input::DASH {
        return Ok(write(Path::new("")));
    }
    let name = output.display();
    if let Some(part) = input::part_at(output, &input.scene, &scene) {
        let reason = format!("{name} would replace {part}, which the scene uses");
        return Err(CommandError::usage(reason));
    }
    let text = write(output.parent().unwrap_or(Path::new("")));
    let saved = save(output, |out| out.write_all(text.as_bytes()));
    saved.map_err(|error| CommandError::write(&name, error))?;
    messages.note(&format!("{} -> {name}", input.title()));
    Ok(String::new())
}

/// A texture's file relative to a scene in this folder, with `/` between folders on every system.
pub(super) fn name_from(folder: &Path, texture: &Texture) -> String {
    let here = Path::new(".");
    let folder = if folder.as_os_str().is_empty() {
        here
    } else {
        folder
    };
    let relative = match (texture.path.canonicalize(), folder.canonicalize()) {
        (Ok(file), Ok(folder)) => pathdiff::diff_paths(file, folder),
        _ => None,
    };
    let path = relative.unwrap_or_else(|| texture.path.clone());
    let parts = path.components();
    let parts = parts.map(|part| part.as_os_str().to_string_lossy());
    parts.collect::<Vec<_>>().join("/").replacen("//", "/", 1)
}
