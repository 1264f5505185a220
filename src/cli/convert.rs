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
    /// Scene file; `-` is standard input.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    #[command(flatten)]
    format: input::SceneFormat,
    /// The KDL file to write; `-` is standard output.
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

pub(super) fn run(options: &Options, messages: &Messages) -> Status {
    let (scene, output) = (options.scene.display(), options.output.display());
    if is_same_file(&options.scene, &options.output) {
        messages.error(&format!(
            "error: {output} would replace the scene it is made from"
        ));
        return Status::Usage;
    }
    let reading = match input::read(&options.scene, &options.format.options(), messages) {
        Ok(reading) => reading,
        Err(failure) => return failure.status,
    };
    let to_stdout = options.output.as_os_str() == input::DASH;
    let folder = match options.output.parent() {
        Some(folder) if !to_stdout => folder,
        _ => Path::new(""),
    };
    let text = reading
        .scene
        .to_kdl(false, |texture| name_from(folder, texture));
    let written = if to_stdout {
        messages.result(&text)
    } else {
        save(&options.output, |out| out.write_all(text.as_bytes()))
    };
    if let Err(error) = written {
        messages.error(&format!("error: cannot write {output}: {error}"));
        return Status::Io;
    }
    if !to_stdout {
        messages.note(&format!("{scene} -> {output}"));
    }
    Status::Done
}

fn is_same_file(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
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
