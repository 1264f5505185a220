//! The texts of a scene and where the files that they name are looked for.

use std::path::{Path, PathBuf};

use crate::language::{Source, Sources};

/// The texts of a scene, each with the directories that its file names start from.
#[derive(Debug, Default)]
pub struct Files {
    sources: Sources,
    directories: Vec<Vec<PathBuf>>,
}

impl Files {
    /// Adds a text and gives its index.
    pub(super) fn add(&mut self, source: Source, directories: Vec<PathBuf>) -> usize {
        self.directories.push(directories);
        self.sources.add(source)
    }

    /// The text with this index.
    #[must_use]
    pub fn get(&self, index: usize) -> &Source {
        self.sources.get(index)
    }

    /// All texts.
    #[must_use]
    pub fn sources(&self) -> &Sources {
        &self.sources
    }

    /// The texts alone.
    #[must_use]
    pub fn into_sources(self) -> Sources {
        self.sources
    }

    /// The path of a file that a text names: in the first directory that has it, or else in the
    /// first.
    #[must_use]
    pub fn locate(&self, source: usize, file: &str) -> PathBuf {
        let candidates: Vec<_> = self.directories[source]
            .iter()
            .map(|directory| directory.join(file))
            .collect();
        let existing = candidates.iter().find(|path| path.exists());
        existing
            .or(candidates.first())
            .cloned()
            .unwrap_or_else(|| Path::new(file).to_owned())
    }
}

/// A scene's text from its bytes; a byte order mark is dropped.
///
/// # Errors
/// What is wrong, in words, if the bytes are no UTF-8 text.
pub(super) fn text_of(bytes: Vec<u8>) -> Result<String, String> {
    let text = String::from_utf8(bytes).map_err(|error| {
        let valid = error.utf8_error().valid_up_to();
        let line = error.as_bytes()[..valid]
            .iter()
            .filter(|byte| **byte == b'\n')
            .count()
            + 1;
        format!("line {line} is not UTF-8 text; is this a scene file?")
    })?;
    Ok(text
        .strip_prefix('\u{feff}')
        .map_or(text.clone(), str::to_owned))
}
