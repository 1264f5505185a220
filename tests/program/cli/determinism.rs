//! The same scene gives the same bytes.

use support::files::{files, repository};
use support::shell::{SCENE, Shell};

#[test]
fn any_number_of_threads_gives_the_same_bytes() {
    let shell = Shell::with_scene();
    let picture = |threads: &str| {
        let arguments = [
            "render",
            "scene.kdl",
            "--samples",
            "5",
            "--threads",
            threads,
            "-o",
            "x.png",
        ];
        shell.run(&arguments).ends_with(0);
        shell.read("x.png")
    };
    let one = picture("1");
    for threads in ["2", "3", "8"] {
        assert_eq!(picture(threads), one, "{threads} threads");
    }
}

#[test]
fn standard_streams_and_files_give_the_same_bytes() {
    let shell = Shell::with_scene();
    shell.run(&["render", "scene.kdl"]).ends_with(0);
    let piped = shell
        .run_with_input(&["render", "-", "-o", "-"], SCENE)
        .ends_with(0);
    assert_eq!(piped.stdout, shell.read("scene.png"));
    shell
        .run_with_input(&["render", "-"], SCENE)
        .ends_with(0)
        .says("stdin.png");
    assert_eq!(shell.read("stdin.png"), shell.read("scene.png"));
}

#[test]
fn a_course_scene_and_its_kdl_twin_give_the_same_bytes() {
    let shell = Shell::new();
    let root = repository("");
    let scenes = files(repository("tests/course"), "txt");
    assert!(
        scenes.len() >= 10,
        "only {} course scenes were found",
        scenes.len()
    );
    // One of them names its textures from the folder in which the program is started.
    let at_root = |words: [&str; 2], output: &str| {
        let output = shell.path(output);
        let mut command = shell.command(&words);
        let status = command
            .args(["-q", "-o"])
            .arg(output)
            .current_dir(&root)
            .status();
        assert!(status.expect("the program runs").success(), "{words:?}");
    };
    for scene in scenes {
        let old = scene.to_string_lossy();
        at_root(["convert", &old], "new.kdl");
        at_root(["render", &old], "old.png");
        shell
            .run(&["render", "new.kdl", "-o", "new.png"])
            .ends_with(0);
        assert_eq!(shell.read("old.png"), shell.read("new.png"), "{old}");
    }
}

#[test]
fn what_dump_prints_renders_to_the_same_picture() {
    let shell = Shell::with_scene();
    shell.run(&["render", "scene.kdl"]).ends_with(0);
    let dumped = shell.run(&["dump", "scene.kdl"]).ends_with(0);
    shell.write("dumped.kdl", dumped.stdout_text());
    shell.run(&["render", "dumped.kdl"]).ends_with(0);
    assert_eq!(shell.read("dumped.png"), shell.read("scene.png"));
}
