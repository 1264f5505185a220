//! Course scenes with mistakes: each must be refused or warned of in exactly the words beside it.
//!
//! `SNAPSHOTS=overwrite` writes the words anew; look at them.

use std::fs;
use std::path::Path;

use heliodon::language::render_diagnostics;
use heliodon::read::{Language, Options, read_file};
use support::files::files;
use support::texts::compare;

/// What is said about a scene.
fn words(path: &Path) -> String {
    match read_file(path, &Options::default()).expect("a file") {
        Ok(reading) => render_diagnostics(&reading.warnings, &reading.scene.sources, false, 100),
        Err(scene_error) => {
            render_diagnostics(&scene_error.diagnostics, &scene_error.sources, false, 100)
        }
    }
}

#[test]
fn every_mistake_is_explained() {
    let scenes = files("tests/bad/course", "txt");
    assert!(scenes.len() >= 40, "{} bad scenes found", scenes.len());
    let mut wrong = Vec::new();
    for scene in scenes {
        let text = fs::read_to_string(&scene).unwrap_or_default();
        let name = scene.display();
        assert_eq!(Language::of(&text), Language::Course, "{name}");
        let found = words(&scene);
        assert!(!found.is_empty(), "{name} has no mistake");
        wrong.extend(compare(scene.with_extension("err"), &found).err());
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
