//! What is left out changes nothing: pictures of everything are the same, bit for bit.
//!
//! `HELIODON_ELISION_SCENES=10000 cargo test --release --test exactness elision` draws that many
//! random scenes; `HELIODON_ELISION_FROM` begins with another one.

mod budget;
mod rounding;

use std::path::PathBuf;

use heliodon::film::Film;
use heliodon::plan::Scope;
use heliodon::read::{Options, read_bytes};
use heliodon::render::{Counts, Render};
use heliodon::scene::Scene;
use rayon::prelude::*;
use support::files::files;
use support::scenes::mixtures;

/// How many scenes a run of all tests draws.
const SCENES: u64 = 400;

fn from_environment(name: &str) -> Option<u64> {
    std::env::var(name).ok()?.parse().ok()
}

fn scene(text: &str) -> Result<Scene, String> {
    let read = read_bytes(
        "random",
        text.as_bytes().to_vec(),
        PathBuf::new(),
        &Options::default(),
    );
    let reading = read.map_err(|no| format!("{:?}", no.diagnostics))?;
    Ok(reading.scene)
}

fn pictures(scene: &Scene) -> [(Film, Counts); 2] {
    [Scope::CalledFor, Scope::Everything].map(|scope| {
        Render::new(scene)
            .scope(scope)
            .film()
            .expect("a possible camera")
    })
}

fn bits(film: &Film) -> Vec<[u64; 3]> {
    let pixels = film.pixels().iter();
    pixels
        .map(|pixel| pixel.channels().map(f64::to_bits))
        .collect()
}

/// The pixels in which the two pictures of a scene differ.
fn differing(scene: &Scene) -> Vec<usize> {
    let [(elided, _), (whole, _)] = pictures(scene);
    let pairs = bits(&elided).into_iter().zip(bits(&whole)).enumerate();
    pairs
        .filter(|(_, (elided, whole))| elided != whole)
        .map(|(index, _)| index)
        .collect()
}

#[test]
fn random_scenes_are_the_same_with_everything_simulated() {
    let from = from_environment("HELIODON_ELISION_FROM").unwrap_or(0);
    let count = from_environment("HELIODON_ELISION_SCENES").unwrap_or(SCENES);
    let wrong: Vec<_> = (from..from + count)
        .into_par_iter()
        .filter_map(|seed| {
            let text = mixtures::scene(seed);
            let scene = match scene(&text) {
                Ok(scene) => scene,
                Err(problems) => {
                    return Some(format!("scene {seed} is refused: {problems}\n{text}"));
                }
            };
            let differing = differing(&scene);
            (!differing.is_empty())
                .then(|| format!("scene {seed} differs in the pixels {differing:?}:\n{text}"))
        })
        .collect();
    let shown: Vec<_> = wrong.iter().take(3).map(String::as_str).collect();
    assert!(
        wrong.is_empty(),
        "{} of {count} scenes are wrong\n{}",
        wrong.len(),
        shown.join("\n")
    );
}

#[test]
fn random_scenes_call_for_everything_now_and_then() {
    let mut seen = Counts::default();
    let mut lit = 0;
    for seed in 0..100 {
        let scene = scene(&mixtures::scene(seed)).expect("a scene");
        let [(film, counts), _] = pictures(&scene);
        seen = [seen, counts].into_iter().sum();
        let bright = bits(&film).iter().filter(|pixel| **pixel != [0; 3]).count();
        lit += usize::from(bright > 50);
    }
    assert!(lit > 60, "only {lit} of 100 scenes show something");
    let kinds = [
        seen.shadow_rays,
        seen.mirror_rays,
        seen.transmitted_rays,
        seen.faint_rays,
        seen.decisions.exactly,
        seen.decisions.by_rule,
    ];
    assert!(kinds.iter().all(|count| *count > 100), "{seen:?}");
}

#[test]
fn every_scene_of_the_gallery_is_the_same_with_everything_simulated() {
    let scenes = files("scenes", "kdl");
    assert!(scenes.len() >= 17);
    for path in scenes {
        let options = Options {
            size: Some([120, 90]),
            ..Options::default()
        };
        let reading = heliodon::read::read_file(&path, &options)
            .expect("a file")
            .expect("a scene");
        let [(_, elided), (_, whole)] = pictures(&reading.scene);
        let differing = differing(&reading.scene);
        assert!(differing.is_empty(), "{}: {differing:?}", path.display());
        assert!(
            elided.hit_tests < whole.hit_tests,
            "{} leaves nothing out",
            path.display()
        );
    }
}
