//! Files of the repository.

use std::fs;
use std::path::{Path, PathBuf};

/// A file or folder of this repository.
#[must_use]
pub fn repository(path: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2);
    root.expect("the folder above tests").join(path)
}

/// All files in a folder and the folders below it, sorted; without build products and what Git
/// keeps.
///
/// # Panics
///
/// Panics if a folder cannot be read, as all functions of this file do.
#[must_use]
pub fn walk(folder: impl AsRef<Path>) -> Vec<PathBuf> {
    let mut folders = vec![folder.as_ref().to_owned()];
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        let (below, here): (Vec<_>, Vec<_>) =
            entries(folder).into_iter().partition(|path| path.is_dir());
        let is_made = |folder: &PathBuf| folder.ends_with("target") || folder.ends_with(".git");
        folders.extend(below.into_iter().filter(|folder| !is_made(folder)));
        files.extend(here);
    }
    files.sort();
    files
}

/// The files directly in a folder that have this extension, sorted.
#[must_use]
pub fn files(folder: impl AsRef<Path>, extension: &str) -> Vec<PathBuf> {
    let mut files = entries(folder);
    files.retain(|path| path.extension().is_some_and(|found| found == extension));
    files
}

/// All Rust sources below a folder with their texts, sorted.
#[must_use]
pub fn sources(folder: impl AsRef<Path>) -> Vec<(PathBuf, String)> {
    let mut files = walk(folder);
    files.retain(|path| path.extension().is_some_and(|found| found == "rs"));
    let read = |path: PathBuf| {
        let text = fs::read_to_string(&path);
        let text = text.unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        (path, text)
    };
    files.into_iter().map(read).collect()
}

/// The file's name without its folder and extension.
#[must_use]
pub fn stem(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}

/// The path with `/` between its parts on every system.
#[must_use]
pub fn with_slashes(path: &Path) -> String {
    path.to_string_lossy().replace('\\', "/")
}

/// Copies a file, or a folder with all that is in it.
///
/// # Panics
///
/// Panics if anything cannot be read or written.
pub fn copy(from: &Path, to: &Path) {
    if from.is_dir() {
        fs::create_dir(to).expect("a new folder");
        for entry in entries(from) {
            copy(&entry, &to.join(entry.file_name().expect("a name")));
        }
    } else {
        fs::copy(from, to).expect("a copy");
    }
}

/// The files and folders directly in a folder, sorted.
#[must_use]
pub fn entries(folder: impl AsRef<Path>) -> Vec<PathBuf> {
    let folder = folder.as_ref();
    let entries = fs::read_dir(folder);
    let entries = entries.unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<_> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    paths
}
