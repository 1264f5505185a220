//! The house keeps its floors: imports run downward, files stay small.

use std::fs;
use std::path::{Path, PathBuf};

/// The rooms on each floor, lowest first. Rooms on one floor do not know each other, except that
/// `math` may refuse in the words of `language`.
const FLOORS: &[&[&str]] = &[
    &["language"],
    &["math", "image_file"],
    &["texture", "film", "camera"],
    &["material"],
    &["surface"],
    &["light", "accel"],
    &["scene"],
    &["read", "plan"],
    &["render"],
    &["measure"],
    &["cli", "doctest"],
];

const LONGEST_FILE: usize = 400;
const USUAL_LENGTH: usize = 150;

#[test]
fn imports_run_downward() {
    let mut wrong = Vec::new();
    for (path, text) in sources() {
        let room = room_of(&path);
        let Some(floor) = floor_of(&room) else {
            continue;
        };
        for import in imported_rooms(&text) {
            let below = floor_of(&import).is_some_and(|imported| imported < floor);
            if !below && import != room {
                wrong.push(format!("{} imports {import}", path.display()));
            }
        }
    }
    assert!(
        wrong.is_empty(),
        "imports must run to lower floors:\n{}",
        wrong.join("\n")
    );
}

#[test]
fn every_room_has_a_floor() {
    for (path, _) in sources() {
        let room = room_of(&path);
        let known = ["lib", "main"].contains(&room.as_str()) || floor_of(&room).is_some();
        assert!(known, "{} is on no floor", path.display());
    }
}

#[test]
fn files_are_short() {
    let lengths: Vec<_> = ["src", "tests", "examples", "benches"]
        .into_iter()
        .flat_map(sources_in)
        .map(|(path, text)| (text.lines().count(), path))
        .collect();
    let long: Vec<_> = lengths
        .iter()
        .filter(|(lines, _)| *lines > LONGEST_FILE)
        .collect();
    assert!(
        long.is_empty(),
        "files above {LONGEST_FILE} lines: {long:?}"
    );
    let short = lengths
        .iter()
        .filter(|(lines, _)| *lines <= USUAL_LENGTH)
        .count();
    assert!(
        2 * short > lengths.len(),
        "most files should be below {USUAL_LENGTH} lines"
    );
}

fn sources() -> Vec<(PathBuf, String)> {
    sources_in("src")
}

fn sources_in(folder: &str) -> Vec<(PathBuf, String)> {
    let mut folders = vec![PathBuf::from(folder)];
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a folder of the project") {
            let path = entry.expect("a file of the project").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = fs::read_to_string(&path).expect("source text");
                files.push((path, text));
            }
        }
    }
    assert!(files.len() > 3, "the sources were not found");
    files
}

/// The folder or file under `src` that a source belongs to.
fn room_of(path: &Path) -> String {
    let below = path.strip_prefix("src").expect("a path in src");
    let first = below.iter().next().expect("a file name").to_string_lossy();
    first.trim_end_matches(".rs").to_owned()
}

fn floor_of(room: &str) -> Option<usize> {
    FLOORS.iter().position(|rooms| rooms.contains(&room))
}

/// The rooms that a source names by `crate::`, outside of comments.
fn imported_rooms(text: &str) -> Vec<String> {
    let code = text
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"));
    let named = code.flat_map(|line| line.split("crate::").skip(1));
    named
        .map(|rest| {
            let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
            rest[..end.unwrap_or(rest.len())].to_owned()
        })
        .collect()
}
