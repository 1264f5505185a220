//! Every mistake that a scene can have, and what is said about it.
//!
//! `tests/bad/NAME.kdl` is refused with exactly the text of `tests/bad/NAME.err`. To accept new
//! texts, run with `SNAPSHOTS=overwrite`, and read what has changed.

use std::fs;
use std::path::{Path, PathBuf};

use heliodon::language::render_diagnostics;
use heliodon::read::{Options, SceneError, read_bytes, read_file};
use support::files::files;
use support::texts::compare;

const FOLDER: &str = "tests/bad";

/// The scenes with more than one mistake.
const SEVERAL: &[&str] = &[
    "missing-both",
    "several",
    "syntax-two-errors",
    "syntax-xml",
    "too-many-errors",
    "too-many-errors-by-one",
    "unknown-attribute-and-missing",
    "unknown-material-in-broken-surface",
    "unknown-node-attribute",
];

fn rendered(scene_error: &SceneError) -> String {
    render_diagnostics(&scene_error.diagnostics, &scene_error.sources, false, 100)
}

/// What is said about a scene; `None` if it is accepted.
fn error(scene: &Path) -> Option<String> {
    let read = read_file(scene, &Options::default()).expect("a file that can be read");
    read.err().map(|scene_error| rendered(&scene_error))
}

/// What is said about a text that is too long or too odd for a file; it must be refused.
fn refusal_of(bytes: impl Into<Vec<u8>>) -> String {
    let read = read_bytes(
        "scene.kdl",
        bytes.into(),
        PathBuf::new(),
        &Options::default(),
    );
    rendered(&read.expect_err("the text was accepted"))
}

#[test]
fn every_mistake_is_explained() {
    let mut failures = Vec::new();
    let scenes = files(FOLDER, "kdl");
    for scene in &scenes {
        let Some(found) = error(scene) else {
            failures.push(format!("{} is accepted", scene.display()));
            continue;
        };
        failures.extend(compare(scene.with_extension("err"), &found).err());
    }
    for golden in files(FOLDER, "err") {
        if !scenes.contains(&golden.with_extension("kdl")) {
            failures.push(format!("{} has no scene", golden.display()));
        }
    }
    assert!(!scenes.is_empty());
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn one_error_is_named_for_one_mistake() {
    for scene in files(FOLDER, "kdl") {
        let stem = scene.file_stem().expect("a name").to_string_lossy();
        if SEVERAL.contains(&stem.as_ref()) {
            continue;
        }
        let read = read_file(&scene, &Options::default()).expect("a file");
        let problems = read.expect_err("a refusal").diagnostics;
        let messages: Vec<_> = problems.iter().map(ToString::to_string).collect();
        assert_eq!(messages.len(), 1, "{stem}: {messages:#?}");
    }
}

/// The message of the only error.
fn only_message(bytes: impl Into<Vec<u8>>) -> String {
    let text = refusal_of(bytes);
    let messages: Vec<_> = text
        .lines()
        .filter_map(|line| line.strip_prefix("  × "))
        .collect();
    assert_eq!(messages.len(), 1, "{text}");
    messages[0].to_owned()
}

#[test]
fn what_is_nested_too_deep_is_refused_without_a_deep_stack() {
    for text in [
        "a {".repeat(3_000),
        "a {\n".repeat(3_000),
        format!("{}{}", "plane {\n".repeat(3_000), "}\n".repeat(3_000)),
        "/*".repeat(30_000),
        format!("{}{}", "/*".repeat(30_000), "*/".repeat(30_000)),
        "/-".repeat(30_000),
        "/- ".repeat(30_000),
        "/-\n".repeat(30_000),
        "a /-{".repeat(30_000),
    ] {
        let text = format!("image 8 6\n{text}");
        assert_eq!(only_message(text), "the text is nested too deeply");
    }
}

#[test]
fn long_runs_of_anything_need_neither_a_deep_stack_nor_much_time() {
    let start = std::time::Instant::now();
    for run in [
        "}",
        ")",
        "(",
        "]",
        "=",
        "a)",
        "a}",
        "{}",
        "a{}",
        " = ",
        "\"",
        "\"a\"",
        "\\",
        "#",
        "#\"",
        "\"\"\"",
        "/",
        "//",
        "*/",
        "-",
        ".",
        ",",
        ";",
        "\r",
        "\u{2028}",
        "\u{feff}",
        "\0",
        "é",
        "a=1 ",
        "1 ",
        "(a)",
        "a ",
        "/-a ",
        "a /-{} ",
        "/- a {}\n",
        "a;",
        "a {b;}\n",
        "\\\n",
    ] {
        for before in ["", "a ", "image 8 6\n", "plane {\n", "plane { point "] {
            let said = refusal_of(format!("{before}{}", run.repeat(2_000)));
            assert!(
                said.lines().all(|line| line.len() < 800),
                "{run:?} after {before:?}"
            );
        }
    }
    // Time that doubles with each level of nesting would be hours for these.
    for level in ["n /-{", "/-n {", "n {", "n /-{ /-n {"] {
        let _ = refusal_of(format!("{}{}", level.repeat(30), "}".repeat(60)));
    }
    assert!(start.elapsed().as_secs() < 60, "{:?}", start.elapsed());
}

#[test]
fn bytes_that_are_no_text_are_refused() {
    assert_eq!(
        only_message(b"image 8 6\n// caf\xe9\n".as_slice()),
        "line 2 of scene.kdl is not UTF-8"
    );
    let png = fs::read("textures/arrow-8x8.png").expect("a texture");
    assert_eq!(only_message(png), "scene.kdl is a picture, not a scene");
}

#[test]
fn a_byte_order_mark_is_no_mistake() {
    let scene = "\u{feff}image 8 6\ncamera { viewpoint 0 0 5; screen 4 3 }\n";
    let read = read_bytes(
        "scene.kdl",
        scene.into(),
        PathBuf::new(),
        &Options::default(),
    );
    assert!(read.is_ok());
}
