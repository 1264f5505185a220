//! A render that fails leaves nothing behind: no picture, no part of one, no temporary file.

use std::path::{Path, PathBuf};

use support::files::{files, repository};
use support::shell::Shell;

fn broken_scenes() -> Vec<PathBuf> {
    files(repository("tests/bad"), "kdl")
}

/// Runs `heliodon render` in a folder of its own; gives its exit code and what it left there.
fn render(arguments: &[&str], scene: &Path) -> (Option<i32>, Vec<String>) {
    let shell = Shell::new();
    let scene = scene.to_str().expect("a path of letters");
    let run = shell.run(&[&["render", scene], arguments].concat());
    (run.code, shell.files())
}

#[test]
fn a_scene_that_is_refused_leaves_nothing_behind() {
    const RUNS: usize = 24;
    const BAD_INPUT: i32 = 3;
    let scenes = broken_scenes();
    for scene in scenes.iter().step_by(scenes.len().div_ceil(RUNS)) {
        for arguments in [&[][..], &["-o", "picture.ppm"]] {
            let (code, left) = render(arguments, scene);
            assert_eq!(code, Some(BAD_INPUT), "{}", scene.display());
            assert!(left.is_empty(), "{}: {left:?}", scene.display());
        }
    }
}

#[test]
fn a_picture_that_cannot_be_written_leaves_nothing_behind() {
    let scene = repository("tests/good/look-at.kdl");
    let (code, left) = render(&["-o", "no/such/folder/picture.png"], &scene);
    assert!(code.is_some_and(|code| code != 0));
    assert!(left.is_empty(), "{left:?}");
}

#[test]
fn a_scene_that_is_good_leaves_its_picture_alone() {
    let scene = repository("tests/good/look-at.kdl");
    let (code, left) = render(&["-o", "picture.png"], &scene);
    assert_eq!(code, Some(0));
    assert_eq!(left.len(), 1, "{left:?}");
}
