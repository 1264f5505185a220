//! `heliodon convert`.

use std::path::{Path, PathBuf};

use clap::Args;

use super::messages::Messages;
use super::{Status, input};
use crate::film::save;
use crate::texture::Texture;

/// Rewrites a scene as KDL that renders to the same bytes.
///
/// Made for scenes in the course's block grammar; everything that its programs took for granted is
/// written out. Includes are inserted, comments and textures that nothing wears are left out.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    input: input::OneScene,
    /// The KDL file to write; `-` is standard output.
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

pub(super) fn run(options: &Options, messages: &Messages) -> Status {
    let reading = match options.input.read(messages) {
        Ok(reading) => reading,
        Err(failure) => return failure.status,
    };
    let write = |folder: &Path| {
        reading
            .scene
            .to_kdl(false, |texture| name_from(folder, texture))
    };
    if options.output.as_os_str() == input::DASH {
        return messages.result(&write(Path::new("")), Status::Done);
    }
    let output = options.output.display();
    if let Some(part) = input::part_at(&options.output, &options.input.scene, &reading.scene) {
        messages.error(&format!(
            "error: {output} would replace {part}, which the scene is made of"
        ));
        return Status::Usage;
    }
    let text = write(options.output.parent().unwrap_or(Path::new("")));
    if let Err(error) = save(&options.output, |out| out.write_all(text.as_bytes())) {
        messages.error(&format!("error: cannot write {output}: {error}"));
        return Status::Io;
    }
    messages.note(&format!("{} -> {output}", options.input.title()));
    Status::Done
}

/// A texture's file as a scene in this folder names it, with `/` between folders on every system.
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
    let parts = path
        .components()
        .map(|part| part.as_os_str().to_string_lossy());
    parts.collect::<Vec<_>>().join("/").replacen("//", "/", 1)
}
