//! What becomes of files.

use support::shell::{SCENE, Shell, size_of};

#[test]
fn the_picture_has_the_scenes_size_unless_told_otherwise() {
    let shell = Shell::with_scene();
    shell.run(&["render", "scene.kdl"]).ends_with(0);
    assert_eq!(size_of(&shell.path("scene.png")), (40, 30));
    shell
        .run(&["render", "scene.kdl", "--size", "17x5"])
        .ends_with(0);
    assert_eq!(size_of(&shell.path("scene.png")), (17, 5));
}

#[test]
fn the_ending_names_the_format_and_format_overrules_it() {
    let shell = Shell::with_scene();
    for (name, magic) in [
        ("a.png", &b"\x89PNG"[..]),
        ("a.ppm", b"P6\n40 30\n255\n"),
        ("a.pfm", b"PF\n40 30\n-1.0\n"),
    ] {
        shell.run(&["render", "scene.kdl", "-o", name]).ends_with(0);
        assert!(shell.read(name).starts_with(magic), "{name}");
    }
    shell
        .run(&["render", "scene.kdl", "-o", "b", "--format", "ppm"])
        .ends_with(0);
    assert!(shell.read("b").starts_with(b"P6"));
    shell
        .run(&["render", "scene.kdl", "--format", "pfm"])
        .ends_with(0);
    assert!(shell.read("scene.pfm").starts_with(b"PF"));
}

#[test]
fn all_formats_hold_the_same_picture() {
    let shell = Shell::with_scene();
    for (name, format) in [
        ("8.png", "png"),
        ("16.png", "png16"),
        ("8.ppm", "ppm"),
        ("f.pfm", "pfm"),
    ] {
        shell
            .run(&["render", "scene.kdl", "-o", name, "--format", format])
            .ends_with(0);
    }
    let open = |name: &str| image::open(shell.path(name)).expect("a picture");
    assert_eq!(open("8.png").into_rgb8(), open("8.ppm").into_rgb8());
    let (eight, sixteen) = (open("8.png").into_rgb8(), open("16.png").into_rgb16());
    let floats = shell.read("f.pfm");
    let floats = &floats[b"PF\n40 30\n-1.0\n".len()..];
    assert_eq!(floats.len(), 40 * 30 * 3 * 4);
    for (index, (low, high)) in eight.iter().zip(sixteen.iter()).enumerate() {
        let exact = f64::from(*high) / 65_535.0 * 255.0;
        assert!((f64::from(*low) - exact).abs() <= 0.51, "{low} and {high}");
        let (column, row, channel) = (index / 3 % 40, index / 3 / 40, index % 3);
        // This format's rows run from bottom to top.
        let at = 4 * (((29 - row) * 40 + column) * 3 + channel);
        let float = f32::from_le_bytes(floats[at..at + 4].try_into().expect("four bytes"));
        let clamped = f64::from(float).clamp(0.0, 1.0);
        assert!(
            (clamped * 65_535.0 - f64::from(*high)).abs() <= 0.51,
            "{float} and {high}"
        );
    }
}

#[test]
fn the_notes_in_a_png_tell_settings_and_scene_but_no_clock_and_no_path() {
    let shell = Shell::with_scene();
    shell.run(&["render", "scene.kdl"]).ends_with(0);
    let bytes = shell.read("scene.png");
    let reader = png::Decoder::new(std::io::Cursor::new(bytes))
        .read_info()
        .expect("a PNG");
    let info = reader.info();
    let notes: Vec<_> = info
        .utf8_text
        .iter()
        .map(|note| (note.keyword.clone(), note.get_text().expect("text")))
        .collect();
    let keywords: Vec<_> = notes.iter().map(|(keyword, _)| keyword.as_str()).collect();
    assert_eq!(keywords, ["Software", "Settings", "Scene hash"]);
    assert_eq!(
        notes[1].1,
        "image 40 30 samples=1 pattern=\"stratified\" max-error=0 transfer=\"none\" depth=\"8\" quantize=\"round\" cut-off=0.00098 numerics=\"robust\" texture-filter=\"nearest\""
    );
    assert_eq!(notes[2].1.len(), 64);
}

#[test]
fn a_stem_or_a_folder_serves_many_scenes() {
    let shell = Shell::with_scene();
    shell.write("second.kdl", SCENE);
    std::fs::create_dir(shell.path("out")).expect("a folder");
    shell
        .run(&[
            "render",
            "scene.kdl",
            "second.kdl",
            "-o",
            "{stem}-small.ppm",
        ])
        .ends_with(0);
    shell
        .run(&["render", "scene.kdl", "second.kdl", "-o", "out"])
        .ends_with(0)
        .says("2 ok, 0 failed");
    let expected = [
        "out",
        "scene-small.ppm",
        "scene.kdl",
        "second-small.ppm",
        "second.kdl",
    ];
    assert_eq!(shell.files(), expected);
    assert!(shell.path("out/second.png").exists());
}

#[test]
fn a_picture_never_replaces_a_scene() {
    let shell = Shell::with_scene();
    let run = shell.run(&["render", "scene.kdl", "-o", "scene.kdl", "--format", "png"]);
    run.ends_with(2).says("would replace a scene");
    assert_eq!(shell.read("scene.kdl"), SCENE.as_bytes());
}

#[cfg(unix)]
#[test]
fn devices_and_links_stay_what_they_are() {
    let shell = Shell::with_scene();
    shell
        .run(&["render", "scene.kdl", "-o", "/dev/null", "--format", "png"])
        .ends_with(0);
    let device = std::fs::metadata("/dev/null").expect("the null device");
    assert!(!device.is_file());
    shell.write("target.png", "");
    std::os::unix::fs::symlink("target.png", shell.path("link.png")).expect("a link");
    shell
        .run(&["render", "scene.kdl", "-o", "link.png"])
        .ends_with(0);
    assert!(shell.path("link.png").is_symlink());
    assert_eq!(size_of(&shell.path("target.png")), (40, 30));
}

#[cfg(unix)]
#[test]
fn pictures_can_be_read_by_others() {
    use std::os::unix::fs::PermissionsExt;
    let shell = Shell::with_scene();
    shell.run(&["render", "scene.kdl"]).ends_with(0);
    shell.write("plain", "");
    let mode = |name| {
        std::fs::metadata(shell.path(name))
            .expect("a file")
            .permissions()
            .mode()
    };
    assert_eq!(mode("scene.png"), mode("plain"));
}

#[test]
fn nothing_replaces_what_a_scene_is_made_of() {
    let shell = Shell::with_scene();
    let texture = concat!(env!("CARGO_MANIFEST_DIR"), "/textures/arrow-8x8.png");
    std::fs::copy(texture, shell.path("arrow.png")).expect("a texture");
    shell.write("part.kdl", "texture \"arrow\" \"arrow.png\"\n");
    let wall = r#"texture-plane {
        material "chalk"; point -1 0 -1; normal 0 0 1; xdir 1 0 0; dimensions 2 2
        texture "arrow"
    }"#;
    shell.write(
        "scene.kdl",
        &format!("{SCENE}\ninclude \"part.kdl\"\n{wall}\n"),
    );
    let run = shell
        .run(&["render", "scene.kdl", "-o", "arrow.png"])
        .ends_with(2);
    run.says("would replace arrow.png");
    let run = shell
        .run(&["convert", "scene.kdl", "-o", "part.kdl"])
        .ends_with(2);
    run.says("part.kdl would replace part.kdl");
    assert_eq!(size_of(&shell.path("arrow.png")), (8, 8));
    assert!(shell.read("part.kdl").starts_with(b"texture"));
}

#[test]
fn a_name_and_a_format_that_contradict_each_other_are_refused() {
    let shell = Shell::with_scene();
    let run = shell.run(&["render", "scene.kdl", "-o", "a.ppm", "--format", "png16"]);
    run.ends_with(2)
        .says("--format needs a .png file, but the output is a.ppm");
    shell
        .run(&["render", "scene.kdl", "-o", "a.png", "--format", "png16"])
        .ends_with(0);
}

/// What a file is by its first bytes: bits of a PNG, or the word of another format.
fn kind(bytes: &[u8]) -> &'static str {
    // Behind the signature of 8 bytes: length, word, width, height, depth.
    match (bytes, bytes.get(24)) {
        ([b'P', b'6', ..], _) => "ppm",
        ([b'P', b'F', ..], _) => "pfm",
        (_, Some(8)) => "png 8",
        (_, Some(16)) => "png 16",
        _ => "unknown",
    }
}

#[test]
fn the_depth_chooses_the_format_that_nobody_names() {
    for (depth, arguments, name, expected) in [
        ("8", &[][..], "deep.png", "png 8"),
        ("16", &[], "deep.png", "png 16"),
        ("float", &[], "deep.pfm", "pfm"),
        ("16", &["-o", "."], "deep.png", "png 16"),
        ("float", &["-o", "."], "deep.pfm", "pfm"),
        ("16", &["-o", "x.png"], "x.png", "png 16"),
        ("8", &["--depth", "16", "-o", "x.png"], "x.png", "png 16"),
        ("float", &["--depth", "16"], "deep.png", "png 16"),
        ("16", &["--depth", "float"], "deep.pfm", "pfm"),
        ("float", &["--depth", "8"], "deep.png", "png 8"),
        // What the command line names comes before the scene.
        ("float", &["-o", "x.png"], "x.png", "png 8"),
        ("16", &["-o", "x.ppm"], "x.ppm", "ppm"),
        ("16", &["-o", "x.pfm"], "x.pfm", "pfm"),
        ("float", &["--format", "png"], "deep.png", "png 8"),
        ("8", &["--format", "png16"], "deep.png", "png 16"),
        ("16", &["--format", "ppm"], "deep.ppm", "ppm"),
        (
            "float",
            &["--format", "png16", "--depth", "16"],
            "deep.png",
            "png 16",
        ),
    ] {
        let shell = Shell::new();
        let image = format!("image 40 30 depth={depth}");
        shell.write("deep.kdl", &SCENE.replace("image 40 30", &image));
        let run = shell.run(&[&["render", "deep.kdl"][..], arguments].concat());
        run.ends_with(0).says(&format!("{name}, 40x30"));
        assert_eq!(shell.files(), ["deep.kdl", name], "{depth} {arguments:?}");
        assert_eq!(kind(&shell.read(name)), expected, "{depth} {arguments:?}");
    }
    let shell = Shell::with_scene();
    for (depth, expected) in [("8", "png 8"), ("16", "png 16"), ("float", "pfm")] {
        let run = shell.run(&["render", "scene.kdl", "-o", "-", "--depth", depth]);
        assert_eq!(kind(&run.ends_with(0).stdout), expected);
    }
}

#[test]
fn a_depth_that_cannot_be_kept_is_refused() {
    let shell = Shell::with_scene();
    for (arguments, expected) in [
        (
            ["--depth", "float", "-o", "a.png"],
            "a.png cannot have a depth of float; use the ending .pfm, or another --depth",
        ),
        (
            ["--depth", "16", "--format", "png"],
            "--depth 16 contradicts --format, which has a depth of 8; leave one of them out",
        ),
    ] {
        let run = shell.run(&[&["render", "scene.kdl"][..], &arguments].concat());
        run.ends_with(2).says(expected);
    }
    assert_eq!(shell.files(), ["scene.kdl"]);
}

#[test]
fn the_settings_in_a_png_have_the_depth_that_it_has() {
    let shell = Shell::with_scene();
    for (arguments, expected) in [
        (["--format", "png16"], "depth=\"16\""),
        (["--depth", "16"], "depth=\"16\""),
        (["--format", "png"], "depth=\"8\""),
    ] {
        let run = shell.run(&[&["render", "scene.kdl"][..], &arguments].concat());
        run.ends_with(0);
        let bytes = shell.read("scene.png");
        let has = bytes.windows(expected.len());
        let has = has.filter(|part| *part == expected.as_bytes());
        assert_eq!(has.count(), 1, "{arguments:?}");
    }
}

#[cfg(unix)]
#[test]
fn a_file_that_is_replaced_hands_on_its_permissions() {
    use std::os::unix::fs::PermissionsExt;
    let shell = Shell::with_scene();
    shell.write("scene.png", "");
    let private = std::fs::Permissions::from_mode(0o600);
    std::fs::set_permissions(shell.path("scene.png"), private).expect("permissions");
    shell.run(&["render", "scene.kdl"]).ends_with(0);
    let mode = std::fs::metadata(shell.path("scene.png"))
        .expect("a file")
        .permissions()
        .mode();
    assert_eq!(mode & 0o777, 0o600);
}

#[cfg(unix)]
#[test]
fn a_link_to_nothing_gets_its_target() {
    let shell = Shell::with_scene();
    std::os::unix::fs::symlink("target.png", shell.path("link.png")).expect("a link");
    shell
        .run(&["render", "scene.kdl", "-o", "link.png"])
        .ends_with(0);
    assert!(shell.path("link.png").is_symlink());
    assert_eq!(size_of(&shell.path("target.png")), (40, 30));
}

#[cfg(unix)]
#[test]
fn an_interrupt_while_a_picture_is_written_leaves_no_file() {
    use std::process::{Command, Stdio};
    let shell = Shell::with_scene();
    let mut child = shell
        .command(&[
            "render",
            "scene.kdl",
            "--size",
            "6000x6000",
            "-o",
            "big.pfm",
        ])
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    // Wait for the temporary file, then strike. If the picture is finished first, so be it.
    while shell.files() == ["scene.kdl"] {
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    let killed = Command::new("kill")
        .args(["-TERM", &child.id().to_string()])
        .status();
    killed.expect("kill runs");
    child.wait().expect("the program ends");
    let left: Vec<_> = shell
        .files()
        .into_iter()
        .filter(|name| name.starts_with('.'))
        .collect();
    assert!(left.is_empty(), "left behind: {left:?}");
}

#[test]
#[cfg(target_os = "linux")]
fn a_file_that_cannot_be_made_is_called_as_it_was_asked_for() {
    let shell = Shell::with_scene();
    for [command, option, file] in [
        ["render", "-o", "/proc/it.png"],
        ["convert", "-o", "/proc/it.png"],
        ["cost", "--csv", "/proc/it.csv"],
        ["cost", "--plot", "/proc/it.svg"],
        ["cost", "--report", "/proc/it.html"],
    ] {
        let run = shell.run(&[command, "scene.kdl", option, file]);
        run.ends_with(4).says(&format!(
            "error: cannot write {file}: No such file or directory (os error 2)\n"
        ));
    }
}
