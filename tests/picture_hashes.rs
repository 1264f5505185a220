//! BLAKE3 hashes of pictures, equal on every machine.
//!
//! The program renders each scene of `scenes/` and `tests/machines/` at 160x120 pixels, as PPM and
//! as PFM. `tests/picture-hashes.txt` holds one hash per file, in the format of `b3sum --check`.
//! PFM shows differences that rounding to 8 bits hides. PNG is left out because it names the
//! program's version. `HELIODON_UPDATE=1` rewrites the file.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

const HASHES: &str = "tests/picture-hashes.txt";
const SCENES: [&str; 2] = ["scenes", "tests/machines"];
const SIZE: &str = "160x120";

#[test]
fn pictures_have_the_hashes_that_are_kept() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let kept = fs::read_to_string(root.join(HASHES)).unwrap_or_default();
    let kept: BTreeMap<_, _> = kept
        .lines()
        .filter_map(|line| line.split_once("  "))
        .map(|(hash, name)| (name.to_owned(), hash.to_owned()))
        .collect();
    let found = hashes(root);

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

    if !complaints.is_empty() && std::env::var_os("HELIODON_UPDATE").is_some_and(|on| on == "1") {
        let lines = found.iter().map(|(name, hash)| format!("{hash}  {name}\n"));
        fs::write(root.join(HASHES), lines.collect::<String>()).expect("a file to write");
        complaints.push(format!("{HASHES} rewritten"));
    }
    assert!(complaints.is_empty(), "\n{}\n", complaints.join("\n"));
}

/// Renders all scenes twice; gives the hash of each picture by its file name.
fn hashes(root: &Path) -> BTreeMap<String, String> {
    let scenes = SCENES.map(|folder| fs::read_dir(root.join(folder)).expect("a folder"));
    let scenes: Vec<_> = scenes
        .into_iter()
        .flatten()
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "kdl"))
        .collect();
    assert!(scenes.len() > 20, "only {} scenes", scenes.len());

    let pictures = tempfile::tempdir().expect("a folder");
    for format in ["ppm", "pfm"] {
        let run = Command::new(env!("CARGO_BIN_EXE_heliodon"))
            .args(["render", "--quiet", "--size", SIZE, "--format", format])
            .arg("--output")
            .arg(pictures.path())
            .args(&scenes)
            .output()
            .expect("the program runs");
        let printed = String::from_utf8_lossy(&run.stderr);
        assert!(run.status.success(), "{printed}");
    }
    let entries = fs::read_dir(pictures.path()).expect("the pictures");
    let entries = entries.map(|entry| entry.expect("an entry").path());
    let hashes: BTreeMap<_, _> = entries
        .map(|path| {
            let name = path.file_name().expect("a name").to_string_lossy();
            let bytes = fs::read(&path).expect("a picture");
            (name.into_owned(), blake3::hash(&bytes).to_string())
        })
        .collect();
    assert_eq!(hashes.len(), 2 * scenes.len(), "two pictures of each scene");
    hashes
}
