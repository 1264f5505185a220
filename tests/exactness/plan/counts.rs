//! Work that can be counted by hand, and that no number of threads changes.

use heliodon::plan::Scope;
use heliodon::read::{Options, read_bytes, read_file};
use heliodon::render::{Counts, Render, render};

/// The work of a picture of 8 by 6 pixels that a white wall fills.
fn counts(nodes: &str) -> Counts {
    let text = format!(
        r#"
        image 8 6
        camera {{ viewpoint 0 0 9; look-at 0 0 0; field-of-view 40 }}
        texture "bricks" "textures/brick-128.png"
        material "chalk" {{ ambient 1; diffuse 1 }}
        material "glass" {{ ambient 1; diffuse 1; transparency 0.5 }}
        {nodes}
        "#
    );
    let reading = read_bytes("counts", text.into_bytes(), "".into(), &Options::default());
    let scene = reading
        .unwrap_or_else(|no| panic!("{:#?}", no.diagnostics))
        .scene;
    render(&scene, &|_| ()).expect("a camera").1
}

const WALL: &str = r#"plane "wall" { material "chalk"; point 0 0 0; normal 0 0 1 }"#;

/// A rectangle around (0, 0, z) behind the eye, with its front to the wall.
fn behind_the_eye(word: &str, z: f64, side: f64, more: &str) -> String {
    let half = side / 2.0;
    format!(
        "{word} {{ point {half} -{half} {z}; normal 0 0 -1; xdir -1 0 0; \
         dimensions {side} {side}; {more} }}\n"
    )
}

#[test]
fn each_light_and_lamp_has_its_own_count_of_tests() {
    let card = behind_the_eye("finite-plane", 10.0, 0.125, r#"material "chalk""#);
    let lamp = behind_the_eye("lamp", 12.0, 4.0, "emissivity 5; samples 4");
    // So near behind the card that all of the wall is in its shadow; before it; and all around it.
    let lights =
        "light { location 0 0 10.01; emissivity 9 }\nlight { location 1 0 8; emissivity 9 }";
    let counts = counts(&format!("{lights}\n{WALL}\n{card}\n{lamp}"));
    assert_eq!(counts.shadow_rays, 48);
    assert_eq!(counts.lamp_rays, 4 * 48);
    assert_eq!(counts.occlusion_tests_of, [48, 0, 4 * 48]);
    let of = [0, 1, 2, 3].map(|light| counts.occlusion_tests_of(light));
    assert_eq!(of, [48, 0, 4 * 48, 0]);
    assert_eq!(counts.occlusion_tests, 5 * 48);
    assert_eq!(counts.texel_fetches, 0);
}

#[test]
fn a_texel_is_fetched_for_each_ray_that_sees_one() {
    let seen = counts(
        r#"texture-plane "wall" {
            material "chalk"; point -9 -9 0; normal 0 0 1; xdir 1 0 0; dimensions 18 18
            texture "bricks" }"#,
    );
    assert_eq!((seen.camera_rays, seen.texel_fetches), (48, 48));
}

#[test]
fn a_texel_is_fetched_for_each_ray_that_a_pane_tints() {
    let pane = |texture: &str| {
        let material = format!(r#"material "glass"; {texture}"#);
        let word = if texture.is_empty() {
            "finite-plane"
        } else {
            "texture-plane"
        };
        behind_the_eye(word, 10.0, 4.0, &material)
    };
    let light = "light { location 0 0 10.25; emissivity 9 }";
    let tinted = counts(&format!("{light}\n{WALL}\n{}", pane(r#"texture "bricks""#)));
    assert_eq!((tinted.shadow_rays, tinted.texel_fetches), (48, 48));
    let plain = counts(&format!("{light}\n{WALL}\n{}", pane("")));
    assert_eq!((plain.shadow_rays, plain.texel_fetches), (48, 0));
    // All ways to a small lamp, too, go through the pane.
    let lamp = behind_the_eye("lamp", 10.25, 0.25, "emissivity 5; samples 4");
    let soft = counts(&format!("{WALL}\n{}\n{lamp}", pane(r#"texture "bricks""#)));
    assert_eq!((soft.lamp_rays, soft.texel_fetches), (4 * 48, 4 * 48));
}

#[test]
fn a_texel_is_fetched_for_each_ray_through_a_slide() {
    let projector = r#"
        projector { location 0 0 10.25; emissivity 9
            point -2 -2 10; normal 0 0 1; xdir 1 0 0; dimensions 4 4; texture "bricks" }"#;
    let thrown = counts(&format!("{projector}\n{WALL}"));
    assert_eq!((thrown.shadow_rays, thrown.texel_fetches), (0, 48));
}

#[test]
fn no_count_depends_on_threads_or_runs() {
    let options = Options {
        size: Some([48, 36]),
        ..Options::default()
    };
    for name in ["room", "coloured-glass", "lamp-room", "projector-show"] {
        let path = format!("scenes/{name}.kdl");
        let reading = read_file(path.as_ref(), &options).expect("a file");
        let scene = reading.expect("a scene").scene;
        for scope in [Scope::CalledFor, Scope::Everything] {
            let counts = |threads| -> Counts {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
                let pool = pool.build().expect("threads");
                let drawn = pool.install(|| Render::new(&scene).scope(scope).film());
                drawn.expect("a camera").1
            };
            let one = counts(1);
            assert!(
                [1, 2, 5].map(counts).iter().all(|other| *other == one),
                "{name}"
            );
            let sum: u64 = one.occlusion_tests_of.iter().sum();
            assert_eq!(sum, one.occlusion_tests, "{name}");
            assert!(one.texel_fetches > 0 || name == "lamp-room", "{name}");
        }
    }
}
