//! What `explain` says of every scene of the gallery, of some pixels, and in JSON.
//!
//! `tests/explain/NAME.txt` is what it says of `scenes/NAME.kdl`. To accept new texts, run with
//! `SNAPSHOTS=overwrite`, and read what has changed.

use std::fs;
use std::path::Path;

use serde_json::Value;
use snapbox::{assert_data_eq, str};
use support::files::files;
use support::shell::heliodon;
use support::texts::compare;

fn scenes() -> Vec<String> {
    let names = files("scenes", "kdl").into_iter();
    let names: Vec<_> = names.map(|path| path.display().to_string()).collect();
    assert!(names.len() >= 17);
    names
}

/// What the program says, and the code that it ends with.
fn said(arguments: &[&str]) -> (String, String, i32) {
    let run = heliodon(arguments);
    let code = run.code.expect("an exit code");
    (run.stdout_text().to_owned(), run.stderr, code)
}

#[test]
fn every_scene_of_the_gallery_is_explained() {
    let changed = scenes().into_iter().filter_map(|scene| {
        let (text, _, code) = said(&["explain", &scene]);
        assert_eq!(code, 0, "{scene}");
        let wide = text.lines().find(|line| line.chars().count() > 100);
        assert_eq!(wide, None, "{scene}");
        let stem = Path::new(&scene).file_stem().expect("a name");
        let file = Path::new("tests/explain").join(stem).with_extension("txt");
        compare(file, &text).err()
    });
    let changed: Vec<_> = changed.collect();
    assert!(changed.is_empty(), "{}", changed.join("\n"));
}

#[test]
fn pixels_tell_their_stories() {
    let changed = [
        ("room", "room-floor", "400,500"),
        ("room", "room-shadow", "640,480"),
        ("coloured-glass", "coloured-glass-window", "300,300"),
        ("two-cameras-look-at", "two-cameras-ball", "420,300"),
        ("spotlights", "spotlights-middle", "400,300"),
        ("lamp-room", "lamp-room-penumbra", "520,380"),
        ("lamp-room", "lamp-room-ceiling", "320,40"),
        ("globe-lamp", "globe-lamp-table", "430,400"),
        ("planets", "planets-limb", "74,300"),
        ("planets", "planets-sky", "300,80"),
    ];
    let changed = changed.into_iter().filter_map(|(scene, name, pixel)| {
        let scene = format!("scenes/{scene}.kdl");
        let (text, _, code) = said(&["explain", &scene, "--pixel", pixel]);
        assert_eq!(code, 0, "{scene}");
        let file = Path::new("tests/explain/pixels").join(name);
        compare(file.with_extension("txt"), &text).err()
    });
    let changed: Vec<_> = changed.collect();
    assert!(changed.is_empty(), "{}", changed.join("\n"));
}

#[test]
fn a_pixel_is_told_in_the_numbers_that_its_file_holds() {
    let folder = env!("CARGO_TARGET_TMPDIR");
    let file = format!("{folder}/deep-room.kdl");
    for (depth, ending) in [("8", "png"), ("16", "png"), ("float", "pfm")] {
        let textures = format!("{}/textures/", env!("CARGO_MANIFEST_DIR"));
        let text = fs::read_to_string("scenes/room.kdl").expect("the room");
        let text = text.replace("../textures/", &textures);
        let deep = text.replace("image 800 600", &format!("image 800 600 depth={depth}"));
        assert_ne!(deep, text);
        fs::write(&file, deep).expect("a file");
        let out = format!("{folder}/deep-room.{ending}");
        let (_, told, code) = said(&["render", &file, "--crop", "400,500,401,501", "-o", &out]);
        assert_eq!(code, 0, "{told}");
        let numbers = match depth {
            "8" => pixel(&image::open(&out).expect("a picture").into_rgb8()),
            "16" => pixel(&image::open(&out).expect("a picture").into_rgb16()),
            _ => {
                let bytes = fs::read(&out).expect("a picture");
                let (_, floats) = bytes.split_at(bytes.len() - 12);
                let (floats, _) = floats.as_chunks::<4>();
                let floats = floats.iter().map(|it| f64::from(f32::from_le_bytes(*it)));
                floats.map(|it| it.to_string()).collect()
            }
        };
        let (text, told, code) = said(&["explain", &file, "--pixel", "400,500"]);
        assert_eq!(code, 0, "{told}");
        let expected = format!("0.2389, stored as {}\n", numbers.join(" "));
        assert!(text.contains(&expected), "{expected}\n{text}");
    }
}

/// The code values of a picture's only pixel.
fn pixel<P: image::Pixel<Subpixel: ToString>>(
    picture: &image::ImageBuffer<P, Vec<P::Subpixel>>,
) -> Vec<String> {
    assert_eq!(picture.dimensions(), (1, 1));
    picture.iter().map(ToString::to_string).collect()
}

#[test]
fn json_keeps_to_its_schema() {
    let schema = fs::read_to_string("docs/explain.schema.json").expect("the schema");
    let schema: Value = serde_json::from_str(&schema).expect("JSON");
    let validator = jsonschema::validator_for(&schema).expect("a schema");
    for scene in scenes() {
        for more in [&["--json"][..], &["--json", "--pixel", "400,300"]] {
            let arguments: Vec<_> = ["explain", &scene].iter().chain(more).copied().collect();
            let (text, _, code) = said(&arguments);
            assert_eq!(code, 0, "{arguments:?}");
            let value: Value = serde_json::from_str(&text).expect("JSON");
            let errors: Vec<_> = validator.iter_errors(&value).collect();
            assert!(errors.is_empty(), "{arguments:?}: {errors:?}");
        }
    }
    let mut wrong = serde_json::json!({ "scene": "room", "exit": 0 });
    assert!(!validator.is_valid(&wrong));
    wrong["effects"] = Value::Null;
    assert!(!validator.is_valid(&wrong));
}

/// The answer in JSON.
fn answer(arguments: &[&str]) -> Value {
    let (text, said, code) = said(arguments);
    assert_eq!(code, 0, "{said}");
    serde_json::from_str(&text).expect("JSON")
}

#[test]
fn measured_work_is_what_rendering_takes_and_an_estimate_is_near() {
    let explained = |more: &[&str]| {
        let arguments: Vec<_> = ["explain", "scenes/room.kdl", "--json"]
            .iter()
            .chain(more)
            .copied()
            .collect();
        answer(&arguments)["work"].clone()
    };
    let folder = env!("CARGO_TARGET_TMPDIR");
    let out = format!("{folder}/explained.png");
    let render = ["render", "scenes/room.kdl", "--stats", "--json", "-o", &out];
    let (rendered, measured) = (answer(&render), explained(&["--measure"]));
    assert_eq!(measured["counts"], rendered["rays"]);
    assert_eq!(measured["by_light"], rendered["by_light"]);
    let by_light = measured["by_light"].as_array().expect("a list");
    let tests = by_light.iter().map(|light| &light["occlusion_tests"]);
    let sum: u64 = tests.filter_map(Value::as_u64).sum();
    assert_eq!(
        (by_light.len(), sum),
        (2, rendered["rays"]["occlusion_tests"].as_u64().unwrap_or(0))
    );
    let (rendered, estimated) = (&rendered["rays"], &explained(&[])["counts"]);
    for kind in ["camera_rays", "mirror_rays", "shadow_rays", "hit_tests"] {
        let [estimate, exact] = [estimated, rendered].map(|counts| counts[kind].as_f64());
        let ratio = estimate.expect("a number") / exact.expect("a number");
        assert!((0.9..1.1).contains(&ratio), "{kind}: {ratio}");
    }
}

#[test]
fn lamps_are_told_after_the_lights_with_what_stands_in_their_way() {
    let explained = answer(&["explain", "scenes/globe-lamp.kdl", "--json"]);
    let titles = |rows: &Value| -> Vec<_> {
        let rows = rows.as_array().expect("a list").iter();
        rows.map(|row| row["light"]["title"].clone()).collect()
    };
    let lamps = [r#"lamp "globe""#, r#"lamp "window""#];
    assert_eq!(titles(&explained["lights"]), lamps);
    assert_eq!(titles(&explained["work"]["by_light"]), lamps);
    for (number, lamp) in explained["lights"]
        .as_array()
        .expect("a list")
        .iter()
        .enumerate()
    {
        assert_eq!(lamp["is_lamp"], true);
        // All surfaces are told to be lit or not, and to cast shadows or not, but for the lamp.
        let count = |list: &str| lamp[list].as_array().expect("a list").len();
        let lit = lamp["lights"].as_u64().expect("a count");
        assert_eq!(lit + count("unlit") as u64, 11);
        assert_eq!(count("casters") + count("casts_nothing"), 10);
        let unlit = lamp["unlit"].to_string();
        assert!(unlit.contains(r#"[0,"colorless"]"#), "{unlit}");
        assert_eq!(unlit.contains(r#"[1,"behind"]"#), number == 1, "{unlit}");
    }
}

#[test]
fn what_a_pixel_gets_of_each_lamp_is_told_by_itself() {
    let story = answer(&[
        "explain",
        "scenes/globe-lamp.kdl",
        "--json",
        "--pixel",
        "430,400",
    ]);
    for ray in story["rays"].as_array().expect("a list") {
        let lights = ray["lights"].as_array().expect("a list");
        assert_eq!(lights.len(), 2);
        let red = |color: &Value| color[0].as_f64().expect("a number");
        // Some rays to the far end of the window would leave below the table.
        assert_eq!(lights[0]["rays"], 16);
        assert!(
            lights[1]["rays"]
                .as_u64()
                .is_some_and(|rays| (8..16).contains(&rays))
        );
        let mut sum = 0.0;
        for light in lights {
            let share = red(&light["share"]);
            assert!(share > 0.0 && share < 1.0, "{light}");
            sum += red(&light["arrives"]);
        }
        // The scene fades nothing on the way to the eye, and the table answers with so much red.
        let answered = red(&ray["of_lamps"]) / sum;
        assert!((answered - 0.62).abs() < 1e-12, "{answered}");
        assert!(red(&ray["of_lamps"]) < red(&ray["own"]));
    }
}

#[test]
fn rays_that_meet_nothing_are_counted_in_the_text_and_each_told_in_json() {
    let story = answer(&[
        "explain",
        "scenes/planets.kdl",
        "--json",
        "--pixel",
        "74,300",
    ]);
    let rays = story["rays"].as_array().expect("a list");
    assert_eq!(rays.len(), 4);
    assert_eq!(rays.iter().filter(|ray| ray["hit"].is_null()).count(), 1);
}

#[test]
fn a_light_in_the_very_place_that_it_would_light_is_told() {
    let text = r#"
        image 3 3
        camera { viewpoint 0 0 9; look-at 0 0 0 }
        material "chalk" { ambient 1; diffuse 1 }
        light "spark" { location 0 0 0; emissivity 9 }
        sphere "ball" { material "chalk"; center 0 0 -1; radius 1 }
    "#;
    let scene = format!("{}/spark.kdl", env!("CARGO_TARGET_TMPDIR"));
    fs::write(&scene, text).expect("a scene");
    let (text, _, code) = said(&["explain", &scene, "--pixel", "1,1"]);
    assert_eq!(code, 0);
    let line =
        r#"light "spark" (line 5): is at this very point, so that its light has no direction"#;
    assert!(text.contains(line), "{text}");
}

/// A row of that many balls, of which some lie in the picture.
fn balls(count: usize, picture: &str) -> String {
    let mut text = format!(
        "image 40 30 {picture}\ncamera {{ viewpoint 0 0 9; look-at 0 0 0 }}\n\
         material \"chalk\" {{ ambient 1 }}\n"
    );
    for number in 0..count {
        text += &format!("sphere {{ material \"chalk\"; center {number} 0 0; radius 0.4 }}\n");
    }
    text
}

#[test]
fn what_is_counted_for_a_small_picture_is_what_rendering_takes() {
    let scene = format!("{}/one-ball.kdl", env!("CARGO_TARGET_TMPDIR"));
    fs::write(&scene, balls(1, "")).expect("a scene");
    let counts = |more: &[&str]| {
        let arguments = [&["explain", &scene, "--json"], more].concat();
        answer(&arguments)["work"]["counts"].clone()
    };
    assert_eq!(counts(&[]), counts(&["--measure"]));
}

#[test]
fn no_tree_is_promised_to_classic_numerics() {
    let scene = format!("{}/many-balls.kdl", env!("CARGO_TARGET_TMPDIR"));
    for (picture, says) in [
        ("", "searched in a tree (used above 128 surfaces)"),
        (
            "numerics=\"classic\"",
            "searched one by one (numerics \"classic\" use no tree)",
        ),
    ] {
        fs::write(&scene, balls(129, picture)).expect("a scene");
        let (text, _, _) = said(&["explain", &scene]);
        assert!(text.contains(says), "{text}");
    }
}

#[test]
fn surfaces_that_can_block_a_light_are_listed_in_small_scenes_only() {
    let scene = format!("{}/many-lit-balls.kdl", env!("CARGO_TARGET_TMPDIR"));
    for (count, is_known) in [(128, true), (129, false)] {
        let light = "light \"sun\" { location 0 50 9; emissivity 9 }\n";
        let text = balls(count, "").replace("ambient 1", "diffuse 1") + light;
        fs::write(&scene, text).expect("a scene");
        let says =
            "    the surfaces that can block it are listed in scenes of up to 128 surfaces\n";
        let (text, _, _) = said(&["explain", &scene]);
        assert_eq!(text.contains(says), !is_known, "{text}");
        let answer = answer(&["explain", &scene, "--json"]);
        for list in ["casters", "casts_nothing"] {
            assert_eq!(answer["lights"][0][list].is_array(), is_known, "{count}");
            assert_eq!(answer["lights"][0][list].is_null(), !is_known, "{count}");
        }
        // What it lights none of is not searched for anything.
        fs::write(&scene, balls(count, "") + light).expect("a scene");
        let (text, _, _) = said(&["explain", &scene]);
        assert!(!text.contains(says), "{text}");
    }
}

#[test]
fn a_pixel_outside_of_the_picture_is_refused() {
    let (_, error, code) = said(&["explain", "scenes/room.kdl", "--pixel", "800,0"]);
    assert_eq!(code, 2);
    assert_data_eq!(
        error,
        str![[r#"
error: scenes/room.kdl: there is no pixel 800,0 in a picture of 800 by 600; columns and rows are counted from the top left, from 0

"#]]
    );
}
