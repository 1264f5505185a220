//! Scenes from files and from standard input.

use std::path::{Path, PathBuf};

use clap::Args;

use super::Status;
use super::error::CommandError;
use super::format_word::LanguageWord;
use super::messages::Messages;
use crate::read::{Options, Reading, bytes_from, read_bytes, read_file};
use crate::scene::Scene;

/// The word for standard input and standard output.
pub(super) const DASH: &str = "-";

/// The option for the language of scenes.
#[derive(Debug, Clone, Copy, Args)]
pub(super) struct SceneFormat {
    /// Language of the scene; recognised by its content if not given.
    #[arg(long, value_name = "FORMAT", value_enum)]
    format: Option<LanguageWord>,
}

impl SceneFormat {
    /// The reader's options.
    pub(super) fn options(self) -> Options {
        Options {
            language: self.format.map(LanguageWord::language),
            ..Options::default()
        }
    }
}

/// The argument of a command about one scene.
#[derive(Debug, Args)]
pub(super) struct OneScene {
    /// Scene file; `-` reads standard input.
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

    /// Reads the scene with no other options than its own.
    pub(super) fn read(&self, messages: &Messages) -> Result<Reading, CommandError> {
        read(&self.scene, &self.options(), messages)
    }

    /// The scene's name in messages.
    pub(super) fn title(&self) -> String {
        title(&self.scene)
    }
}

/// Reads a scene, and prints its warnings.
pub(super) fn read(
    scene: &Path,
    options: &Options,
    messages: &Messages,
) -> Result<Reading, CommandError> {
    let read = if scene.as_os_str() == DASH {
        let bytes = bytes_from(std::io::stdin().lock());
        bytes.map(|bytes| read_bytes("stdin", bytes, PathBuf::new(), options))
    } else {
        read_file(scene, options)
    };
    let title = title(scene);
    let reading = read
        .map_err(|error| CommandError::io(format!("cannot read {title}: {error}")))?
        .map_err(CommandError::scene)?;
    messages.problems(&reading.warnings, &reading.scene.sources);
    // The scene's own settings have been checked, so the command line is at fault.
    let settings = reading.scene.settings.check();
    settings.map_err(|error| CommandError::value(Status::Usage, &title, &error))?;
    Ok(reading)
}

/// The name of a scene's file, text or texture, if it lies at this path.
pub(super) fn part_at(path: &Path, file: &Path, scene: &Scene) -> Option<String> {
    let place = path.canonicalize().ok()?;
    let included = scene.sources.iter().skip(1);
    let included = included.map(|source| PathBuf::from(&source.name));
    let textures = scene.textures.iter().map(|texture| texture.path.clone());
    let mut parts = std::iter::once(file.to_owned())
        .chain(included)
        .chain(textures);
    let part = parts.find(|part| part.canonicalize().is_ok_and(|part| part == place))?;
    Some(part.display().to_string())
}

/// The name of a scene in messages.
pub(super) fn title(scene: &Path) -> String {
    if scene.as_os_str() == DASH {
        "stdin".to_owned()
    } else {
        scene.display().to_string()
    }
}
