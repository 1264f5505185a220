//! The files that the rules read.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use support::files::{repository, walk, with_slashes};

/// A text file of the repository.
pub(crate) struct File {
    /// The path from the root, with `/` between folders.
    pub(crate) path: String,
    pub(crate) text: String,
}

/// All markdown files of the repository, by path.
pub(crate) fn markdown() -> Vec<File> {
    found("", "md")
}

/// The pages whose openings are counted: the front pages, and all of `docs`.
pub(crate) fn pages() -> Vec<File> {
    let front = [
        "README.md",
        "CHANGELOG.md",
        "CONTRIBUTING.md",
        "scenes/README.md",
    ];
    let mut files = markdown();
    files.retain(|file| file.path.starts_with("docs/") || front.contains(&file.path.as_str()));
    files
}

/// The JSON schemas of the answers.
pub(crate) fn schemas() -> Vec<File> {
    found("docs", "json")
}

/// All Rust files below a folder of the root, by path; none if there is no such folder.
pub(crate) fn rust(folder: &str) -> Vec<File> {
    found(folder, "rs")
}

fn found(folder: &str, extension: &str) -> Vec<File> {
    let folder = repository(folder);
    let mut paths = if folder.is_dir() {
        walk(folder)
    } else {
        Vec::new()
    };
    paths.retain(|path| path.extension().is_some_and(|found| found == extension));
    let files = paths.iter().map(|path| File {
        path: from_root(path),
        text: fs::read_to_string(path).unwrap(),
    });
    files.collect()
}

/// The paths of all files and folders of the repository, from the root.
pub(crate) fn all_paths() -> BTreeSet<String> {
    let root = repository("");
    let files = walk(&root);
    let paths = files.iter().flat_map(|file| file.ancestors());
    let below = paths.filter(|path| path.starts_with(&root) && *path != root);
    below.map(from_root).collect()
}

fn from_root(path: &Path) -> String {
    with_slashes(path.strip_prefix(repository("")).unwrap())
}
