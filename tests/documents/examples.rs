//! The examples run, and do what their first lines say.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::{Command, Output};

use snapbox::{assert_data_eq, str};
use support::files::repository;
use support::shell::{Shell, program};

/// Runs an example in a folder; Cargo builds it first if it is out of date.
fn run(folder: &Path, example: &str, arguments: &[&str]) -> Output {
    let programs = program();
    let programs = programs.parent().expect("the folder of programs");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--quiet", "--package", "heliodon", "--example"]);
    cargo.arg(example).current_dir(repository(""));
    if programs.ends_with("release") {
        cargo.arg("--release");
    }
    let built = cargo.status().expect("Cargo runs");
    assert!(built.success(), "{example} is not built");
    let mut command = Command::new(programs.join("examples").join(example));
    let output = command.args(arguments).current_dir(folder).output();
    let output = output.expect("the example runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{example} fails: {said}");
    output
}

#[test]
fn an_example_renders_a_scene_as_the_program_does() {
    let shell = Shell::new();
    let room = repository("scenes/room.kdl");
    let room = room.to_str().expect("a path of letters");
    let output = run(&shell.path(""), "render", &[room, "example.png"]);
    assert_data_eq!(
        output.stdout,
        str![[r#"
200x150 pixels, [..] rays

"#]]
    );
    let options = ["--size", "200x150", "-o", "program.png"];
    shell
        .run(&[&["render", room], &options[..]].concat())
        .ends_with(0);
    let [one, other] = ["example.png", "program.png"].map(|name| {
        let picture = image::open(shell.path(name)).expect("a picture");
        picture.into_rgb8()
    });
    assert!(one == other, "the example draws another picture");
}

#[test]
fn an_example_adds_rings_to_a_scene() {
    let shell = Shell::new();
    run(&shell.path(""), "own_surface", &["rings.png"]);
    let picture = image::open(shell.path("rings.png")).expect("a picture");
    let picture = picture.into_rgb8();
    let column = (0..picture.height()).map(|y| picture.get_pixel(12, y).0[0]);
    let mut column: Vec<_> = column.collect();
    column.dedup();
    // From the horizon down: nothing, then rings of two colours in turn.
    let [nothing, rings @ ..] = column.as_slice() else {
        panic!("no pixels");
    };
    assert_eq!(*nothing, 0);
    assert!(rings.len() > 20, "{column:?}");
    let found: BTreeSet<_> = rings.iter().copied().collect();
    assert_eq!(found, BTreeSet::from([92, 230]));
}

#[test]
fn an_example_tells_which_place_each_pixel_shows() {
    let output = run(Path::new("."), "camera", &[]);
    assert_data_eq!(
        output.stdout,
        str![[r#"
row column      x      z  distance
  0      0  -6.83  -8.54     14.59
  0      1  -3.42  -8.54     13.34
  0      2   0.00  -8.54     12.89
  0      3   3.42  -8.54     13.34
  0      4   6.83  -8.54     14.59
  1      0  -3.57  -1.49      7.21
  1      1  -1.79  -1.49      6.51
  1      2   0.00  -1.49      6.26
  1      3   1.79  -1.49      6.51
  1      4   3.57  -1.49      7.21
  2      0  -2.42   1.01      4.88
  2      1  -1.21   1.01      4.41
  2      2   0.00   1.01      4.24
  2      3   1.21   1.01      4.41
  2      4   2.42   1.01      4.88
  3      0  -1.83   2.29      3.91
  3      1  -0.92   2.29      3.57
  3      2   0.00   2.29      3.45
  3      3   0.92   2.29      3.57
  3      4   1.83   2.29      3.91

"#]]
    );
}
