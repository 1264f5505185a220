//! The course's scenes: what they become, and that `convert` loses nothing.

use std::path::{Path, PathBuf};

use heliodon::language::render_diagnostics;
use heliodon::read::{Language, Options, Reading, read_bytes, read_file};
use heliodon::render::render;
use proptest::prelude::*;
use support::files::files;

const FOLDER: &str = "tests/course";

/// All course scenes, read.
fn scenes() -> Vec<(PathBuf, Reading)> {
    files(FOLDER, "txt")
        .into_iter()
        .map(|path| (path.clone(), read(&path)))
        .collect()
}

fn read(path: &Path) -> Reading {
    let reading = read_file(path, &Options::default()).expect("a file");
    reading.unwrap_or_else(|scene_error| {
        panic!(
            "{}",
            render_diagnostics(&scene_error.diagnostics, &scene_error.sources, false, 100)
        )
    })
}

fn read_kdl(text: &str) -> Reading {
    let options = Options {
        language: Some(Language::Kdl),
        ..Options::default()
    };
    let reading = read_bytes("converted.kdl", text.into(), FOLDER.into(), &options);
    reading.unwrap_or_else(|scene_error| {
        let problems =
            render_diagnostics(&scene_error.diagnostics, &scene_error.sources, false, 100);
        panic!("{problems}\n{text}")
    })
}

fn course(name: &str) -> Reading {
    read(&Path::new(FOLDER).join(name))
}

/// A course scene in KDL, without defaults.
fn converted(name: &str) -> String {
    course(name)
        .scene
        .to_kdl(false, |texture| texture.file.clone())
}

#[test]
fn every_scene_is_recognised() {
    let scenes = scenes();
    assert!(scenes.len() >= 11, "{} scenes found", scenes.len());
    for (path, reading) in scenes {
        assert_eq!(reading.language, Language::Course, "{}", path.display());
    }
}

#[test]
fn a_converted_scene_is_the_same_scene() {
    for (path, reading) in scenes() {
        for spell_out_defaults in [false, true] {
            let absolute = |texture: &heliodon::texture::Texture| {
                texture
                    .path
                    .canonicalize()
                    .expect("a path")
                    .display()
                    .to_string()
            };
            let text = reading.scene.to_kdl(spell_out_defaults, absolute);
            assert_eq!(Language::of(&text), Language::Kdl, "{text}");
            let again = read_kdl(&text).scene;
            assert_eq!(
                again.hash(),
                reading.scene.hash(),
                "{}:\n{text}",
                path.display()
            );
            let film = |scene| render(scene, &|_| ()).expect("a camera").0;
            assert!(
                film(&again) == film(&reading.scene),
                "{} looks different",
                path.display()
            );
        }
    }
}

#[test]
fn every_scene_shows_something() {
    for (path, reading) in scenes() {
        let (film, _) = render(&reading.scene, &|_| ()).expect("a camera");
        let mut colors: Vec<_> = film
            .pixels()
            .iter()
            .map(|pixel| pixel.channels().map(f64::to_bits))
            .collect();
        colors.sort_unstable();
        colors.dedup();
        assert!(
            colors.len() > 50,
            "{} has {} colors",
            path.display(),
            colors.len()
        );
    }
}

#[test]
fn the_preset_is_written_out() {
    let text = converted("room.txt");
    for line in [
        "image 160 120 quantize=\"truncate\" cut-off=0\n",
        "    viewpoint 4 3 8\n",
        "    screen 8 6\n",
        "    reach 20\n",
        "texture \"oak\" \"oak.ppm\" divisor=256\n",
        "    texture \"brick\" mode=\"repeat\"\n",
        "    texture \"portrait\"\n",
    ] {
        assert!(text.contains(line), "{line:?} is missing in\n{text}");
    }
    assert!(!text.contains("origin"), "{text}");
}

#[test]
fn tiles_are_counted_as_in_the_course_and_lie_along_the_axes() {
    let text = converted("tiles.txt");
    assert_eq!(text.matches("    start \"course\"\n").count(), 3, "{text}");
    for xdir in ["1 0 1", "0 0 -1", "1 0 0"] {
        assert_eq!(
            text.matches(&format!("    xdir {xdir}\n")).count(),
            1,
            "{xdir} in\n{text}"
        );
    }
    assert!(text.contains("    alternate \"white\"\n"), "{text}");
}

#[test]
fn a_scale_makes_an_ellipsoid() {
    let text = converted("round.txt");
    for line in [
        "sphere \"ball\"",
        "ellipsoid \"egg\"",
        "ellipsoid \"saucer\"",
        "sphere \"moon\"",
    ] {
        assert!(text.contains(line), "{line:?} is missing in\n{text}");
    }
    assert!(text.contains("ambient 1 1 3\n"), "{text}");
}

#[test]
fn of_equal_names_the_first_counts() {
    let reading = course("names.txt");
    let warnings: Vec<_> = reading.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        warnings,
        [
            "a second material is called `normal`",
            "a second texture is called `wall`",
            "a second light is called `1`",
            "a second surface is called `wand`",
            "a second surface is called `wand`",
        ]
    );
    let scene = &reading.scene;
    let materials: Vec<_> = scene
        .materials
        .iter()
        .map(|material| &*material.name)
        .collect();
    assert_eq!(materials, ["normal", "normal-3", "normal-2", "\"oak\""]);
    let surfaces: Vec<_> = scene
        .surfaces
        .iter()
        .map(|surface| surface.common().name.as_deref().unwrap_or(""))
        .collect();
    assert_eq!(surfaces, ["wand", "wand-3", "wand-4", "wand-2"]);
    let lights: Vec<_> = scene
        .lights
        .iter()
        .map(|light| light.name.as_deref())
        .collect();
    assert_eq!(lights, [Some("1"), Some("1-2")]);
    assert_eq!(scene.textures.len(), 1, "the second texture is not used");
    assert_eq!(scene.textures[0].file, "oak.ppm");
}

#[test]
fn odd_names_survive_conversion() {
    let scene = "camera c { pixeldim 8 6 worlddim 8 6 viewpoint 4 3 8 }\n";
    for name in [
        "a\"b",
        "back\\slash",
        "#true",
        "-1",
        "//",
        "\u{202e}turned",
        "\u{feff}",
        "\u{7f}",
        "é",
    ] {
        let material = format!("material {name} {{ ambient 1 1 1 }}");
        let surface = format!("sphere {name} {{ material {name} center 4 3 -5 radius 1 }}");
        let scene = try_to_read(&format!("{scene}{material}\n{surface}"))
            .expect("a scene")
            .scene;
        let again = read_kdl(&scene.to_kdl(false, |texture| texture.file.clone())).scene;
        assert_eq!(again.hash(), scene.hash(), "{name:?}");
        assert_eq!(again.materials[0].name, name);
    }
}

#[test]
fn files_are_looked_for_beside_the_scene_and_where_the_program_runs() {
    let scene = course("files.txt").scene;
    let paths: Vec<_> = scene
        .textures
        .iter()
        .map(|texture| texture.path.as_path())
        .collect();
    assert_eq!(
        paths,
        [
            Path::new("tests/course/brick.ppm"),
            Path::new("tests/course/oak.ppm")
        ]
    );
}

#[test]
fn scenes_without_oddities_have_no_warnings() {
    for (path, reading) in scenes() {
        let odd = ["names.txt", "procedures.txt"]
            .iter()
            .any(|odd| path.ends_with(odd));
        assert_eq!(!reading.warnings.is_empty(), odd, "{}", path.display());
    }
}

/// Words from which a text is made that is nearly a scene.
const PIECES: &[&str] = &[
    "camera",
    "material",
    "texplane",
    "sphere",
    "triangle",
    "pplane",
    "texture",
    "cone",
    "name",
    "{",
    "}",
    "{",
    "}",
    "\n",
    "normal",
    "point",
    "texname",
    "mode",
    "filename",
    "radius",
    "shader",
    "dimension",
    "1",
    "-2.5",
    "1e999",
    "nan",
    "<1,2,3>",
    "//",
    "#",
    "ä\u{a0}",
    "\"",
    "<",
    "oak.ppm",
];

fn nearly_a_scene() -> impl Strategy<Value = String> {
    let piece = proptest::sample::select(PIECES);
    proptest::collection::vec(piece, 0..60).prop_map(|pieces| pieces.join(" "))
}

fn try_to_read(text: &str) -> Result<Reading, heliodon::read::SceneError> {
    let options = Options {
        language: Some(Language::Course),
        ..Options::default()
    };
    read_bytes("random.txt", text.into(), FOLDER.into(), &options)
}

proptest! {
    #[test]
    fn any_text_is_read_or_explained(text in nearly_a_scene()) {
        if let Err(scene_error) = try_to_read(&text) {
            prop_assert!(!scene_error.diagnostics.is_empty());
            let text = render_diagnostics(&scene_error.diagnostics, &scene_error.sources, false, 100);
            prop_assert!(!text.is_empty());
        }
    }

    #[test]
    fn any_characters_are_read_or_explained(text in "\\PC*") {
        prop_assert_eq!(Language::of(&text), Language::Kdl);
        prop_assert!(try_to_read(&text).is_err());
    }

    #[test]
    fn a_scene_that_is_cut_off_anywhere_is_explained(end in 0_usize..2_000) {
        let whole = std::fs::read_to_string("tests/course/room.txt").expect("the room");
        let text = &whole[..whole.floor_char_boundary(end)];
        if let Err(scene_error) = try_to_read(text) {
            let names_nothing_missing =
                scene_error.diagnostics.iter().all(|problem| !problem.message.contains("no material"));
            // The camera is the first thing in the file, the materials are before the surfaces.
            prop_assert!(names_nothing_missing);
        }
    }
}

#[test]
fn long_texts_take_time_in_proportion() {
    let many = 20_000;
    for text in [
        "{ ".repeat(many),
        "} ".repeat(many),
        "plane ".repeat(many),
        "plane a { ".repeat(many),
        "plane a { normal 1 } ".repeat(many),
        "material a { } ".repeat(many),
        "material a { ambient ".repeat(many),
        format!("plane a {{ {} }}", "normal 0 0 1 ".repeat(many)),
        format!("plane a {{ {} }}", "wrong 0 0 1 ".repeat(many)),
        format!("plane a {{ normal {} }}", "1 ".repeat(many)),
        format!(
            "plane a {{ {} {} }}",
            "normal 0 0 1 ".repeat(many),
            "point 0 0 1 ".repeat(many)
        ),
        "x".repeat(20 * many),
        "// \n".repeat(many),
    ] {
        let start = std::time::Instant::now();
        assert!(try_to_read(&text).is_err());
        let seconds = start.elapsed().as_secs_f64();
        assert!(seconds < 2.0, "{seconds} s for {}", &text[..30]);
    }
}
