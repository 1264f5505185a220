//! Every command that a document shows is run, and what it prints is compared.
//!
//! In a block marked `console`, a line after `$ ` is a command and the lines below it are what a
//! person sees; `[..]` stands for anything. Commands of one document run in one folder, in order.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use support::files::{copy, files};
use support::shell::program;

#[test]
fn commands_in_documents_do_what_is_shown() {
    let mut commands = 0;
    for document in documents() {
        let text = fs::read_to_string(&document).expect("a document");
        let folder = playground();
        for shown in shown_commands(&text) {
            commands += 1;
            check(&document, &shown, folder.path());
        }
    }
    assert!(commands >= 10, "only {commands} commands were found");
}

#[test]
fn the_picture_below_the_readmes_scene_is_that_scene() {
    let readme = fs::read_to_string("README.md").expect("the README");
    let (_, after) = readme.split_once("```kdl\n").expect("a scene");
    let (scene, _) = after.split_once("```").expect("the end of the scene");
    let options = heliodon::read::Options::default();
    let reading = heliodon::read::read_bytes("README", scene.into(), PathBuf::new(), &options);
    let scene = reading
        .unwrap_or_else(|no| panic!("{:?}", no.diagnostics))
        .scene;
    let (film, _) = heliodon::render::render(&scene, &|_| ()).expect("a possible picture");
    let shown = image::open("docs/ball.png")
        .expect("the picture")
        .into_rgb8();
    assert!(
        film.bytes(scene.settings.encoding()) == shown.into_raw(),
        "docs/ball.png is another"
    );
}

/// A command and the lines that are shown below it.
struct Shown {
    command: String,
    output: Vec<String>,
}

fn documents() -> Vec<PathBuf> {
    let top = ["README.md", "CONTRIBUTING.md", "scenes/README.md"].map(PathBuf::from);
    let mut documents = files("docs", "md");
    documents.extend(top.into_iter().filter(|path| path.exists()));
    documents.sort();
    documents
}

/// A folder that looks like a fresh clone to the program.
fn playground() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for part in ["scenes", "textures", "tests"] {
        copy(Path::new(part), &folder.path().join(part));
    }
    folder
}

fn shown_commands(text: &str) -> Vec<Shown> {
    let mut shown: Vec<Shown> = Vec::new();
    let mut inside = false;
    for line in text.lines() {
        if let Some(language) = line.trim_start().strip_prefix("```") {
            inside = language == "console";
        } else if inside && let Some(command) = line.strip_prefix("$ ") {
            shown.push(Shown {
                command: command.to_owned(),
                output: Vec::new(),
            });
        } else if inside && let Some(last) = shown.last_mut() {
            last.output.push(line.to_owned());
        }
    }
    shown
}

fn check(document: &Path, shown: &Shown, folder: &Path) {
    let command = match shown.command.strip_prefix("cargo run --release -- ") {
        Some(arguments) => format!("heliodon {arguments}"),
        None => shown.command.clone(),
    };
    let place = document.display();
    if command.contains("cargo ") {
        let script = fs::read_to_string(".ci/run").expect("the script of all checks");
        assert!(
            script.contains(&command),
            "{place}: nothing runs `{command}`"
        );
        return;
    }
    let program = program();
    let path = format!(
        "{}:{}",
        program.parent().expect("a folder").display(),
        std::env::var("PATH").unwrap_or_default()
    );
    // A person sees both streams in one.
    let output = Command::new("bash")
        .args(["-c", &format!("{{ {command}; }} 2>&1")])
        .env("PATH", path)
        .current_dir(folder)
        .output()
        .expect("bash runs");
    let printed = String::from_utf8_lossy(&output.stdout);
    let printed: Vec<_> = printed.lines().map(str::trim_end).collect();
    let same = shown.output.is_empty()
        || printed.len() == shown.output.len()
            && shown
                .output
                .iter()
                .zip(&printed)
                .all(|(shown, line)| matches(shown, line));
    assert!(
        same,
        "{place}: `{command}` prints\n{}\nbut shown is\n{}",
        printed.join("\n"),
        shown.output.join("\n")
    );
    if shown.output.is_empty() {
        assert!(
            output.status.success(),
            "{place}: `{command}` fails:\n{}",
            printed.join("\n")
        );
    }
}

/// Whether a line is as shown; `[..]` stands for anything.
fn matches(shown: &str, line: &str) -> bool {
    let mut parts = shown.trim_end().split("[..]");
    let Some(mut rest) = line.strip_prefix(parts.next().unwrap_or_default()) else {
        return false;
    };
    let mut last = None;
    for part in parts {
        let Some(at) = rest.find(part) else {
            return false;
        };
        rest = &rest[at + part.len()..];
        last = Some(part);
    }
    rest.is_empty() || last == Some("")
}
