//! The files that the rules read.

use std::fs;
use std::path::{Path, PathBuf};

/// A text file of the repository.
pub(crate) struct File {
    /// The path from the root, with `/` between folders.
    pub(crate) path: String,
    pub(crate) text: String,
}

/// The folder that holds `Cargo.toml`.
pub(crate) fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
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
    let mut paths = Vec::new();
    walk(&root().join(folder), &mut paths);
    paths.retain(|path| path.extension().is_some_and(|found| found == extension));
    paths.sort();
    let files = paths.iter().map(|path| File {
        path: from_root(path),
        text: fs::read_to_string(path).unwrap(),
    });
    files.collect()
}

/// The paths of all files and folders of the repository, from the root.
pub(crate) fn all_paths() -> Vec<String> {
    let mut paths = Vec::new();
    walk(root(), &mut paths);
    paths.iter().map(|path| from_root(path)).collect()
}

fn from_root(path: &Path) -> String {
    let path = path.strip_prefix(root()).unwrap();
    path.to_string_lossy().replace('\\', "/")
}

/// Adds a folder's files and folders, but neither build products nor what Git keeps.
fn walk(folder: &Path, paths: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else {
        return;
    };
    for entry in entries {
        let path = entry.unwrap().path();
        if path.ends_with(".git") || path == root().join("target") {
            continue;
        }
        if path.is_dir() {
            walk(&path, paths);
        }
        paths.push(path);
    }
}
