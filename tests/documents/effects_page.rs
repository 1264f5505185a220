//! `docs/effects.md` shows what is measured: all but the times is measured anew and compared.

use std::fs;
use std::path::Path;

use heliodon::plan::{Plan, Scope};
use heliodon::read::{Options, read_file};
use heliodon_tools::effects as page;
use rayon::prelude::*;

/// A line without what a clock says, and without the spaces that depend on it.
fn timeless(line: &str) -> Option<String> {
    if line.starts_with("Without ") {
        // A sentence about the line above it, times included.
        return None;
    }
    let words: Vec<_> = line.split_whitespace().collect();
    // As in `12.3 ± 0.4 ms` and `× 0.56`.
    let is = |at: usize, marks: &[&str]| words.get(at).is_some_and(|word| marks.contains(word));
    let is_time = |index: usize| {
        let units = &["±", "ms"];
        is(index, units)
            || is(index + 1, units)
            || is(index, &["×"])
            || index > 0 && is(index - 1, &["×"])
    };
    let kept = words.iter().enumerate();
    let kept: Vec<_> = kept
        .filter(|(index, _)| !is_time(*index))
        .map(|(_, word)| *word)
        .collect();
    Some(kept.join(" "))
}

#[test]
fn times_and_nothing_else_are_taken_out() {
    let timeless = |line| timeless(line).unwrap_or_default();
    assert_eq!(
        timeless("  shadows   12.3 ± 0.4 ms   × 0.56   81234   9.1 %"),
        "shadows 81234 9.1 %"
    );
    assert_eq!(
        timeless("| a | 10 | 1.50 | 3.0 ± 0.1 ms | 20 | 4.0 ± 0.2 ms | × 1.33 |"),
        "| a | 10 | 1.50 | | 20 | | |"
    );
    assert_eq!(timeless("  shadows   12.3 ms   × 0.56   8"), "shadows 8");
    assert_eq!(timeless("Without shadows it takes"), "");
}

#[test]
#[cfg_attr(debug_assertions, ignore = "takes minutes without optimization")]
fn the_page_says_what_is_measured() {
    let written = fs::read_to_string(page::DOCUMENT).expect("the page");
    let scenes = page::scenes();
    let lists: Vec<_> = scenes
        .par_iter()
        .map(|path| page::List::measure(path, 1).expect("prices"))
        .collect();
    let measured = page::renewed(&written, &lists).expect("a page with marks");
    let lines = |text: &str| -> Vec<String> { text.lines().filter_map(timeless).collect() };
    let runs = |line: &String| line.starts_with("Measured at ");
    let [written, measured] = [&written, &measured].map(|text| lines(text));
    let pairs = written.iter().zip(&measured);
    for (written, measured) in pairs.filter(|(written, _)| !runs(written)) {
        assert_eq!(
            written,
            measured,
            "{} is out of date; `cargo run --release --bin effects` writes it anew",
            page::DOCUMENT
        );
    }
    assert_eq!(written.len(), measured.len(), "{}", page::DOCUMENT);
}

#[test]
fn in_the_rooms_no_shadow_ray_is_tested_against_floor_or_wall() {
    let rooms = page::scenes();
    let rooms = rooms.iter().filter(|path| is_room(path));
    let mut count = 0;
    for path in rooms {
        count += 1;
        let reading = read_file(path, &Options::default()).expect("a file");
        let scene = reading.expect("a scene").scene;
        let plan = Plan::new(&scene, Scope::CalledFor).expect("a possible camera");
        let name = |surface: usize| {
            let name = &scene.surfaces[surface].common().name;
            name.clone().unwrap_or_default()
        };
        let names: Vec<_> = (0..scene.surfaces.len()).map(name).collect();
        let mut casters = Vec::new();
        for planned in &plan.lights {
            for surface in 0..names.len() {
                casters.extend(planned.view.occluders_of(surface).into_iter().map(name));
            }
        }
        for big in ["floor", "wall"] {
            let title = format!("{big} of {}", path.display());
            assert!(names.iter().any(|name| name == big), "no {title}");
            assert!(!casters.iter().any(|name| name == big), "the {title} casts");
        }
        assert!(!casters.is_empty(), "nothing casts in {}", path.display());
    }
    assert_eq!(count, 4);
}

fn is_room(path: &Path) -> bool {
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    name.starts_with("room")
}
