//! The texts of a scene and where the files that they name are looked for.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use crate::language::{Source, Sources, did_you_mean};

/// The texts of a scene, each with the directories that its file names start from.
#[derive(Debug, Default)]
pub struct Files {
    sources: Sources,
    directories: Vec<Vec<PathBuf>>,
    /// Which file each text is, whatever it is called; `None` if it is none.
    identities: Vec<Option<PathBuf>>,
}

impl Files {
    /// Adds a text and gives its index.
    pub(super) fn add(&mut self, source: Source, directories: Vec<PathBuf>) -> usize {
        self.directories.push(directories);
        self.identities
            .push(Path::new(&source.name).canonicalize().ok());
        self.sources.add(source)
    }

    /// The text with this index.
    #[must_use]
    pub fn get(&self, index: usize) -> &Source {
        self.sources.get(index)
    }

    /// Whether a text is, or is included by, the file of this path.
    pub(super) fn is_within(&self, source: usize, path: &Path) -> bool {
        let included_at = |source: &usize| Some(self.get(*source).included_at?.source);
        let Ok(identity) = path.canonicalize() else {
            return false;
        };
        std::iter::successors(Some(source), included_at)
            .any(|source| self.identities[source].as_ref() == Some(&identity))
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

    /// What the scene file itself would call a file that a text of it names.
    #[must_use]
    pub fn name_in_scene(&self, source: usize, file: &str) -> String {
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
/// The file system's, and one for a file that is far too large for a scene.
pub(super) fn bytes_of(path: &Path) -> io::Result<Vec<u8>> {
    bytes_from(File::open(path)?)
}

/// The bytes of a scene from any reader.
///
/// # Errors
/// The reader's, and one for a text that has no end or is far too large for a scene.
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

/// A scene's text from its bytes; a byte order mark is dropped.
///
/// # Errors
/// The first line that is not UTF-8.
pub(super) fn text_of(bytes: Vec<u8>) -> Result<String, usize> {
    let mut text = String::from_utf8(bytes).map_err(|error| {
        let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        valid.iter().filter(|byte| **byte == b'\n').count() + 1
    })?;
    // What some editors begin a file with says nothing.
    if text.starts_with('\u{feff}') {
        text.remove(0);
    }
    Ok(text)
}

/// Why a file cannot be read, in words that are the same on every system where that is possible.
pub(super) fn reason(path: &Path, error: &io::Error) -> String {
    if path.is_dir() {
        "it is a folder".to_owned()
    } else if error.kind() == io::ErrorKind::PermissionDenied {
        "it may not be read".to_owned()
    } else {
        error.to_string()
    }
}

/// Advice about a file that is missing: one of its folder with nearly the same name, or else `otherwise`.
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
    // A scene is never meant where a texture is, nor the other way round.
    let is_scene = |name: &Path| name.extension().is_some_and(|ending| ending == "kdl");
    names.retain(|name| is_scene(Path::new(name)) == is_scene(path));
    names.sort_unstable();
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    match did_you_mean(&name, names.iter().map(String::as_str)) {
        Some(near) => format!("did you mean {near:?}?"),
        None => otherwise.to_owned(),
    }
}
