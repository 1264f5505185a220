//! The bound of what rays that are not followed could still have brought.

use std::path::PathBuf;

use heliodon::film::Film;
use heliodon::plan::Tail;
use heliodon::read::{Options, read_bytes};
use heliodon::render::render;

/// The bound for a ray of full weight that nothing fades.
fn tail(nodes: &str) -> f64 {
    let text =
        format!("image 8 6\ncamera {{ viewpoint 0 1 9; look-at 0 1 0 }}\n{nodes}").into_bytes();
    let reading = read_bytes("tail", text, PathBuf::new(), &Options::default());
    Tail::new(&reading.expect("a scene").scene).of(1.0, 1.0)
}

#[test]
fn a_mirror_adds_a_geometric_series() {
    let silver = r#"
        material "silver" { ambient 2 0 1; specular 0.5 0 0.75 }
        plane "wall" { material "silver"; point 0 0 0; normal 0 0 1 }
    "#;
    assert_eq!(tail(silver), 8.0);
}

#[test]
fn perfect_mirrors_and_clear_panes_bring_nothing_of_their_own() {
    let with_mirror = |ambient: &str| {
        tail(&format!(
            r#"
            material "mirror" {{ specular 1; {ambient} }}
            material "pane" {{ transparency 1; diffuse 3 }}
            material "wall" {{ ambient 0.25 }}
            plane {{ material "mirror"; point 0 0 0; normal 0 0 1 }}
            plane {{ material "pane"; point 0 0 1; normal 0 0 1 }}
            plane {{ material "wall"; point 0 0 2; normal 0 0 1 }}
            "#
        ))
    };
    assert_eq!(with_mirror(""), 0.25);
    assert_eq!(with_mirror("ambient 0.5"), f64::INFINITY);
}

#[test]
fn light_counts_as_from_the_foot_of_its_perpendicular() {
    let lit = r#"
        light { location 3 4 2; emissivity 6 }
        light { location 0 0 -1; emissivity 100 }
        material "chalk" { diffuse 3; specular 0.5; shininess 4 }
        plane { material "chalk"; point 0 0 0; normal 0 0 1 }
    "#;
    // (3 · 6 / 2 + 0.5 · 6) / (1 − 0.5)
    assert_eq!(tail(lit), 24.0);
}

/// A mirror that shows a wall in the dark, as it is shown with these settings of the picture.
fn shown(settings: &str) -> Film {
    let text = format!(
        r#"
        image 8 6 transfer="srgb" {settings}
        camera {{ viewpoint 0 0.5 2; look-at 0 0 0 }}
        lighting {{ view-falloff "none" }}
        material "mirror" {{ specular 0.5 }}
        material "wall" {{ ambient 0.005 0.0005 0.00005 }}
        plane {{ material "mirror"; point 0 0 0; normal 0 1 0 }}
        plane {{ material "wall"; point 0 0 -9; normal 0 0 1 }}
        "#
    );
    let reading = read_bytes(
        "dark",
        text.into_bytes(),
        PathBuf::new(),
        &Options::default(),
    );
    let scene = reading.expect("a scene").scene;
    let (film, _) = render(&scene, &|_| ()).expect("a possible camera");
    film.displayed(scene.settings.transfer)
}

#[test]
fn what_is_cut_off_is_bounded_where_the_curve_is_steepest() {
    let whole = shown("cut-off=0");
    let largest = |cut_off: &str| {
        let film = shown(&format!("cut-off={cut_off}"));
        let pairs = film.pixels().iter().zip(whole.pixels());
        let channels = pairs.flat_map(|(a, b)| a.channels().into_iter().zip(b.channels()));
        channels.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    assert_eq!(largest("0.004"), 0.0, "it fits without the curve");
    let cut = largest("0.04");
    assert!(cut > 0.03 && cut <= 0.04, "{cut}");
}
