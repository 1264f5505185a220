//! Readers from text to scene: two languages, one builder.

mod build;
mod check;
mod course;
mod entries;
mod errors;
mod files;
mod include;
mod kdl;
mod lights;
mod names;
mod options;
mod parts;
mod pieces;
mod rules;
mod say;
mod schemas;
mod surfaces;
mod syntax;
mod textures;
mod unknown;

pub use errors::{MOST_ERRORS, SceneError};
pub use files::bytes_from;
pub use options::{Language, Options};
pub use schemas::schemas;

use std::io;
use std::path::{Path, PathBuf};

use crate::language::{Diagnostic, Source};
use crate::scene::Scene;
use files::Files;
use kdl::Nodes;

/// A scene, and the warnings about its text.
#[derive(Debug)]
pub struct Reading {
    /// The scene.
    pub scene: Scene,
    /// The language of its text.
    pub language: Language,
    /// The warnings.
    pub warnings: Vec<Diagnostic>,
}

/// Reads a scene file.
///
/// # Errors
/// Returns the file system's error, or a [`SceneError`] for a text that is no valid scene.
pub fn read_file(path: &Path, options: &Options) -> io::Result<Result<Reading, SceneError>> {
    let bytes = files::bytes_of(path)?;
    let directory = path.parent().map(Path::to_owned).unwrap_or_default();
    let name = path.display().to_string();
    Ok(read_bytes(&name, bytes, directory, options))
}

/// Reads a scene from bytes.
///
/// `name` is the file's name in messages. File names in the scene are relative to `directory`.
///
/// # Errors
/// Returns an error for a text that is no valid scene.
pub fn read_bytes(
    name: &str,
    bytes: Vec<u8>,
    directory: PathBuf,
    options: &Options,
) -> Result<Reading, SceneError> {
    let is_picture = image::guess_format(&bytes).is_ok();
    let decoded = files::text_of(bytes);
    let text = decoded.as_deref().unwrap_or_default();
    let language = options.language.unwrap_or_else(|| Language::of(text));
    let directories = match language {
        Language::Kdl => vec![directory],
        // Course scenes name textures relative to the program's working directory.
        Language::Course => vec![directory, PathBuf::new()],
    };
    let source = Source {
        name: name.to_owned(),
        text: text.into(),
        included_at: None,
    };
    let mut files = Files::default();
    let source = files.add(source, directories);
    if let Err(line) = decoded {
        let error = if is_picture {
            errors::without_place(format!("{name} is a picture, not a scene"))
        } else {
            let error = errors::without_place(files::not_utf8(name, line));
            error.help(files::SAVE_AS_UTF8)
        };
        return Err(SceneError::new(vec![error], vec![], files.into_sources()));
    }
    let mut diagnostics = Vec::new();
    let nodes = match language {
        Language::Kdl => kdl::read(source, &mut files, &mut diagnostics),
        Language::Course => Nodes {
            nodes: course::read(source, &files, &mut diagnostics),
            complete: true,
        },
    };
    let built = build::scene(&nodes, options, files, &mut diagnostics);
    let (errors, warnings) = errors::sorted(diagnostics);
    match built {
        Ok(scene) if errors.is_empty() => Ok(Reading {
            scene,
            language,
            warnings,
        }),
        Ok(Scene { sources, .. }) | Err(sources) => Err(SceneError::new(errors, warnings, sources)),
    }
}
