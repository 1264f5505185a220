//! CONTRIBUTING says how few places a new shape or a new cover touches.

use support::files::{sources, with_slashes};

/// The places that may know triangles, and how many lines each may spend on them.
const PLACES_OF_A_SHAPE: [(&str, usize); 4] = [
    // The module, its name, the variant, and the arms of the closed set.
    ("src/geometry/mod.rs", 9),
    // The import, the schema of five lines and the arm that finds it.
    ("src/surface/plain.rs", 6),
    // The line in the list of nodes.
    ("src/surface/mod.rs", 1),
    // The import and the arm of the reader.
    ("src/read/surfaces.rs", 2),
];

/// The places that may know procedural planes, and how many lines each may spend on them.
const PLACES_OF_A_COVER: [(&str, usize); 2] = [
    // The module, its name and the line in the list of nodes.
    ("src/surface/mod.rs", 3),
    // The import, the arm of the reader and the call of the constructor.
    ("src/read/surfaces.rs", 3),
];

#[test]
fn a_triangle_is_one_file_and_a_few_arms() {
    assert_only_there("triangle", "src/geometry/triangle.rs", &PLACES_OF_A_SHAPE);
}

#[test]
fn a_procedural_plane_is_one_file_one_line_and_one_arm() {
    let own = "src/surface/procedural_plane.rs";
    assert_only_there("procedural", own, &PLACES_OF_A_COVER);
}

/// Fails if a source outside of its own and of the known places has a word in its code.
#[track_caller]
fn assert_only_there(word: &str, own: &str, places: &[(&str, usize)]) {
    for (path, text) in sources("src") {
        let name = with_slashes(&path);
        // The course's grammar has a word of its own for each thing that it can say, and the classic
        // numerics an algorithm for each shape that they know; they need not know all.
        let folders = ["src/read/course/", "src/geometry/classic/"];
        if name == own || folders.iter().any(|folder| name.starts_with(folder)) {
            continue;
        }
        let code = text
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"));
        let lines: Vec<_> = code
            .filter(|line| line.to_lowercase().contains(word))
            .collect();
        let allowed = places
            .iter()
            .find(|(place, _)| *place == name)
            .map_or(0, |(_, count)| *count);
        assert!(lines.len() <= allowed, "{name} knows {word}: {lines:#?}");
    }
}
