//! The same pictures on three generations of x86-64 processors.
//!
//! `qemu-x86_64 -cpu MODEL` emulates each processor (Debian package `qemu-user`, version 7.2 or
//! later for AVX). It reports the instruction sets of the model, so that libraries choose their
//! code as they do on that processor. All scenes are rendered as PFM, whose numbers are not rounded
//! to 8 bits, and one as PNG, for its encoder. Without the emulator the test prints a message and
//! passes; with `HELIODON_REQUIRE_TOOLS=1` it fails.
#![cfg(all(target_os = "linux", target_arch = "x86_64"))]

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::thread;

use support::files::{entries, files, repository};
use support::shell::program;

/// A processor model of the emulator, its year, and the instruction sets that it must report.
struct Processor {
    model: &'static str,
    year: u16,
    sets: &'static str,
}

const PROCESSORS: [Processor; 3] = [
    Processor {
        model: "Nehalem",
        year: 2008,
        sets: "sse4.2",
    },
    Processor {
        model: "SandyBridge",
        year: 2011,
        sets: "sse4.2 avx",
    },
    Processor {
        model: "EPYC",
        year: 2017,
        sets: "sse4.2 avx avx2 fma",
    },
];

/// Small, since emulation takes about twenty times as long.
const SIZE: &str = "24x18";

#[test]
#[cfg_attr(debug_assertions, ignore = "takes minutes without optimization")]
fn pictures_do_not_depend_on_the_processor() {
    let Ok(version) = Command::new("qemu-x86_64").arg("--version").output() else {
        skip("qemu-x86_64 is not installed (Debian package qemu-user)");
        return;
    };
    let version = text(&version.stdout);
    let native = pictures(None);
    thread::scope(|scope| {
        for processor in &PROCESSORS {
            let (native, version) = (&native, &version);
            scope.spawn(move || compare(processor, native, version));
        }
    });
}

/// Not a test: prints the instruction sets of the processor that runs it.
#[test]
#[ignore = "the emulator runs it"]
fn print_instruction_sets() {
    let sets = [
        ("sse4.2", is_x86_feature_detected!("sse4.2")),
        ("avx", is_x86_feature_detected!("avx")),
        ("avx2", is_x86_feature_detected!("avx2")),
        ("fma", is_x86_feature_detected!("fma")),
    ];
    let present = sets.iter().filter(|(_, present)| *present);
    let names: Vec<_> = present.map(|(name, _)| *name).collect();
    println!("\ninstruction sets: {}", names.join(" "));
}

fn compare(processor: &Processor, native: &[(PathBuf, Vec<u8>)], version: &str) {
    let Processor { model, year, sets } = processor;
    let reported = instruction_sets(model);
    if reported != *sets {
        let version = version.lines().next().unwrap_or_default();
        skip(&format!(
            "{model} should have {sets}, but {version} reports {reported}"
        ));
        return;
    }
    let emulated = pictures(Some(model));
    assert_eq!(native.len(), emulated.len(), "{model}: number of pictures");
    for ((name, expected), (emulated_name, actual)) in native.iter().zip(&emulated) {
        assert_eq!(name, emulated_name, "{model}");
        let differs = expected != actual;
        assert!(!differs, "{} differs on {model} ({year})", name.display());
    }
    say(&format!(
        "{model} ({year}; {sets}): {} pictures are equal",
        emulated.len()
    ));
}

/// The instruction sets that this test program finds on an emulated processor.
fn instruction_sets(model: &str) -> String {
    let this = std::env::current_exe().expect("the path of this program");
    let arguments = ["--ignored", "--nocapture"];
    let mut command = emulated(model, &this);
    let output = checked(command.args(arguments).arg("print_instruction_sets"));
    let printed = text(&output.stdout);
    let mut lines = printed.lines();
    let sets = lines.find_map(|line| line.strip_prefix("instruction sets: "));
    sets.expect("a line of instruction sets").to_owned()
}

/// Names and bytes of all pictures, rendered here or on an emulated processor.
fn pictures(model: Option<&str>) -> Vec<(PathBuf, Vec<u8>)> {
    let program = program();
    let folder = tempfile::tempdir().expect("a folder");
    let scenes = scenes();
    let room = scenes.iter().find(|path| path.ends_with("room.kdl"));
    let room = std::slice::from_ref(room.expect("the scene of the README"));
    for (format, scenes) in [("pfm", scenes.as_slice()), ("png", room)] {
        let mut command = match model {
            Some(model) => emulated(model, &program),
            None => Command::new(&program),
        };
        command
            .args(["render", "--quiet", "--size", SIZE, "--format", format])
            .arg("--output")
            .arg(folder.path())
            .args(scenes);
        checked(&mut command);
    }
    let pictures = entries(folder.path()).into_iter().map(|path| {
        let bytes = fs::read(&path).expect("a picture");
        (PathBuf::from(path.file_name().expect("a name")), bytes)
    });
    let pictures: Vec<_> = pictures.collect();
    assert_eq!(pictures.len(), scenes.len() + 1);
    pictures
}

fn scenes() -> Vec<PathBuf> {
    let folders = ["scenes", "tests/machines"].map(repository);
    folders.map(|folder| files(folder, "kdl")).concat()
}

fn emulated(model: &str, program: &Path) -> Command {
    let mut command = Command::new("qemu-x86_64");
    command.args(["-cpu", model]).arg(program);
    command
}

#[track_caller]
fn checked(command: &mut Command) -> Output {
    let output = command.output().expect("the command starts");
    let printed = text(&output.stderr);
    assert!(output.status.success(), "{command:?}\n{printed}");
    output
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Says why a comparison is left out; an error if `HELIODON_REQUIRE_TOOLS` is 1.
fn skip(reason: &str) {
    let required = std::env::var_os("HELIODON_REQUIRE_TOOLS").is_some_and(|value| value == "1");
    assert!(!required, "{reason}");
    say(&format!("skipped: {reason}"));
}

/// Prints a line that the test harness does not capture.
fn say(line: &str) {
    writeln!(std::io::stderr(), "processors: {line}").expect("standard error");
}
