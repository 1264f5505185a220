//! What becomes of the files that `cost` writes.

use support::shell::Shell;

#[test]
fn what_cost_writes_replaces_nothing_that_it_needs_or_has_written() {
    let shell = Shell::with_scene();
    shell.run(&["render", "scene.kdl"]).ends_with(0);
    let folder = shell.path("");
    let folder = folder.file_name().expect("a name").display();
    let beyond = format!("../{folder}/it");
    for (file, copy) in [("scene.kdl", "scene"), ("scene.png", "truth")] {
        std::fs::copy(shell.path(file), shell.path(copy)).expect("a file");
    }
    for (arguments, expected) in [
        (["--csv", "it", "--plot", beyond.as_str()], "written twice"),
        (
            ["--threads", "1", "--report", "./scene"],
            "./scene would replace scene, which scene uses",
        ),
        (
            ["--csv", "truth", "--reference", "./truth"],
            "truth would replace the reference",
        ),
    ] {
        let arguments = [&["cost", "scene", "--runs", "1"], &arguments[..]].concat();
        shell.run(&arguments).ends_with(2).says(expected);
    }
    let files = ["scene", "scene.kdl", "scene.png", "truth"];
    assert_eq!(shell.files(), files);
}

#[test]
fn what_cost_writes_is_named_as_what_it_is() {
    let shell = Shell::with_scene();
    for (option, file, endings) in [
        ("--plot", "it.png", ".svg"),
        ("--plot", "it.svg.", ".svg"),
        ("--csv", "it.json", ".csv"),
        ("--report", "it.pdf", ".html or .htm"),
    ] {
        let run = shell.run(&["cost", "scene.kdl", option, file]).ends_with(2);
        let expected = format!("expected a name that ends with {endings}, or has no ending");
        run.says(file).says(option).says(&expected);
    }
    assert_eq!(shell.files(), ["scene.kdl"]);
    let base = ["cost", "scene.kdl", "--runs", "1", "--vary", "depth=8"];
    let named = ["--plot", "it.SVG", "--csv", "it", "--report", "it.htm"];
    shell.run(&[&base[..], &named].concat()).ends_with(0);
    assert_eq!(shell.files(), ["it", "it.SVG", "it.htm", "scene.kdl"]);
}
