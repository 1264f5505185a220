//! The files around the code agree with it: the oldest Rust, licences, names of tests.

use std::fs;
use std::process::Command;

use serde_json::Value;
use support::files::repository;

fn file(path: &str) -> String {
    let text = fs::read_to_string(repository(path));
    text.unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The text between a beginning and the next end.
fn between<'a>(text: &'a str, beginning: &str, end: char) -> &'a str {
    let (_, rest) = text.split_once(beginning).expect(beginning);
    rest.split_once(end).expect("an end").0
}

/// All packages that this crate and its tests are built from, as `cargo metadata` describes them.
fn packages() -> Vec<Value> {
    let version = Command::new("rustc").arg("-vV").output().expect("rustc");
    let version = String::from_utf8_lossy(&version.stdout);
    let platform = between(&version, "host: ", '\n').trim();
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1", "--offline"])
        .args(["--filter-platform", platform])
        .current_dir(repository(""))
        .output()
        .expect("cargo");
    let problem = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{problem}");
    let mut metadata: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let Value::Array(packages) = metadata["packages"].take() else {
        panic!("no list of packages");
    };
    assert!(packages.len() > 50, "only {} packages", packages.len());
    packages
}

/// The oldest Rust that builds the crate is the same everywhere it is written.
#[test]
fn the_oldest_rust_is_the_same_everywhere() {
    let stated = between(&file("Cargo.toml"), "rust-version = \"", '"').to_owned();
    let fuzz = file("fuzz/Cargo.toml");
    assert_eq!(between(&fuzz, "rust-version = \"", '"'), stated);
    let workflow = file(".github/workflows/ci.yml");
    assert_eq!(between(&workflow, "cargo +", ' '), stated);
    let installed = format!("rustup toolchain install {stated} ");
    assert!(workflow.contains(&installed), "not `{installed}`");
    let readme = file("README.md");
    assert!(readme.contains(&format!("Rust {stated}")), "README.md");
}

/// No dependency needs a newer Rust than this crate states.
#[test]
fn no_dependency_needs_a_newer_rust() {
    let numbers = |version: &str| -> Vec<u32> {
        let parts = version.split('.').map(|part| part.parse());
        parts.map(|part| part.expect("a number")).take(2).collect()
    };
    let stated = numbers(between(&file("Cargo.toml"), "rust-version = \"", '"'));
    for package in packages() {
        if let Some(needed) = package["rust_version"].as_str() {
            assert!(
                numbers(needed) <= stated,
                "{} needs {needed}",
                package["name"]
            );
        }
    }
}

/// Each dependency can be used under a licence that `deny.toml` allows.
#[test]
fn licences_are_those_that_are_allowed() {
    let rules = file("deny.toml");
    let allowed: Vec<_> = between(&rules, "allow = [", ']').split('"').collect();
    let is_allowed = |licence: &str| allowed.contains(&licence.trim_matches(['(', ')', ' ']));
    let mut refused = Vec::new();
    for package in packages() {
        let stated = package["license"].as_str().unwrap_or("no licence");
        // Old manifests separate alternatives with a slash. `(A OR B) AND C` is read as A or
        // (B and C), which is good enough here: cargo-deny reads it properly.
        let alternatives = stated.replace('/', " OR ");
        let mut alternatives = alternatives.split(" OR ");
        if !alternatives.any(|needed| needed.split(" AND ").all(is_allowed)) {
            refused.push(format!("{}: {stated}", package["name"]));
        }
    }
    assert!(refused.is_empty(), "not allowed:\n{}", refused.join("\n"));
}

/// Every test program that a script or a configuration names exists.
#[test]
fn named_test_programs_exist() {
    let mut named = Vec::new();
    for path in [
        ".ci/run",
        ".ci/more",
        ".github/workflows/ci.yml",
        ".cargo/mutants.toml",
    ] {
        let text = file(path).replace("\", \"", " ");
        let mut words = text.split_whitespace().map(str::to_owned);
        while let Some(word) = words.next() {
            if word.trim_matches(['"', '[']) == "--test" {
                let name = words.next().expect("a name");
                named.push((path, name.trim_matches([';', '"', ']']).to_owned()));
            }
        }
    }
    assert!(named.len() >= 3, "only {named:?}");
    for (path, name) in named {
        let program = repository("tests").join(&name).join("main.rs");
        assert!(program.exists(), "{path} names the test `{name}`");
    }
}
