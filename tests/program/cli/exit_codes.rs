//! One test for every exit code. (70, a bug, is tested beside the code that catches it.)

use support::shell::{SCENE, Shell};

#[test]
fn code_0_when_a_picture_is_done_and_a_scene_has_no_errors() {
    let shell = Shell::with_scene();
    shell.run(&["render", "scene.kdl"]).ends_with(0);
    shell.run(&["check", "scene.kdl"]).ends_with(0);
    shell.run(&["dump", "scene.kdl"]).ends_with(0);
    shell
        .run(&["convert", "scene.kdl", "-o", "other.kdl"])
        .ends_with(0);
    for help in ["--help", "--version"] {
        let run = shell.run(&[help]).ends_with(0);
        assert!(!run.stdout.is_empty() && run.stderr.is_empty());
    }
}

#[test]
fn code_1_when_check_finds_errors() {
    let shell = Shell::new();
    shell.write("broken.kdl", "image 4 3\nspere 1");
    shell
        .run(&["check", "broken.kdl"])
        .ends_with(1)
        .says("there is no node `spere`");
}

#[test]
fn code_2_when_the_command_line_makes_no_sense() {
    let shell = Shell::with_scene();
    shell.run(&["render"]).ends_with(2);
    shell.run(&["paint", "scene.kdl"]).ends_with(2);
    shell
        .run(&["render", "scene.kdl", "--size", "800"])
        .ends_with(2)
        .says("such as 800x600");
    shell
        .run(&["render", "scene.kdl", "--size", "0x5"])
        .ends_with(2);
    shell
        .run(&["render", "scene.kdl", "--samples", "0"])
        .ends_with(2);
    shell
        .run(&["render", "scene.kdl", "-o", "a.gif"])
        .ends_with(2)
        .says(".png, .ppm or .pfm");
    shell
        .run(&["render", "scene.kdl", "-o", "{frame}.png"])
        .ends_with(2)
        .says("{stem} is known");
    shell
        .run(&["render", "-", "-"])
        .ends_with(2)
        .says("only once");
    shell
        .run(&["render", "scene.kdl", "-o", "-", "--json"])
        .ends_with(2);
    shell
        .run(&["render", "scene.kdl", "scene.kdl", "-o", "-"])
        .ends_with(2)
        .says("only one");
    shell
        .run(&["render", "scene.kdl", "--format", "png", "--format", "ppm"])
        .ends_with(2);
    shell
        .run(&["convert", "scene.kdl", "-o", "scene.kdl"])
        .ends_with(2)
        .says("would replace");
    assert_eq!(shell.files(), ["scene.kdl"]);
}

#[test]
fn code_2_when_two_pictures_would_be_one_file_and_nothing_is_rendered() {
    let shell = Shell::with_scene();
    shell.write("second.kdl", SCENE);
    let run = shell
        .run(&["render", "scene.kdl", "second.kdl", "-o", "x.png"])
        .ends_with(2);
    run.says("would both be written to x.png");
    assert_eq!(shell.files(), ["scene.kdl", "second.kdl"]);
}

#[test]
fn code_3_when_a_scene_is_wrong() {
    let shell = Shell::new();
    shell.write("broken.kdl", "image 4 3");
    let run = shell.run(&["render", "broken.kdl"]).ends_with(3);
    run.says("the scene has no `camera`");
    shell.run(&["dump", "broken.kdl"]).ends_with(3);
    shell
        .run(&["convert", "broken.kdl", "-o", "new.kdl"])
        .ends_with(3);
    assert_eq!(shell.files(), ["broken.kdl"]);
}

#[test]
fn code_4_when_a_file_is_missing_or_cannot_be_written() {
    let shell = Shell::with_scene();
    shell
        .run(&["render", "no.kdl"])
        .ends_with(4)
        .says("cannot read no.kdl");
    shell.run(&["check", "no.kdl"]).ends_with(4);
    shell
        .run(&["render", "scene.kdl", "-o", "no/a.png"])
        .ends_with(4)
        .says("there is no folder no");
    shell
        .run(&["convert", "scene.kdl", "-o", "no/a.kdl"])
        .ends_with(4)
        .says("cannot write");
    assert_eq!(shell.files(), ["scene.kdl"]);
}

#[test]
fn code_5_when_a_pixel_is_not_a_number_and_the_picture_is_written() {
    let shell = Shell::with_scene();
    let mut faulty = shell.command(&["render", "scene.kdl"]);
    let output = faulty.env("HELIODON_FAULT", "non-finite").output();
    let output = output.expect("the program starts");
    assert_eq!(output.status.code(), Some(5));
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(
        said.contains("error: scene.kdl: 1 pixels are infinite or not a number: 0,0"),
        "{said}"
    );
    assert_eq!(shell.files(), ["scene.kdl", "scene.png"]);
}

#[test]
fn light_brighter_than_any_number_is_as_bright_as_a_number_can_be() {
    let shell = Shell::new();
    // So near to a wall that 1/d² leaves the range of numbers.
    let blinding = r#"
        image 4 3
        camera { viewpoint 0 0 1e-160; look-at 0 0 0 }
        lighting { view-falloff "inverse-square" }
        material "chalk" { ambient 1 }
        plane "wall" { material "chalk"; point 0 0 0; normal 0 0 1 }"#;
    shell.write("blinding.kdl", blinding);
    shell
        .run(&["render", "blinding.kdl", "-o", "blinding.pfm"])
        .ends_with(0);
    let map = shell.read("blinding.pfm");
    let floats = map[map.len() - 4 * 3 * 4 * 3..].chunks(4);
    for float in floats {
        assert_eq!(
            f32::from_le_bytes(float.try_into().expect("4 bytes")),
            f32::MAX
        );
    }
}

#[test]
fn the_worst_code_of_a_batch_wins_and_the_good_pictures_are_made() {
    let shell = Shell::with_scene();
    shell.write("broken.kdl", "image 4 3");
    let run = shell
        .run(&["render", "broken.kdl", "no.kdl", "scene.kdl"])
        .ends_with(4);
    run.says("1 ok, 2 failed");
    assert_eq!(shell.files(), ["broken.kdl", "scene.kdl", "scene.png"]);
}

#[cfg(unix)]
#[test]
fn an_interrupted_render_ends_by_its_signal_and_leaves_no_file() {
    use std::os::unix::process::ExitStatusExt;
    use std::process::{Command, Stdio};

    for (name, number) in [("-INT", 2_u8), ("-TERM", 15)] {
        if is_ignored(number) {
            // A shell starts its background jobs deaf to interrupts, and so would be the program.
            continue;
        }
        let shell = Shell::with_scene();
        let arguments = [
            "render",
            "scene.kdl",
            "--size",
            "2000x2000",
            "--samples",
            "4096",
        ];
        let mut child = shell
            .command(&arguments)
            .stderr(Stdio::null())
            .spawn()
            .expect("the program starts");
        std::thread::sleep(std::time::Duration::from_millis(200));
        let id = child.id().to_string();
        let killed = Command::new("kill").args([name, &id]).status();
        assert!(killed.expect("kill runs").success());
        // A shell reports this as 128 + the signal's number: 130 and 143.
        let status = child.wait().expect("the program ends");
        assert_eq!(status.signal(), Some(i32::from(number)));
        assert_eq!(shell.files(), ["scene.kdl"]);
    }
}

/// Whether this process, and so those that it starts, are deaf to a signal.
#[cfg(unix)]
fn is_ignored(signal: u8) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (signal - 1) & 1 == 1)
}

#[test]
fn a_name_that_is_too_long_is_refused_before_anything_is_drawn() {
    let shell = Shell::with_scene();
    for (command, option, ending) in [("render", "-o", "png"), ("cost", "--plot", "svg")] {
        let long = format!("{}.{ending}", "x".repeat(300));
        // What only fails on writing has the system's words.
        let run = shell.run(&[command, "scene.kdl", option, &long]);
        run.ends_with(4).says(&format!(
            "error: cannot write {long}: its name is too long\n"
        ));
    }
}
