//! Source texts of a scene, and the files that they name.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use crate::language::{Source, Sources, did_you_mean};

/// The texts of a scene, each with the directories for its file names.
#[derive(Debug, Default)]
pub(super) struct Files {
    sources: Sources,
    directories: Vec<Vec<PathBuf>>,
    /// The canonical path of each text; `None` if it was not read from a file.
    canonical: Vec<Option<PathBuf>>,
}

impl Files {
    /// Adds a text and returns its index.
    pub(super) fn add(&mut self, source: Source, directories: Vec<PathBuf>) -> usize {
        self.directories.push(directories);
        let canonical = Path::new(&source.name).canonicalize().ok();
        self.canonical.push(canonical);
        self.sources.add(source)
    }

    /// The text with this index.
    pub(super) fn get(&self, index: usize) -> &Source {
        self.sources.get(index)
    }

    /// True if a text is, or is included by, the file of a path.
    pub(super) fn is_within(&self, source: usize, path: &Path) -> bool {
        let included_at = |source: &usize| Some(self.get(*source).included_at?.source);
        let Ok(canonical) = path.canonicalize() else {
            return false;
        };
        std::iter::successors(Some(source), included_at)
            .any(|source| self.canonical[source].as_ref() == Some(&canonical))
    }

    /// All texts.
    pub(super) fn sources(&self) -> &Sources {
        &self.sources
    }

    /// The texts without their directories.
    pub(super) fn into_sources(self) -> Sources {
        self.sources
    }

    /// The path of a file that a text names.
    ///
    /// It is in the first directory that has such a file, or else in the first directory.
    pub(super) fn locate(&self, source: usize, file: &str) -> PathBuf {
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

    /// The name of a file relative to the scene file, from its name in a text.
    pub(super) fn name_in_scene(&self, source: usize, file: &str) -> String {
        if source == 0 {
            return file.to_owned();
        }
        let path = self.locate(source, file);
        let directory = self.directories[0].first();
        let relative = directory.and_then(|directory| path.strip_prefix(directory).ok());
        relative.unwrap_or(&path).display().to_string()
    }
}

/// The bytes of a scene file.
///
/// # Errors
/// Returns the file system's error, or one for a file above 256 MiB.
pub(super) fn bytes_of(path: &Path) -> io::Result<Vec<u8>> {
    bytes_from(File::open(path)?)
}

/// The bytes of a scene from a reader.
///
/// # Errors
/// Returns the reader's error, or one for a text above 256 MiB.
pub fn bytes_from(reader: impl Read) -> io::Result<Vec<u8>> {
    const MOST: u64 = 1 << 28;
    let mut bytes = Vec::new();
    reader.take(MOST + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MOST {
        let reason = format!("it has more than {} MiB", MOST >> 20);
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, reason));
    }
    Ok(bytes)
}

/// A text from its bytes, without a byte order mark.
///
/// # Errors
/// Returns the number of the first line that is not UTF-8.
pub(super) fn text_of(bytes: Vec<u8>) -> Result<String, usize> {
    let mut text = String::from_utf8(bytes).map_err(|error| {
        let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        valid.iter().filter(|byte| **byte == b'\n').count() + 1
    })?;
    if text.starts_with('\u{feff}') {
        text.remove(0);
    }
    Ok(text)
}

/// Advice about a text in another encoding.
pub(super) const SAVE_AS_UTF8: &str = "save it as UTF-8, if it is a scene file";

/// The message about a text in another encoding.
pub(super) fn not_utf8(name: &str, line: usize) -> String {
    format!("line {line} of {name} is not UTF-8")
}

/// The error of a file system in words, equal on all systems where possible.
pub(super) fn reason(path: &Path, error: &io::Error) -> String {
    if path.is_dir() {
        "it is a folder".to_owned()
    } else if error.kind() == io::ErrorKind::PermissionDenied {
        "it may not be read".to_owned()
    } else {
        error.to_string()
    }
}

/// Advice about a missing file: a similar name in its folder, or else `otherwise`.
pub(super) fn nearby(path: &Path, otherwise: &str) -> String {
    let folder = match path.parent() {
        Some(parent) if parent.as_os_str().is_empty() => Path::new("."),
        Some(parent) => parent,
        None => return otherwise.to_owned(),
    };
    let mut names: Vec<_> = std::fs::read_dir(folder)
        .into_iter()
        .flatten()
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .collect();
    // A scene is no suggestion for a texture, and a texture none for a scene.
    let is_scene = |name: &Path| name.extension().is_some_and(|ending| ending == "kdl");
    names.retain(|name| is_scene(Path::new(name)) == is_scene(path));
    names.sort_unstable();
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    match did_you_mean(&name, names.iter().map(String::as_str)) {
        Some(near) => format!("did you mean {near:?}?"),
        None => otherwise.to_owned(),
    }
}
