//! CONTRIBUTING says that a surface is one file, one line in a list and one arm in the reader.

use support::files::{sources, with_slashes};

/// The places that may know triangles, and how many lines each may spend on them.
const PLACES: [(&str, usize); 2] = [
    // The line in the list of surfaces.
    ("src/surface/mod.rs", 1),
    // The import and the arm of the reader.
    ("src/read/surfaces.rs", 3),
];

#[test]
fn a_triangle_is_one_file_one_line_and_one_arm() {
    for (path, text) in sources("src") {
        let name = with_slashes(&path);
        // The course's grammar has a word of its own for each thing that it can say, and the classic
        // numerics an algorithm for each shape that they know; they need not know all.
        let own = name == "src/surface/triangle.rs" || name == "src/surface/anatomy.rs";
        let folders = ["src/read/course/", "src/surface/classic/"];
        if own || folders.iter().any(|folder| name.starts_with(folder)) {
            continue;
        }
        let code = text
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"));
        let lines: Vec<_> = code
            .filter(|line| line.to_lowercase().contains("triangle"))
            .collect();
        let allowed = PLACES
            .iter()
            .find(|(place, _)| *place == name)
            .map_or(0, |(_, count)| *count);
        assert!(lines.len() <= allowed, "{name} knows triangles: {lines:#?}");
    }
}
