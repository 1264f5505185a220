//! `max-error`: what it promises, and what it does not depend on.

use std::path::PathBuf;

use heliodon::film::{Film, Transfer};
use heliodon::plan::{Plan, Scope};
use heliodon::read::{Options, read_bytes};
use heliodon::render::{Counts, Render, Tracer, pixel_color};
use heliodon::scene::Scene;

use super::scene;

fn drawn(scene: &Scene) -> (Film, Counts) {
    Render::new(scene).film().expect("a possible camera")
}

fn of_text(text: &str) -> Scene {
    let read = read_bytes("scene", text.into(), PathBuf::new(), &Options::default());
    read.expect("a scene without mistakes").scene
}

/// How far off the worst channel of each pixel is, as a picture shows it.
fn errors(film: &Film, truth: &Film) -> Vec<f64> {
    let pairs = film.pixels().iter().zip(truth.pixels());
    pairs
        .map(|(pixel, truth)| {
            let channels = pixel.channels().into_iter().zip(truth.channels());
            channels
                .map(|(a, b)| (a.clamp(0.0, 1.0) - b.clamp(0.0, 1.0)).abs())
                .fold(0.0, f64::max)
        })
        .collect()
}

fn share_within(errors: &[f64], limit: f64) -> f64 {
    errors.iter().filter(|error| **error <= limit).count() as f64 / errors.len() as f64
}

#[test]
fn the_target_is_met_with_fewer_rays_than_equally_many_everywhere_would_take() {
    let (size, limit) = ([64, 48], 2.0 / 255.0);
    for name in SCENES {
        let (truth, _) = drawn(&scene(
            name,
            size,
            &[("samples", "1024"), ("pattern", "stratified")],
        ));
        let (film, adaptive) = drawn(&scene(
            name,
            size,
            &[("samples", "1"), ("max-error", "2/255")],
        ));
        let share = share_within(&errors(&film, &truth), limit);
        assert!(share >= 0.995, "{name}: {share}");
        let count = (adaptive.camera_rays / (64 * 48)).to_string();
        let uniform = scene(name, size, &[("samples", &count), ("pattern", "sobol")]);
        let beside = share_within(&errors(&drawn(&uniform).0, &truth), limit);
        assert!(
            beside < 0.995,
            "{name}: {count} rays everywhere give {beside}"
        );
    }
}

/// Scenes of edges, shadows, images, mirrors and beams.
const SCENES: [&str; 3] = ["saucers-textured", "brick-box", "spotlights"];

/// A white thread before a black wall, thinner than a pixel by far: no ray of four meets it in most
/// pixels, and none of those around them.
const THREAD: &str = r#"
    image 40 30 max-error=0.0078
    camera { viewpoint 0 0 10; look-at 0 0 0; field-of-view 60 }
    lighting { view-falloff "none" }
    material "white" { ambient 1 }
    finite-plane "thread" {
        material "white"; point -3 -2.03 0; normal 0 0 1; xdir 4 3 0; dimensions 6 0.015 }"#;

#[test]
fn a_thread_that_rays_miss_is_not_missed() {
    let film = drawn(&of_text(THREAD)).0;
    let most = "image 40 30 samples=16384 pattern=\"sobol\"";
    let truth = drawn(&of_text(
        &THREAD.replace("image 40 30 max-error=0.0078", most),
    ))
    .0;
    let seen = truth.pixels().iter().filter(|pixel| pixel.r > 0.0078);
    assert!(seen.count() > 10, "the thread is not there");
    let errors = errors(&film, &truth);
    let worst = errors.iter().copied().fold(0.0, f64::max);
    assert!(worst <= 0.0078, "{worst}");
}

#[test]
fn where_nothing_happens_four_rays_are_enough() {
    let wall = r#"
        image 16 12 max-error=0.001
        camera { viewpoint 0 0 10; look-at 0 0 0 }
        lighting { view-falloff "none" }
        material "grey" { ambient 0.5 }
        plane "wall" { material "grey"; point 0 0 0; normal 0 0 1 }"#;
    assert_eq!(drawn(&of_text(wall)).1.camera_rays, 4 * 16 * 12);
    // With `samples` they are the fewest, as a power of two.
    let more = wall.replace("max-error", "samples=9 max-error");
    assert_eq!(drawn(&of_text(&more)).1.camera_rays, 16 * 16 * 12);
}

#[test]
fn an_outline_behind_what_is_seen_costs_nothing() {
    let hidden = r#"
        image 16 12 max-error=0.001
        camera { viewpoint 0 0 10; look-at 0 0 0 }
        lighting { view-falloff "none" }
        material "grey" { ambient 0.5 }
        plane "wall" { material "grey"; point 0 0 0; normal 0 0 1 }
        sphere "behind" { material "grey"; center 0 0 -4; radius 2 }"#;
    assert_eq!(drawn(&of_text(hidden)).1.camera_rays, 4 * 16 * 12);
    let before = hidden.replace("0 0 -4", "0 0 4");
    assert!(drawn(&of_text(&before)).1.camera_rays > 5 * 16 * 12);
}

#[test]
fn a_pixel_alone_is_as_in_the_picture() {
    let scene = scene("saucers-textured", [24, 18], &[("max-error", "4/255")]);
    let film = drawn(&scene).0;
    let plan = Plan::new(&scene, Scope::CalledFor).expect("a possible camera");
    for (column, row) in [(0, 0), (11, 9), (12, 15), (23, 17)] {
        let alone = pixel_color(Tracer::new(&plan), &scene, column, row, &mut ());
        assert_eq!(alone, film.pixel(column, row), "{column},{row}");
    }
}

/// Tiles in the dark: without the curve they are worth no rays.
const DUSK: &str = r#"
    image 40 30 samples=1
    camera { viewpoint 0 0 10; look-at 0 0 0; field-of-view 60 }
    lighting { view-falloff "none" }
    material "dusk" { ambient 0.025 }
    material "night" { ambient 0 }
    tiled-plane "wall" {
        material "dusk"; alternate "night"
        point -3 -2.03 0; normal 0 0 1; xdir 4 3 0; dimensions 2 2 }"#;

#[test]
fn what_is_right_is_what_is_shown() {
    let (limit, curve) = (2.0 / 255.0, Transfer::Srgb);
    let picture = |settings: &str| {
        let text = DUSK.replace("samples=1", settings);
        drawn(&of_text(&text)).0.displayed(curve)
    };
    let truth = picture("samples=4096 pattern=\"sobol\"");
    let within = |film: &Film| share_within(&errors(film, &truth), limit);
    let blind = within(&picture("max-error=0.0078"));
    let seeing = within(&picture("max-error=0.0078 transfer=\"srgb\""));
    assert!(blind < 0.99, "{blind}");
    assert!(seeing >= 0.995, "{seeing}");
}

#[test]
fn what_a_filter_is_off_in_a_round_mirror_is_asked_for_by_smaller_shares() {
    let rays = |filter: &str, ball: &str| {
        // Of the texture one texel is seen.
        let text = format!(
            r#"
            image 16 12 max-error=0.0078 texture-filter="{filter}"
            camera {{ viewpoint 3000 10 3000; look-at 3000 0 2998; field-of-view 20 }}
            lighting {{ falloff none; view-falloff none }}
            texture "tile" "textures/tile-128.png"
            material "flat" {{ ambient 0.5 }}
            material "silver" {{ ambient 0.5; specular 0.5; shininess 90 }}
            texture-plane {{
                material "flat"
                point -5e5 0 5e5; normal 0 1 0; xdir 1 0 0; dimensions 1e6 1e6
                texture "tile"
            }}
            {ball}
            "#
        );
        let (_, counts) = drawn(&of_text(&text));
        assert_eq!(counts.camera_rays % (16 * 12), 0);
        counts.camera_rays / (16 * 12)
    };
    let ball = r#"sphere { material "silver"; center 3000 -45 2999; radius 50 }"#;
    assert_eq!([rays("nearest", ""), rays("nearest", ball)], [4, 4]);
    assert_eq!([rays("exact", ""), rays("exact", ball)], [4, 4 + 16]);
    assert_eq!(rays("anisotropic", ""), 4 + 16);
}

#[test]
fn rays_that_are_brighter_than_white_do_not_hide_what_none_of_them_has_met() {
    let lamps = r#"
        image 60 45 max-error=0.0078
        camera { viewpoint 0 0 10; look-at 0 0 0; field-of-view 60 }
        lighting { view-falloff "none" }
        material "lamp" { ambient 1.17 }
        material "wall" { ambient 0.3 }
        tiled-plane "lamps" {
            material "lamp"; alternate "wall"
            point -3 -2.03 0; normal 0 0 1; xdir 4 3 0; dimensions 0.19 0.23 }"#;
    let truth = "image 60 45 samples=4096 pattern=\"sobol\"";
    let truth = drawn(&of_text(
        &lamps.replace("image 60 45 max-error=0.0078", truth),
    ))
    .0;
    let errors = errors(&drawn(&of_text(lamps)).0, &truth);
    let worst = errors.iter().copied().fold(0.0, f64::max);
    assert!(worst < 0.03, "{worst}");
}

/// A floor of tiles that are finer than the pixels, and what stands above it.
fn floor(above: &str) -> Scene {
    of_text(&format!(
        r#"
        image 24 18 max-error=0.0078 texture-filter="exact"
        camera {{ viewpoint 0 9 9; look-at 0 0 0; field-of-view 40 }}
        lighting {{ falloff none; view-falloff none }}
        texture "tile" "textures/tile-128.png"
        material "tile" {{ ambient 0.2; diffuse 0.7 }}
        material "chalk" {{ ambient 0.3 }}
        material "pane" {{ ambient 0.1; transparency 0.6 }}
        light {{ location 0 60 0; emissivity 1 }}
        texture-plane {{
            material "tile"
            point -50 0 50; normal 0 1 0; xdir 1 0 0; dimensions 100 100
            texture "tile" mode="repeat" texel=0.0078125
        }}
        {above}
        "#
    ))
}

#[test]
fn an_image_with_the_exact_filter_takes_rays_only_at_borders() {
    let rays = |above: &str| drawn(&floor(above)).1.camera_rays / (24 * 18);
    assert_eq!(
        rays(""),
        4 + 16,
        "whatever the tiles are like next to a pixel"
    );
    // What casts the shadows is behind the eye.
    for border in [
        r#"finite-plane { material "chalk"; point -1 20 1; normal 0 1 0; xdir 4 0 3; dimensions 1.5 1 }"#,
        r#"finite-plane { material "pane"; point -1 20 1; normal 0 1 0; xdir 4 0 3; dimensions 1.5 1 }"#,
        r#"tiled-plane { material "chalk"; alternate "pane"; point -1 0.1 1; normal 0 1 0; xdir 4 0 3; dimensions 30 20 }"#,
        // No border, but light from all sides.
        r#"light { location 0.3 0.05 0.2; emissivity 1 }"#,
    ] {
        let (film, counts) = drawn(&floor(border));
        let mean = counts.camera_rays / (24 * 18);
        assert!((5..100).contains(&mean), "{border}: {mean}");
        let mut even = floor(border);
        even.settings.max_error = 0.0;
        even.settings.samples = 4096;
        let errors = errors(&film, &drawn(&even).0);
        let share = share_within(&errors, 2.0 / 255.0);
        assert!(share >= 0.995, "{border}: {share}");
    }
}
