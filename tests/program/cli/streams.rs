//! Results on standard output, everything else on standard error.

use serde_json::Value;
use snapbox::str;
use support::shell::{SCENE, Shell, program};

#[test]
fn a_picture_in_a_file_leaves_standard_output_empty() {
    let shell = Shell::with_scene();
    let run = shell
        .run(&["render", "scene.kdl"])
        .ends_with(0)
        .says("scene.kdl -> scene.png, 40x30");
    assert!(run.stdout.is_empty());
    assert!(
        !run.stderr.contains('\u{1b}'),
        "no colours or bars outside of terminals"
    );
}

#[test]
fn quiet_says_nothing_and_verbose_tells_the_work() {
    let shell = Shell::with_scene();
    let quiet = shell.run(&["render", "scene.kdl", "-q"]).ends_with(0);
    assert!(quiet.stdout.is_empty() && quiet.stderr.is_empty());
    shell
        .run(&["render", "scene.kdl", "-v"])
        .ends_with(0)
        .says("1200 camera");
}

#[test]
fn json_is_one_object_a_scene() {
    let shell = Shell::with_scene();
    shell.write("broken.kdl", &SCENE.replace("radius 1", "radius -1"));
    let run = shell
        .run(&["render", "scene.kdl", "broken.kdl", "--json"])
        .ends_with(3);
    let lines: Vec<Value> = run
        .stdout_text()
        .lines()
        .map(|line| serde_json::from_str(line).expect("a line of JSON"))
        .collect();
    assert_eq!(lines.len(), 2);
    assert_eq!(lines[0]["output"], "scene.png");
    assert_eq!(lines[0]["rays"]["camera_rays"], 1200);
    assert_eq!(lines[0]["exit"], 0);
    assert_eq!(lines[1]["exit"], 3);
    assert_eq!(lines[1]["problems"][0]["place"]["line"], 7);
    assert_eq!(lines[1]["problems"][0]["place"]["column"], 56);
}

#[test]
fn check_answers_on_standard_output_and_warns_on_standard_error() {
    let shell = Shell::with_scene();
    let run = shell.run(&["check", "scene.kdl"]).ends_with(0);
    run.prints(str![[r#"
scene.kdl: ok

"#]]);
    assert!(run.stderr.is_empty());
    shell.write(
        "odd.kdl",
        &SCENE.replace("viewpoint 0 1 4", "viewpoint 0 1 0.5"),
    );
    let run = shell
        .run(&["check", "odd.kdl"])
        .ends_with(0)
        .says("has the camera inside");
    run.prints(str![[r#"
odd.kdl: ok, 1 warning

"#]]);
    let run = shell.run(&["check", "odd.kdl", "--json"]).ends_with(0);
    let line: Value = serde_json::from_str(run.stdout_text()).expect("JSON");
    assert_eq!(line["problems"][0]["severity"], "warning");
}

#[test]
fn dump_prints_every_default() {
    let shell = Shell::with_scene();
    let run = shell.run(&["dump", "scene.kdl"]).ends_with(0);
    let text = run.stdout_text();
    for words in [
        "samples=1",
        "numerics=\"robust\"",
        "transparency 0",
        "shadows receive=#true cast=#true",
    ] {
        assert!(text.contains(words), "{words} is missing in\n{text}");
    }
}

#[test]
fn colours_are_used_when_asked_for() {
    let shell = Shell::new();
    shell.write("broken.kdl", "spere 1");
    let always = shell.run(&["check", "broken.kdl", "--color", "always"]);
    assert!(always.stderr.contains('\u{1b}'));
    let never = shell.run(&["check", "broken.kdl", "--color", "never"]);
    assert!(!never.stderr.contains('\u{1b}'));
}

#[cfg(unix)]
#[test]
fn a_reader_that_has_seen_enough_is_no_error() {
    let shell = Shell::with_scene();
    let program = program();
    let program = program.display();
    let script = format!("{program} dump scene.kdl | true; echo ${{PIPESTATUS[0]}}");
    let output = std::process::Command::new("bash")
        .args(["-c", &script])
        .current_dir(shell.path(""))
        .output()
        .expect("bash runs");
    assert_eq!(String::from_utf8_lossy(&output.stdout).trim(), "0");
}

#[test]
fn json_tells_what_cannot_be_written() {
    let shell = Shell::with_scene();
    let run = shell
        .run(&["render", "no.kdl", "scene.kdl", "--json"])
        .ends_with(4);
    let first: Value = serde_json::from_str(run.stdout_text().lines().next().expect("a line"))
        .expect("a line of JSON");
    assert_eq!(first["exit"], 4);
    assert!(
        first["error"]
            .as_str()
            .is_some_and(|error| error.contains("cannot read no.kdl"))
    );
}

#[test]
fn check_counts_what_went_well() {
    let shell = Shell::with_scene();
    shell.write("broken.kdl", "image 4 3");
    let run = shell
        .run(&["check", "scene.kdl", "broken.kdl", "no.kdl"])
        .ends_with(4);
    run.prints(str![[r#"
scene.kdl: ok
broken.kdl: errors
no.kdl: cannot be read

"#]]);
    run.says("1 ok, 2 failed");
}

#[cfg(unix)]
#[test]
fn a_picture_to_a_closed_pipe_is_no_error() {
    let shell = Shell::with_scene();
    let program = program();
    let program = program.display();
    let script = format!(
        "{program} render scene.kdl --size 2000x1000 -o - | head -c 10 > x; echo ${{PIPESTATUS[0]}}"
    );
    let output = std::process::Command::new("bash")
        .args(["-c", &script])
        .current_dir(shell.path(""))
        .output()
        .expect("bash runs");
    assert_eq!(String::from_utf8_lossy(&output.stdout).trim(), "0");
}

#[test]
fn the_help_has_below_a_heading_what_belongs_there() {
    let shell = Shell::new();
    for command in ["render", "cost"] {
        let help = shell.run(&[command, "--help"]).ends_with(0);
        let parts = help
            .stdout_text()
            .split_once("Picture settings, instead of");
        let (options, picture) = parts.expect("a heading");
        for (word, is_of_picture) in [("--size", true), ("--depth", true), ("--json", false)] {
            assert_eq!(picture.contains(word), is_of_picture, "{command} {word}");
            assert_eq!(options.contains(word), !is_of_picture, "{command} {word}");
        }
        let places = ["--threads", "--json", "--quiet", "--color", "--help"];
        let places = places.map(|word| options.find(word));
        assert!(places.is_sorted(), "{command} {places:?}");
    }
}
