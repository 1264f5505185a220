//! Scenes from files and from standard input.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::Status;
use super::messages::{Messages, problems_json};
use crate::language::ValueError;
use crate::read::{Language, Options, Reading, SceneError, bytes_from, read_bytes, read_file};
use crate::scene::Scene;

/// The word for standard input and standard output.
pub(super) const DASH: &str = "-";

/// Which language a scene is written in.
#[derive(Debug, Clone, Copy, Args)]
pub(super) struct SceneFormat {
    /// Language of the scenes; recognised by content if not given.
    #[arg(long, value_name = "FORMAT", value_enum)]
    format: Option<LanguageWord>,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum LanguageWord {
    /// KDL.
    Kdl,
    /// The course's block grammar.
    Course,
}

/// The scene that a command is about.
#[derive(Debug, Args)]
pub(super) struct OneScene {
    /// Scene file; `-` is standard input.
    #[arg(value_name = "SCENE")]
    pub(super) scene: PathBuf,
    #[command(flatten)]
    format: SceneFormat,
}

impl OneScene {
    /// The reader's options.
    pub(super) fn options(&self) -> Options {
        self.format.options()
    }

    /// Reads it with no other options than its own.
    pub(super) fn read(&self, messages: &Messages) -> Result<Reading, ReadError> {
        read(&self.scene, &self.options(), messages)
    }

    /// What messages call it.
    pub(super) fn title(&self) -> String {
        title(&self.scene)
    }
}

/// Reads a scene; what is wrong with it is shown, and gives the status to end with.
pub(super) fn read(
    scene: &Path,
    options: &Options,
    messages: &Messages,
) -> Result<Reading, ReadError> {
    let read = if scene.as_os_str() == DASH {
        let bytes = bytes_from(std::io::stdin().lock());
        bytes.map(|bytes| read_bytes("stdin", bytes, PathBuf::new(), options))
    } else {
        read_file(scene, options)
    };
    match read {
        Ok(Ok(reading)) => {
            messages.problems(&reading.warnings, &reading.scene.sources);
            // A scene that makes no sense by itself has been rejected.
            if let Err(ValueError { reason, advice, .. }) = reading.scene.settings.check() {
                let error = format!("{}: {reason}; {advice}", title(scene));
                return Err(ReadError::new(Status::Usage, error, messages));
            }
            Ok(reading)
        }
        Ok(Err(scene_error)) => {
            messages.problems(&scene_error.diagnostics, &scene_error.sources);
            Err(ReadError {
                status: Status::BadInput,
                scene_error: Some(scene_error),
                error: None,
            })
        }
        Err(error) => {
            let error = format!("cannot read {}: {error}", title(scene));
            Err(ReadError::new(Status::Io, error, messages))
        }
    }
}

/// The file of a scene, a text or a texture, that lies at a path.
pub(super) fn part_at(path: &Path, file: &Path, scene: &Scene) -> Option<String> {
    let place = path.canonicalize().ok()?;
    let texts = scene
        .sources
        .iter()
        .skip(1)
        .map(|source| PathBuf::from(&source.name));
    let textures = scene.textures.iter().map(|texture| texture.path.clone());
    let mut parts = std::iter::once(file.to_owned())
        .chain(texts)
        .chain(textures);
    let part = parts.find(|part| part.canonicalize().is_ok_and(|part| part == place))?;
    Some(part.display().to_string())
}

/// What messages call a scene.
pub(super) fn title(scene: &Path) -> String {
    if scene.as_os_str() == DASH {
        "stdin".to_owned()
    } else {
        scene.display().to_string()
    }
}

/// Why a scene could not be read; already shown.
#[derive(Debug)]
pub(super) struct ReadError {
    pub(super) status: Status,
    scene_error: Option<SceneError>,
    error: Option<String>,
}

impl ReadError {
    /// A failure that is no mistake in a scene's text; says so.
    pub(super) fn new(status: Status, error: String, messages: &Messages) -> Self {
        messages.error(&format!("error: {error}"));
        Self {
            status,
            scene_error: None,
            error: Some(error),
        }
    }

    /// The failure as one line of JSON.
    pub(super) fn json(&self, scene: &Path) -> String {
        let scene_error = self.scene_error.as_ref();
        let problems = scene_error.map(|no| problems_json(&no.diagnostics, &no.sources));
        let line = serde_json::json!({
            "scene": title(scene),
            "exit": self.status.code(),
            "error": self.error,
            "problems": problems.unwrap_or_default(),
        });
        format!("{line}\n")
    }
}

impl SceneFormat {
    /// The reader's options.
    pub(super) fn options(self) -> Options {
        let language = self.format.map(|word| match word {
            LanguageWord::Kdl => Language::Kdl,
            LanguageWord::Course => Language::Course,
        });
        Options {
            language,
            ..Options::default()
        }
    }
}
