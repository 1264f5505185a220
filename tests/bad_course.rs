//! Course scenes with mistakes: each must be refused or warned of in exactly the words beside it.
//!
//! `HELIODON_UPDATE=1` writes the words anew, and fails, so that they are looked at.

use std::fs;
use std::path::{Path, PathBuf};

use heliodon::language::render_diagnostics;
use heliodon::read::{Language, Options, read_file};

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
    let folder = Path::new("tests/bad/course");
    let entries = folder.read_dir().expect("the folder of bad course scenes");
    let mut scenes: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "txt"))
        .collect();
    scenes.sort();
    assert!(scenes.len() >= 40, "{} bad scenes found", scenes.len());
    let mut wrong = Vec::new();
    for scene in scenes {
        let text = fs::read_to_string(&scene).unwrap_or_default();
        let name = scene.display();
        assert_eq!(Language::of(&text), Language::Course, "{name}");
        let expected_file = scene.with_extension("err");
        let expected = fs::read_to_string(&expected_file).unwrap_or_default();
        let found = words(&scene);
        assert!(!found.is_empty(), "{name} has no mistake");
        if found != expected {
            wrong.push(format!(
                "{name}\n--- expected\n{expected}\n--- found\n{found}"
            ));
            if std::env::var_os("HELIODON_UPDATE").is_some() {
                fs::write(&expected_file, found).expect("a file to write");
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
