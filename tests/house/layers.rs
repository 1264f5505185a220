//! The house keeps its floors: imports run downward, files stay small.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use support::files::with_slashes;

use super::imports::{Files, ReExports, circles};

/// The rooms on each floor, lowest first. Rooms on one floor do not import from each other.
const FLOORS: &[&[&str]] = &[
    &["language"],
    &["math", "image_file"],
    &["texture", "film", "camera"],
    &["geometry", "material"],
    &["surface"],
    &["visibility", "light"],
    &["scene"],
    &["read", "plan"],
    &["render"],
    &["measure"],
    &["cli", "doctest"],
];

/// Files that still import from each other: to be untied.
const CIRCLES: &[&[&str]] = &[
    &["cli::error", "cli::input", "cli::messages"],
    &["measure::check", "measure::coincident"],
    &["read::build", "read::surfaces", "read::textures"],
    &["read::course::entities", "read::course::words"],
    &["read::course::entity", "read::course::mistakes"],
    &["texture::decode", "texture::pnm"],
];

/// Files whose types name each other by the names that their folder re-exports.
const CIRCLES_OF_TYPES: &[&[&str]] = &[
    &[
        "film::bit_depth",
        "film::encoded_image",
        "film::format",
        "film::pfm",
        "film::png",
        "film::ppm",
    ],
    &[
        "math::crossing",
        "math::flat",
        "math::limits",
        "math::ray",
        "math::segment",
    ],
    &[
        "measure::cost::blame",
        "measure::cost::measured",
        "measure::cost::pictures",
    ],
    &[
        "measure::explain",
        "measure::light_row",
        "measure::light_tests",
    ],
    &[
        "scene::render_settings",
        "scene::setting",
        "scene::settings",
    ],
];

/// All folders with sources.
const FOLDERS: [&str; 6] = ["src", "tests", "examples", "benches", "oracle", "tools"];

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

/// The files of `src` and what each imports.
fn imports(re_exports: ReExports) -> BTreeMap<String, BTreeSet<String>> {
    let sources = sources();
    let places = sources.iter().map(|(path, text)| {
        let place = path.strip_prefix("src").expect("a path in src");
        (with_slashes(place), text.as_str())
    });
    let places: Vec<_> = places.collect();
    let places = places.iter().map(|(place, text)| (place.as_str(), *text));
    Files::of(places).imports(re_exports)
}

/// Fails if there is a circle that is not a part of a known one.
#[track_caller]
fn assert_no_circles(imports: &BTreeMap<String, BTreeSet<String>>, known: &[&[&str]]) {
    let mut circles = circles(imports);
    circles.retain(|circle| {
        let is_known = known
            .iter()
            .any(|known| circle.iter().all(|file| known.contains(file)));
        !is_known
    });
    let arrows = circles.iter().map(|circle| {
        let arrows = circle.iter().flat_map(|file| {
            let others = imports[*file].iter();
            let others = others.filter(|other| circle.contains(&other.as_str()));
            others.map(move |other| format!("{file} -> {other}\n"))
        });
        arrows.collect::<String>()
    });
    let arrows: Vec<_> = arrows.collect();
    assert!(
        arrows.is_empty(),
        "imports in circles:\n{}",
        arrows.join("\n")
    );
}

#[test]
fn no_files_import_from_each_other() {
    assert_no_circles(&imports(ReExports::Are), CIRCLES);
}

#[test]
fn types_name_each_other_in_known_files_only() {
    let known = [CIRCLES, CIRCLES_OF_TYPES].concat();
    assert_no_circles(&imports(ReExports::StandFor), &known);
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
    let lengths: Vec<_> = FOLDERS
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
    let files = support::files::sources(folder);
    assert!(!files.is_empty(), "{folder} has no sources");
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
