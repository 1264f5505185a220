//! Measurements of accuracy against time: the sweep follows from the scene, and counts are equal
//! in every run.

mod command;
mod text;

use std::path::PathBuf;

use heliodon::camera::Pattern;
use heliodon::measure::{Cost, CostOptions, Limit, Reference, Sweep, Variation, cost, effects_of};
use heliodon::read::{Options, read_bytes, read_file};
use heliodon::render::render;
use heliodon::scene::{RenderSettings, Scene};
use heliodon::texture::Filter;
use rayon::ThreadPoolBuilder;

const SCENE: &str = r#"
image 32 24
camera { viewpoint 0 1 4; look-at 0 1 0 }
material "chalk" { ambient 0.1; diffuse 2 }
light { location 2 4 3; emissivity 2 }
plane "floor" { material "chalk"; point 0 0 0; normal 0 1 0 }
sphere "ball" { material "chalk"; center 0 1 0; radius 1 }
"#;

fn scene(text: &str) -> Scene {
    let reading = read_bytes("test", text.into(), PathBuf::new(), &Options::default());
    reading
        .unwrap_or_else(|no| panic!("{:?}", no.diagnostics))
        .scene
}

fn room() -> Scene {
    let options = Options {
        size: Some([40, 30]),
        ..Options::default()
    };
    let reading = read_file("scenes/room.kdl".as_ref(), &options).expect("a file");
    reading.expect("a scene").scene
}

fn labels(scene: &Scene) -> Vec<String> {
    let effects = effects_of(scene).expect("a possible camera");
    let sweep = Sweep::of(scene.settings, &effects);
    sweep.0.into_iter().map(|step| step.label).collect()
}

fn measured(scene: &mut Scene, variations: &[&str], threads: usize) -> Cost {
    let variations = variations.iter().map(|text| Variation::new(text));
    let variations: Vec<_> = variations.map(|it| it.expect("a variation")).collect();
    let sweep = Sweep::each(scene.settings, &variations).expect("a sweep");
    let pool = ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.expect("threads");
    pool.install(|| cost(scene, &sweep, CostOptions::default(), &|_, _| ()))
        .expect("a cost")
}

#[test]
fn the_sweep_has_only_what_the_scene_calls_for() {
    let plain = labels(&scene(SCENE));
    assert!(plain.len() >= 12, "{plain:?}");
    let room = labels(&room());
    assert!(room.len() >= 12, "{room:?}");
    for (word, in_room) in [("cut-off=", true), ("samples=", true), ("numerics=", true)] {
        let is_on = |labels: &[String]| labels.iter().any(|label| label.contains(word));
        assert_eq!(is_on(&room), in_room, "{word}");
        assert_eq!(is_on(&plain), word != "cut-off=", "{word}");
    }
    let filters = |labels: &[String]| labels.iter().any(|label| label.contains("filter"));
    assert!(!filters(&plain), "{plain:?}");
    let mirror = scene(&SCENE.replace("diffuse 2", "diffuse 2; specular 0.3"));
    assert!(labels(&mirror).iter().any(|label| label == "cut-off=0.25"));
}

#[test]
fn counts_and_errors_are_the_same_on_any_number_of_threads() {
    let mut room = room();
    let before = room.settings;
    let variations = ["samples=4", "cut-off=1", "numerics=classic"];
    let [one, three] = [1, 3].map(|threads| measured(&mut room, &variations, threads));
    assert_eq!(
        room.settings, before,
        "the scene has its own settings again"
    );
    let pairs = one.steps.iter().zip(&three.steps);
    assert_eq!(pairs.clone().count(), 4);
    for (one, three) in pairs {
        assert_eq!(one.label, three.label);
        assert_eq!(one.counts, three.counts, "{}", one.label);
        assert_eq!(one.deviation, three.deviation, "{}", one.label);
        assert_eq!(one.own, three.own, "{}", one.label);
    }
    let base = &one.steps[0];
    let (film, counts) = render(&room, &|_| ()).expect("a picture");
    assert_eq!(base.counts, counts);
    assert_eq!(one.reference.deviation(&film), base.deviation);
    let rays = |step: usize| one.steps[step].counts.camera_rays;
    assert_eq!((rays(0), rays(1)), (1200, 4800));
    assert_eq!(one.steps[2].counts.mirror_rays, 0, "cut off");
}

#[test]
fn more_samples_are_closer_to_the_reference() {
    let cost = measured(&mut scene(SCENE), &["samples=4,16,64"], 1);
    let errors: Vec<_> = cost.steps.iter().map(|step| step.deviation.rmse).collect();
    assert!(errors.is_sorted_by(|more, less| more > less), "{errors:?}");
    let seen: Vec<_> = cost.steps.iter().map(|step| step.deviation.flip).collect();
    assert!(seen.is_sorted_by(|more, less| more > less), "{seen:?}");
    let own = cost.reference.uncertainty.expect("two halves");
    assert!(own.rmse > 0.0 && own.rmse < errors[3] / 2.0, "{own:?}");
    let sums: f64 = cost.breakdowns[0]
        .features
        .iter()
        .map(|share| share.error)
        .sum();
    assert!((sums - 1.0).abs() < 1e-9);
    let most = cost.breakdowns[0].features[0];
    assert_eq!(most.feature.words(), "at edges of surfaces");
    assert!(most.error > 0.5 && most.pixels < 0.2, "{most:?}");
}

#[test]
fn what_max_error_adds_is_compared_with_more() {
    // Where white borders on black, most rays are added.
    let ball = r#"image 32 24; camera { viewpoint 0 1 4; look-at 0 1 0 }
        material "snow" { ambient 1; diffuse 0 }
        sphere { material "snow"; center 0 1 0; radius 1 }"#;
    let in_scene = ball.replace("image 32 24", "image 32 24 max-error=0.008");
    for (text, variation) in [(ball, "max-error=2/255"), (&in_scene, "numerics=classic")] {
        let cost = measured(&mut scene(text), &[variation], 1);
        let error = cost.steps.last().expect("a step").deviation.rmse;
        let own = cost.reference.uncertainty.expect("two halves").rmse;
        assert!(own > 0.0 && own < error / 3.0, "{own} {error}");
    }
}

#[test]
fn the_cheapest_and_the_best_within_a_time_are_named() {
    let cost = measured(&mut scene(SCENE), &["samples=4,64"], 1);
    let cheapest = |text| cost.cheapest(Limit::new(text).expect("a limit")).label;
    assert_eq!(cheapest("max=0"), None);
    assert!(cheapest("max=255").is_some());
    let exact = format!("rmse={}", cost.steps[2].deviation.rmse);
    assert_eq!(cheapest(&exact).as_deref(), Some("samples=64"));
    assert_eq!(cost.within(3600.0).label.as_deref(), Some("samples=64"));
    assert_eq!(cost.within(1e-9).label, None);
}

#[test]
fn a_picture_does_not_differ_from_itself() {
    for curve in ["", "transfer=\"srgb\""] {
        does_not_differ_from_itself(&SCENE.replace("image 32 24", &format!("image 32 24 {curve}")));
    }
}

fn does_not_differ_from_itself(text: &str) {
    let mut scene = scene(text);
    let transfer = scene.settings.transfer;
    let (film, _) = render(&scene, &|_| ()).expect("a picture");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("it.pfm");
    let mut bytes = Vec::new();
    film.write(
        &mut bytes,
        heliodon::film::Format::Pfm,
        scene.settings.rounding,
        &heliodon::film::Notes::default(),
    )
    .expect("bytes");
    std::fs::write(&path, bytes).expect("a file");
    let reference = Reference::from_file(&path, [32, 24], transfer).expect("a picture");
    assert!(Reference::from_file(&path, [32, 25], transfer).is_err());
    let variations = ["quantize=truncate", "quantize=round"].map(Variation::new);
    let variations = variations.map(|it| it.expect("a variation"));
    let sweep = Sweep::each(scene.settings, &variations).expect("a sweep");
    let options = CostOptions {
        reference: Some(reference),
        runs: 2,
        ..CostOptions::default()
    };
    let cost = cost(&mut scene, &sweep, options, &|_, _| ());
    let cost = cost.expect("a cost");
    assert!(cost.steps[0].deviation.rmse < 1e-6);
    // One of a code value is off at most when truncated.
    let largest = cost.steps[1].deviation.change.largest;
    assert!((0.9..=1.0).contains(&largest), "{largest}");
    assert_eq!(cost.reference.uncertainty, None);
    assert!(cost.steps[0].cpu.deviation.is_some());
}

#[test]
fn each_depth_errs_by_itself_as_far_as_it_rounds() {
    for curve in ["none", "srgb"] {
        let image = format!("image 32 24 transfer=\"{curve}\"");
        let mut scene = scene(&SCENE.replace("image 32 24", &image));
        let cost = measured(&mut scene, &["depth=8,16,float", "quantize=truncate"], 1);
        let labels: Vec<_> = cost.steps.iter().map(|step| step.label.as_str()).collect();
        let expected = [
            "as it is",
            "depth=8",
            "depth=16",
            "depth=float",
            "quantize=truncate",
        ];
        assert_eq!(labels, expected);
        let own = |step: usize, setting| cost.steps[step].own(setting).expect("an error").rmse;
        // Some of the picture is black, which every depth keeps.
        let even = 1.0 / 12.0_f64.sqrt();
        assert!((0.3..1.1).contains(&(own(1, "depth") * 255.0 / even)));
        assert!((0.3..1.1).contains(&(own(2, "depth") * 65_535.0 / even)));
        assert!((1e-10..1e-7).contains(&own(3, "depth")));
        assert!(own(4, "quantize") > 1.5 * own(1, "depth"));
        // The errors of a picture are told in code values of 255, whatever its depth.
        let largest = |step: usize| cost.steps[step].deviation.change.largest;
        assert!((largest(1) - largest(3)).abs() <= 0.5 + 1e-9);
        assert!((largest(2) - largest(3)).abs() <= 0.5 / 257.0 + 1e-9);
    }
}

#[test]
fn a_pattern_means_nothing_to_one_ray_and_to_those_that_max_error_adds() {
    let drawn = |file: &str, picture: &dyn Fn(RenderSettings) -> RenderSettings| {
        let options = Options {
            size: Some([24, 18]),
            ..Options::default()
        };
        let reading = read_file(file.as_ref(), &options).expect("a file");
        let mut scene = reading.expect("a scene").scene;
        scene.settings = picture(scene.settings);
        render(&scene, &|_| ()).expect("a picture")
    };
    for file in ["room", "lamp-room", "horizon", "glass-ball"] {
        let file = format!("scenes/{file}.kdl");
        for filter in [Filter::Nearest, Filter::Anisotropic, Filter::Exact] {
            for (max_error, patterns) in [
                (0.0, &Pattern::ALL[..]),
                (0.2, &[Pattern::Stratified, Pattern::Sobol]),
            ] {
                let with = |pattern: Pattern| {
                    drawn(&file, &|picture| RenderSettings {
                        samples: 1,
                        texture_filter: filter,
                        max_error,
                        pattern,
                        ..picture
                    })
                };
                let (first, first_counts) = with(patterns[0]);
                for pattern in &patterns[1..] {
                    let (film, counts) = with(*pattern);
                    let place = format!("{file} {filter:?} {max_error} {pattern:?}");
                    assert!(film.pixels() == first.pixels(), "{place}");
                    assert_eq!(counts, first_counts, "{place}");
                }
            }
        }
    }
}

#[test]
fn floats_are_not_tried_with_each_rounding() {
    let about = |image: &str, word: &str| {
        let all = labels(&scene(&SCENE.replace("image 32 24", image)));
        let about = all.into_iter().filter(|label| label.starts_with(word));
        about.collect::<Vec<_>>()
    };
    let rounding = |image: &str| about(image, "quantize");
    assert_eq!(rounding("image 32 24"), ["quantize=truncate"]);
    assert_eq!(rounding("image 32 24 depth=16"), ["quantize=truncate"]);
    assert_eq!(rounding("image 32 24 depth=float"), [""; 0]);
    for depth in ["8", "16", "float"] {
        let image = format!("image 32 24 depth={depth}");
        assert_eq!(about(&image, "depth").len(), 3);
    }
}
