//! BLAKE3 hashes of pictures, equal on every machine.
//!
//! The program renders each scene of `scenes/` and `tests/machines/` at 160x120 pixels, as PPM and
//! as PFM. `tests/picture-hashes.txt` holds one hash per file, in the format of `b3sum --check`.
//! PFM shows differences that rounding to 8 bits hides. PNG is left out because it names the
//! program's version. `SNAPSHOTS=overwrite` rewrites the file.

use std::collections::BTreeMap;
use std::fs;
use std::process::Command;

use support::files::{entries, files, repository};
use support::golden::updating;
use support::shell::program;

const HASHES: &str = "tests/picture-hashes.txt";
const SCENES: [&str; 2] = ["scenes", "tests/machines"];
const SIZE: &str = "160x120";

#[test]
fn pictures_have_the_hashes_that_are_kept() {
    let kept = fs::read_to_string(repository(HASHES)).unwrap_or_default();
    let kept: BTreeMap<_, _> = kept
        .lines()
        .filter_map(|line| line.split_once("  "))
        .map(|(hash, name)| (name.to_owned(), hash.to_owned()))
        .collect();
    let found = hashes();

    let mut complaints = Vec::new();
    for (name, hash) in &found {
        match kept.get(name) {
            Some(kept) if kept == hash => {}
            Some(kept) => complaints.push(format!("{name}: {hash} instead of {kept}")),
            None => complaints.push(format!("{name}: not in {HASHES}")),
        }
    }
    let gone = kept.keys().filter(|name| !found.contains_key(*name));
    complaints.extend(gone.map(|name| format!("{name}: in {HASHES}, but there is no scene")));

    if !complaints.is_empty() && updating() {
        let lines = found.iter().map(|(name, hash)| format!("{hash}  {name}\n"));
        fs::write(repository(HASHES), lines.collect::<String>()).expect("a file to write");
        complaints.push(format!("{HASHES} rewritten"));
    }
    assert!(complaints.is_empty(), "\n{}\n", complaints.join("\n"));
}

/// Renders all scenes twice; gives the hash of each picture by its file name.
fn hashes() -> BTreeMap<String, String> {
    let scenes = SCENES
        .map(|folder| files(repository(folder), "kdl"))
        .concat();
    assert!(scenes.len() > 20, "only {} scenes", scenes.len());

    let pictures = tempfile::tempdir().expect("a folder");
    for format in ["ppm", "pfm"] {
        let run = Command::new(program())
            .args(["render", "--quiet", "--size", SIZE, "--format", format])
            .arg("--output")
            .arg(pictures.path())
            .args(&scenes)
            .output()
            .expect("the program runs");
        let printed = String::from_utf8_lossy(&run.stderr);
        assert!(run.status.success(), "{printed}");
    }
    let hashes: BTreeMap<_, _> = entries(pictures.path())
        .into_iter()
        .map(|path| {
            let name = path.file_name().expect("a name").to_string_lossy();
            let bytes = fs::read(&path).expect("a picture");
            (name.into_owned(), blake3::hash(&bytes).to_string())
        })
        .collect();
    assert_eq!(hashes.len(), 2 * scenes.len(), "two pictures of each scene");
    hashes
}
