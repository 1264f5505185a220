//! What a scene does not call for is not done: its count is zero.

use std::path::PathBuf;

use heliodon::read::{Options, read_bytes};
use heliodon::render::{Counts, render};

fn counts(nodes: &str) -> Counts {
    let text =
        format!("image 8 6\ncamera {{ viewpoint 0 1 9; look-at 0 1 0 }}\n{nodes}").into_bytes();
    let reading = read_bytes("zeros", text, PathBuf::new(), &Options::default());
    let (_, counts) = render(&reading.expect("a scene").scene, &|_| ()).expect("a camera");
    counts
}

#[test]
fn one_plane_without_light_takes_rays_from_the_eye_and_nothing_else() {
    let counts = counts(
        r#"
        material "chalk" { ambient 1; diffuse 1 }
        plane { material "chalk"; point 0 0 0; normal 0 1 0 }
        "#,
    );
    let expected = Counts {
        camera_rays: 48,
        hit_tests: 48,
        ..Counts::default()
    };
    assert_eq!(counts, expected);
}

#[test]
fn a_light_that_nothing_hides_takes_no_ray() {
    let counts = counts(
        r#"
        light { location 3 9 3; emissivity 9 }
        material "chalk" { ambient 1; diffuse 1 }
        finite-plane "floor" {
            material "chalk"; point -9 0 5; normal 0 1 0; xdir 1 0 0; dimensions 18 10 }
        finite-plane "wall" {
            material "chalk"; point -9 0 -5; normal 0 0 1; xdir 1 0 0; dimensions 18 9 }
        "#,
    );
    assert_eq!((counts.rays(), counts.occlusion_tests), (48, 0));
}

#[test]
fn what_has_no_colour_for_light_takes_no_ray() {
    let card = |diffuse: &str| {
        counts(&format!(
            r#"
            light {{ location 0 1 8; emissivity 9 }}
            material "chalk" {{ ambient 1; {diffuse} }}
            plane "wall" {{ material "chalk"; point 0 0 -5; normal 0 0 1 }}
            finite-plane {{
                material "chalk"; point -1 0 0; normal 0 0 1; xdir 1 0 0; dimensions 2 2 }}
            "#
        ))
    };
    assert_eq!(card("").shadow_rays, 0);
    assert!(card("diffuse 1").shadow_rays > 0);
}

#[test]
fn nobody_sees_what_is_behind_the_eye() {
    let counts = counts(
        r#"
        light { location 0 9 20; emissivity 9 }
        material "chalk" { diffuse 1 }
        sphere { material "chalk"; center 0 1 19; radius 1 }
        sphere { material "chalk"; center 0 4 19; radius 1 }
        "#,
    );
    assert_eq!((counts.rays(), counts.hit_tests), (48, 0));
}
