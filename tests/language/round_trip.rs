//! A scene that is described and read again is the same scene.

use std::path::{Path, PathBuf};

use heliodon::language::render_diagnostics;
use heliodon::read::{Options, Reading, read_bytes, read_file};
use heliodon::scene::Scene;
use support::files::{files, repository};

/// All good scenes of the project.
fn scenes() -> Vec<PathBuf> {
    let folders = ["scenes", "tests/good"].map(repository);
    let scenes = folders.map(|folder| files(folder, "kdl")).concat();
    assert!(scenes.len() > 2);
    scenes
}

fn described(scene: &Scene) -> String {
    scene.describe().iter().map(ToString::to_string).collect()
}

#[track_caller]
fn read_again(text: &str, like: &Path) -> Scene {
    let directory = like.parent().expect("a folder").to_owned();
    match read_bytes("described", text.into(), directory, &Options::default()) {
        Ok(Reading { scene, .. }) => scene,
        Err(no) => panic!(
            "{}\n{text}\n{}",
            like.display(),
            render_diagnostics(&no.diagnostics, &no.sources, false, 100)
        ),
    }
}

#[test]
fn every_scene_survives_being_described() {
    for path in scenes() {
        let read = read_file(&path, &Options::default()).expect("a file");
        let scene = read
            .unwrap_or_else(|no| panic!("{}: {:#?}", path.display(), no.diagnostics))
            .scene;
        let text = described(&scene);
        let again = read_again(&text, &path);
        assert_eq!(described(&again), text, "{}", path.display());
        assert_eq!(again.hash(), scene.hash(), "{}", path.display());
    }
}

#[test]
fn every_scene_survives_without_its_defaults() {
    for path in scenes() {
        let scene = read_file(&path, &Options::default())
            .expect("a file")
            .expect("a scene")
            .scene;
        let nodes = scene.describe().into_iter();
        let text: String = nodes
            .map(|node| node.without_defaults().to_string())
            .collect();
        assert_eq!(
            read_again(&text, &path).hash(),
            scene.hash(),
            "{}",
            path.display()
        );
    }
}

#[test]
fn the_good_scenes_have_every_kind_of_node_and_every_attribute() {
    let mut said = Vec::new();
    for path in scenes() {
        let scene = read_file(&path, &Options::default())
            .expect("a file")
            .expect("a scene")
            .scene;
        for node in scene.describe() {
            let word = node.schema.word;
            said.push(word.to_owned());
            let entries = node.attributes.iter().chain(&node.properties);
            for entry in entries {
                said.push(format!("{word} {}", entry.attribute.word));
                for property in &entry.properties {
                    let (attribute, property) = (entry.attribute.word, property.attribute.word);
                    said.push(format!("{word} {attribute} {property}"));
                }
            }
        }
    }
    let lacking = |wanted: String| assert!(said.contains(&wanted), "no scene has {wanted:?}");
    for schema in Scene::schemas() {
        let word = schema.word;
        lacking(word.to_owned());
        for attribute in schema.all_attributes().chain(schema.properties) {
            lacking(format!("{word} {}", attribute.word));
            for property in attribute.properties {
                // The slide of a projector is most often as wide as the projector says.
                if word != "projector" {
                    lacking(format!("{word} {} {}", attribute.word, property.word));
                }
            }
        }
    }
}
