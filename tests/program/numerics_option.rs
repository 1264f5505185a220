//! `--numerics` and `image … numerics=…`: the classic numerics draw the same pictures, nearly.

use heliodon::math::Numerics;
use heliodon::read::{Options, read_bytes};
use heliodon::render::render;
use heliodon::scene::Setting;
use image::RgbImage;
use support::files::{files, repository, stem};
use support::golden::picture;
use support::shell::{Run, Shell};

const SCENE: &str = r#"
    image 40 30
    camera { viewpoint 0 1 4; look-at 0 1 0 }
    material "chalk" { ambient 1; diffuse 3; specular 0.3 }
    light { location 2 4 3; emissivity 8 }
    plane "floor" { material "chalk"; point 0 0 0; normal 0 1 0 }
    sphere "ball" { material "chalk"; center 0 1 0; radius 1 }
"#;

/// The share of pixels that differ by at most one code value.
fn alike(one: &RgbImage, other: &RgbImage) -> f64 {
    let near = one.pixels().zip(other.pixels()).filter(|(one, other)| {
        let pairs = one.0.iter().zip(other.0);
        pairs
            .into_iter()
            .all(|(one, other)| one.abs_diff(other) <= 1)
    });
    near.count() as f64 / f64::from(one.width() * one.height())
}

#[test]
fn every_scene_is_nearly_the_same_in_all_numerics() {
    let scenes = files(repository("scenes"), "kdl");
    let mut narrow_differs = 0;
    for scene in &scenes {
        let drawn = Numerics::ALL.map(|numerics| {
            let options = Options {
                size: Some([160, 120]),
                settings: vec![Setting::new("numerics", numerics.word()).expect("a setting")],
                ..Options::default()
            };
            picture(scene, &options).expect("a picture")
        });
        let [robust, classic, narrow] = &drawn;
        let share = [classic, narrow].map(|other| alike(robust, other));
        assert!(
            share.iter().all(|share| *share >= 0.99),
            "{}: {share:?}",
            stem(scene)
        );
        narrow_differs += usize::from(narrow != robust);
    }
    assert!(
        2 * narrow_differs > scenes.len(),
        "only {narrow_differs} pictures differ in 32 bits"
    );
}

fn read(text: &str, options: &Options) -> heliodon::scene::Scene {
    let reading = read_bytes("scene.kdl", text.into(), "".into(), options);
    reading.expect("a scene").scene
}

#[test]
fn the_option_replaces_what_the_scene_says() {
    let said = SCENE.replace("image 40 30", r#"image 40 30 numerics="classic-f32""#);
    let plain = Options::default();
    assert_eq!(read(SCENE, &plain).settings.numerics, Numerics::Robust);
    assert_eq!(read(&said, &plain).settings.numerics, Numerics::ClassicF32);
    for numerics in Numerics::ALL {
        let told = Options {
            settings: vec![Setting::new("numerics", numerics.word()).expect("a setting")],
            ..Options::default()
        };
        assert_eq!(read(&said, &told).settings.numerics, numerics);
        let hashes = [SCENE, &said].map(|text| read(text, &told).hash());
        assert_eq!(hashes[0], hashes[1]);
    }
    assert_ne!(read(SCENE, &plain).hash(), read(&said, &plain).hash());
}

/// A scene far from the origin is the same scene to robust numbers alone.
#[test]
fn only_robust_pictures_may_be_moved() {
    let moved = SCENE
        .replace(
            "viewpoint 0 1 4; look-at 0 1 0",
            "viewpoint 1048576 1 4; look-at 1048576 1 0",
        )
        .replace("location 2", "location 1048578")
        .replace("point 0 0 0", "point 1048576 0 0")
        .replace("center 0", "center 1048576");
    let film = |text: &str, numerics: Numerics| {
        let options = Options {
            settings: vec![Setting::new("numerics", numerics.word()).expect("a setting")],
            ..Options::default()
        };
        let scene = read(text, &options);
        let (film, _) = render(&scene, &|_| ()).expect("a picture");
        film.bytes(scene.settings.encoding())
    };
    let robust = Numerics::Robust;
    assert!(film(SCENE, robust) == film(&moved, robust));
    let narrow = Numerics::ClassicF32;
    assert!(film(SCENE, narrow) != film(&moved, narrow));
}

fn heliodon(shell: &Shell, arguments: &[&str]) -> Run {
    shell.write("scene.kdl", SCENE);
    shell.run(&[&["render", "scene.kdl", "-q", "-o", "-"], arguments].concat())
}

#[test]
fn the_command_line_takes_each_word_and_no_other() {
    let shell = Shell::new();
    let pictures = Numerics::WORDS.map(|word| {
        let run = heliodon(&shell, &["--numerics", word, "--format", "ppm"]);
        assert_eq!(run.code, Some(0), "{word}: {run:?}");
        run.stdout
    });
    let plain = heliodon(&shell, &["--format", "ppm"]);
    assert!(plain.stdout == pictures[0]);

    let run = heliodon(&shell, &["--numerics", "exact"]);
    assert_eq!(run.code, Some(2));
    run.says("[possible values: robust, classic, classic-f32]");
}
