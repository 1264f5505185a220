//! Every scene of the repository still gives the picture that is kept of it.
//!
//! The pictures in `docs/gallery` are small ones with smooth edges, compared pixel for pixel; of
//! the full-size ones only fingerprints are kept. `SNAPSHOTS=overwrite` rewrites both.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use heliodon::read::Options;
use heliodon::scene::Setting;
use support::files::{files, repository, stem};
use support::golden::{Complaint, compare, picture, updating};

const GALLERY: &str = "docs/gallery";
const FULL_SIZE: &str = "docs/gallery/full-size.txt";

/// The size and samples of the gallery's pictures.
fn small() -> Options {
    Options {
        size: Some([400, 300]),
        settings: vec![Setting::new("samples", "4").expect("a setting")],
        ..Options::default()
    }
}

fn scenes() -> Vec<PathBuf> {
    let scenes = files(repository("scenes"), "kdl");
    assert!(!scenes.is_empty(), "the folder of scenes is empty");
    scenes
}

/// Fails with all complaints, not only with the first.
fn fail_on(complaints: &[Complaint]) {
    assert!(complaints.is_empty(), "\n{}\n", complaints.join("\n"));
}

#[test]
fn every_scene_looks_like_its_golden() {
    let complaints = scenes().into_iter().filter_map(|scene| {
        let name = format!("{}.png", stem(&scene));
        let golden = repository(GALLERY).join(&name);
        let comparison = repository("target/gallery").join(&name);
        picture(&scene, &small())
            .and_then(|actual| compare(&golden, &actual, &comparison))
            .err()
    });
    fail_on(&complaints.collect::<Vec<_>>());
}

#[test]
fn every_golden_has_its_scene() {
    let goldens = files(repository(GALLERY), "png");
    let orphans = goldens.iter().map(|golden| stem(golden));
    let orphans = orphans.filter(|name| !repository(&format!("scenes/{name}.kdl")).exists());
    let complaints = orphans.map(|name| format!("{name}: a golden without a scene"));
    fail_on(&complaints.collect::<Vec<_>>());
}

#[test]
#[cfg_attr(debug_assertions, ignore = "takes minutes without optimization")]
fn every_scene_at_its_own_size_has_its_fingerprint() {
    let kept = fs::read_to_string(repository(FULL_SIZE)).unwrap_or_default();
    let kept: BTreeMap<_, _> = kept
        .lines()
        .filter_map(|line| line.rsplit_once("  "))
        .collect();
    let (mut found, mut complaints) = (BTreeMap::new(), Vec::new());
    for scene in scenes() {
        match picture(&scene, &Options::default()) {
            Ok(picture) => {
                let hash = blake3::hash(picture.as_raw()).to_hex().to_string();
                found.insert(stem(&scene), hash);
            }
            Err(complaint) => complaints.push(complaint),
        }
    }
    for (name, hash) in &found {
        match kept.get(name.as_str()).copied() {
            Some(kept) if kept == hash => {}
            Some(kept) => complaints.push(format!("{name}: {hash} instead of {kept}")),
            None => complaints.push(format!("{name}: not in {FULL_SIZE}")),
        }
    }
    let gone = kept.keys().filter(|name| !found.contains_key(**name));
    complaints.extend(gone.map(|name| format!("{name}: in {FULL_SIZE}, but there is no scene")));

    if updating() && !complaints.is_empty() {
        let lines: String = found
            .iter()
            .map(|(name, hash)| format!("{name}  {hash}\n"))
            .collect();
        let written = fs::write(repository(FULL_SIZE), lines);
        complaints.push(written.map_or_else(
            |error| format!("{FULL_SIZE}: {error}"),
            |()| format!("{FULL_SIZE} rewritten"),
        ));
    }
    fail_on(&complaints);
}
