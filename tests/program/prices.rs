//! What was priced is a scene that its user can have, with the effect off and nothing else changed.

use std::path::PathBuf;

use heliodon::film::Film;
use heliodon::math::Numerics;
use heliodon::measure::{prices, round_trip, without};
use heliodon::plan::{Effect, Plan, Scope};
use heliodon::read::{Options, read_bytes, read_file};
use heliodon::render::{Counts, render};
use heliodon::scene::Scene;
use support::files::files;
use support::shell::heliodon;

/// All good scenes of the project.
fn scenes() -> Vec<(PathBuf, Scene)> {
    let folders = [
        ("scenes", "kdl"),
        ("tests/good", "kdl"),
        ("tests/course", "txt"),
    ];
    let paths = folders.map(|(folder, ending)| files(folder, ending));
    let options = Options {
        size: Some([48, 36]),
        ..Options::default()
    };
    let scenes: Vec<_> = paths
        .concat()
        .into_iter()
        .filter_map(|path| {
            let reading = read_file(&path, &options).expect("a file").ok()?;
            Some((path, reading.scene))
        })
        .collect();
    assert!(scenes.len() > 18, "only {} scenes", scenes.len());
    scenes
}

fn scene(text: &str) -> Scene {
    let options = Options::default();
    let reading = read_bytes("test", text.into(), PathBuf::from("scenes"), &options);
    reading
        .unwrap_or_else(|no| panic!("{:?}", no.diagnostics))
        .scene
}

fn draw(scene: &Scene) -> (Film, Counts) {
    render(scene, &|_| ()).expect("a possible camera")
}

fn effects(scene: &Scene) -> Vec<Effect> {
    let plan = Plan::new(scene, Scope::CalledFor).expect("a possible camera");
    let decisions = plan.decisions().into_iter();
    let on = decisions.filter(|decision| decision.on);
    on.map(|decision| decision.effect).collect()
}

#[test]
fn a_scene_that_is_written_and_read_renders_to_the_same_bytes() {
    for (path, scene) in scenes() {
        let again = round_trip(&scene).expect("the same scene");
        assert_eq!(again.hash(), scene.hash(), "{}", path.display());
        let [(film, counts), (film_again, counts_again)] = [&scene, &again].map(draw);
        assert_eq!(film.hash(), film_again.hash(), "{}", path.display());
        assert_eq!(counts, counts_again, "{}", path.display());
    }
}

#[test]
fn a_scene_without_an_effect_does_not_call_for_it() {
    let mut seen = Vec::new();
    for (path, scene) in scenes() {
        for effect in effects(&scene) {
            let less = without(&scene, effect).expect("a scene without it");
            let left = effects(&less);
            let title = format!("{} without {}", path.display(), effect.title());
            assert!(!left.contains(&effect), "{title}");
            assert_eq!(less.surfaces.len(), scene.surfaces.len(), "{title}");
            assert_eq!(less.lights.len(), scene.lights.len(), "{title}");
            let (film, counts) = draw(&less);
            let (with_it, _) = draw(&scene);
            let shown = film.displayed(less.settings.transfer).hash();
            // Shadows may fall where nobody looks.
            if shown != with_it.displayed(scene.settings.transfer).hash() {
                seen.push(effect);
            }
            let gone = match effect {
                // Rounded numerics leave nothing out, not even what no one could see.
                _ if scene.settings.numerics != Numerics::Robust => 0,
                Effect::Shadows | Effect::SoftShadows => counts.shadow_rays + counts.lamp_rays,
                Effect::Mirrors => counts.mirror_rays,
                Effect::Transparency => counts.transmitted_rays,
                _ => 0,
            };
            assert_eq!(gone, 0, "{title}");
        }
    }
    for effect in Effect::ALL {
        assert!(seen.contains(&effect), "no scene shows {}", effect.title());
    }
}

#[test]
fn mirrors_take_their_glints_along_and_glints_leave_the_mirror() {
    let scene = scene(
        "image 20 15
        camera { viewpoint 0 1 4; look-at 0 1 0 }
        material \"a\" { diffuse 3; specular 0.5; shininess 9 }
        light { location 2 4 3; emissivity 8 }
        plane { material \"a\"; point 0 0 0; normal 0 1 0 }
        sphere { material \"a\"; center 0 1 0; radius 1 }",
    );
    let prices = prices(&scene, 1, &|_, _| ()).expect("prices");
    let of = |effect| {
        let mut all = prices.without.iter();
        all.find(|price| price.effect == effect).expect("a price")
    };
    assert_eq!(of(Effect::Mirrors).also_off, [Effect::Glints]);
    assert_eq!(of(Effect::Glints).also_off, []);
    assert_eq!(of(Effect::Mirrors).effort.counts.mirror_rays, 0);
    assert!(of(Effect::Glints).effort.counts.mirror_rays > 0);
    assert!(of(Effect::Glints).change.pixels > 0.0);
    assert_eq!(prices.without.len(), 3);
    assert!(prices.everything.counts.hit_tests > prices.whole.counts.hit_tests);
}

#[test]
fn the_lists_fit_on_a_terminal_and_say_in_words_what_they_show() {
    let text = std::fs::read_to_string("scenes/tiled-floor-mirrors.kdl").expect("a scene");
    let text = text.replace("image 800 600 samples=4", "image 40 30 samples=2");
    let mut steps = Vec::new();
    let steps = std::cell::RefCell::new(&mut steps);
    let prices = prices(&scene(&text), 3, &|done, all| {
        steps.borrow_mut().push((done, all));
    });
    let prices = prices.expect("prices");
    let subjects = 2 + prices.without.len();
    let steps: Vec<_> = steps.into_inner().clone();
    assert_eq!(steps.len(), 3 * subjects);
    assert_eq!(steps.last(), Some(&(3 * subjects, 3 * subjects)));
    let list = prices.to_string();
    for line in list.lines() {
        assert!(line.chars().count() <= 100, "{line}");
    }
    for price in &prices.without {
        let title = price.effect.title();
        assert!(list.contains(&format!("\n  {title} ")), "{list}");
        assert!(list.contains(&format!("Without {title}")), "{list}");
    }
    assert!(list.contains("; the picture is the same."), "{list}");
}

#[test]
fn sentences_list_effects_as_prose_does() {
    let scene = scene(
        "image 4 3 transfer=\"srgb\"
        camera { viewpoint 0 1 4; look-at 0 1 0 }
        material \"glass\" { diffuse 3; specular 0.5; shininess 9; transparency 0.5; ior 1.5 }
        light { location 2 4 3; emissivity 8 }
        sphere { material \"glass\"; center 0 1 0; radius 1 }",
    );
    let list = prices(&scene, 1, &|_, _| ()).expect("prices").list();
    for sentence in [
        "Without mirrors, refraction and glints: ",
        "Without transparency and refraction: ",
        "Without glints: ",
        "Without the transfer curve: ",
    ] {
        assert!(list.contains(sentence), "{list}");
    }
}

#[test]
fn a_scene_without_effects_has_no_prices_but_for_everything() {
    let scene = scene("image 4 3\n camera { viewpoint 0 1 4; look-at 0 1 0 }");
    let prices = prices(&scene, 0, &|_, _| ()).expect("prices");
    assert_eq!(prices.runs, 1);
    assert!(prices.without.is_empty());
    assert!(prices.list().contains("no effect"), "{}", prices.list());
    assert_eq!(prices.whole.tests_per_shadow_ray(), None);
}

#[test]
fn explain_tells_prices_if_it_is_asked_to() {
    let output = heliodon(&[
        "explain",
        "tests/course/room.txt",
        "--prices",
        "--runs",
        "2",
        "--json",
    ]);
    assert_eq!(output.code, Some(0));
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let schema = std::fs::read_to_string("docs/explain.schema.json").expect("the schema");
    let schema = serde_json::from_str(&schema).expect("JSON");
    let validator = jsonschema::validator_for(&schema).expect("a schema");
    let errors: Vec<_> = validator.iter_errors(&answer).collect();
    assert!(errors.is_empty(), "{errors:?}");
    let prices = &answer["prices"];
    assert_eq!(prices["runs"], 2);
    let without = prices["without"].as_array().expect("a list");
    let effects = answer["effects"].as_array().expect("a list");
    let on = effects.iter().filter(|effect| effect["on"] == true);
    let on: Vec<_> = on.map(|effect| &effect["effect"]).collect();
    assert!(!on.is_empty());
    assert_eq!(
        without
            .iter()
            .map(|price| &price["effect"])
            .collect::<Vec<_>>(),
        on
    );
    assert!(prices["whole"]["time"]["median"].as_f64() > Some(0.0));

    let output = heliodon(&[
        "explain",
        "tests/course/room.txt",
        "--prices",
        "--runs",
        "1",
    ]);
    let text = String::from_utf8(output.stdout).expect("text");
    assert!(text.contains("\nprices (one run)\n"), "{text}");
    let output = heliodon(&["explain", "tests/course/room.txt"]);
    assert!(!String::from_utf8_lossy(&output.stdout).contains("prices"));
}

#[test]
fn runs_without_prices_make_no_sense() {
    let output = heliodon(&["explain", "tests/course/room.txt", "--runs", "2"]);
    assert_eq!(output.code, Some(2));
}
