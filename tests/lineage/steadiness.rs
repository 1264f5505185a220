//! What must not change a picture, and what must not be done for one.

use std::sync::Arc;

use heliodon::film::Film;
use proptest::prelude::*;

use super::tools::{Stage, film, hit};

/// A scene of everything, looked at from outside; `s` is the size of one unit and `at` where the
/// whole of it stands. All numbers are whole before scaling, or halves.
fn scene(s: f64, at: [f64; 3]) -> Stage {
    let place = |x: f64, y: f64, z: f64| {
        format!(
            "{:?} {:?} {:?}",
            s * (x + at[0]),
            s * (y + at[1]),
            s * (z + at[2])
        )
    };
    let (eye, target) = (place(8.0, 6.0, 20.0), place(7.0, 4.0, -4.0));
    let (lamp, spot, aim) = (
        place(3.0, 9.0, 5.0),
        place(14.0, 9.0, 9.0),
        place(8.0, 0.0, -3.0),
    );
    let (slide_lamp, slide) = (place(0.0, 5.0, 14.0), place(0.5, 3.5, 9.0));
    let (floor, wall, picture) = (
        place(0.0, 0.0, 0.0),
        place(-8.0, 0.0, -12.0),
        place(3.0, 3.0, -11.5),
    );
    let (ball, egg, pane) = (
        place(5.0, 2.0, -3.0),
        place(10.0, 3.0, -5.0),
        place(7.0, 1.0, 1.0),
    );
    let [a, b, c] = [
        place(1.0, 1.0, -6.0),
        place(3.0, 1.0, -7.0),
        place(2.0, 6.0, -7.0),
    ];
    Stage::new(&format!(
        r#"
        image 48 36
        camera {{ viewpoint {eye}; look-at {target} }}
        lighting {{ falloff "none"; view-falloff "none" }}
        texture "letter" "letter.ppm"
        material "steel" {{ ambient 0.1; diffuse 0.5; specular 0.3; shininess 20 }}
        material "glass" {{ ambient 0.1; diffuse 0 0.5 0.25; transparency 0.6 }}
        material "paper" {{ ambient 0.2; diffuse 0.6 }}
        light {{ location {lamp}; emissivity 0.6 }}
        spotlight {{ location {spot}; emissivity 0.7 0.5 0.3; point {aim}; theta 20 }}
        projector {{
            location {slide_lamp}; emissivity 0.5; texture "letter"
            point {slide}; normal -1 0 2; xdir 2 0 1; dimensions {three:?} {two:?}
        }}
        tiled-plane {{
            material "steel"; alternate "paper"; point {floor}; normal 0 1 0; xdir 3 0 -1
            dimensions {two:?} {one:?}
        }}
        texture-plane {{
            material "paper"; point {wall}; normal 0 0 1; xdir 1 0 0; dimensions {wide:?} {wide:?}
            texture "letter" mode="repeat" texel={half:?}
        }}
        texture-plane {{
            material "paper"; point {picture}; normal 1 0 3; xdir 3 1 -1; dimensions {three:?} {two:?}
            texture "letter"
        }}
        sphere {{ material "steel"; center {ball}; radius {two:?} }}
        ellipsoid {{ material "steel"; center {egg}; radius {two:?}; scale 1.5 0.5 1 }}
        finite-plane {{
            material "glass"; point {pane}; normal 1 0 2; xdir 2 0 -1; dimensions {three:?} {three:?}
        }}
        triangle {{ material "paper"; vertex1 {a}; vertex2 {b}; vertex3 {c} }}"#,
        half = s / 2.0,
        one = s,
        two = s * 2.0,
        three = s * 3.0,
        wide = s * 32.0,
    ))
    .image("letter", &["RRRR", "R..G", "RRR.", "BW.Y"])
}

fn on_threads(count: usize, scene: &heliodon::scene::Scene) -> Film {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(count)
        .build()
        .unwrap();
    pool.install(|| film(scene))
}

/// G6, P3: the picture has the same bits on any number of threads.
#[test]
fn threads_do_not_change_a_picture() {
    let mut scene = scene(1.0, [0.0; 3]).scene();
    scene.settings.samples = 2;
    let one = on_threads(1, &scene);
    assert!(
        one.pixels()
            .iter()
            .filter(|pixel| !pixel.is_black())
            .count()
            > 1000
    );
    for count in [2, 3, 8] {
        assert!(on_threads(count, &scene) == one, "{count} threads");
    }
}

/// G6, G7: a hit is a value: what is asked of a surface later does not change it, and a miss
/// leaves nothing behind.
#[test]
fn surfaces_keep_nothing() {
    let scene = scene(1.0, [0.0; 3]).scene();
    let wall = &*scene.surfaces[1];
    let first = hit(wall, [4.0, 6.0, 0.0], [0.0, 0.0, -1.0]).unwrap();
    let (ambient, diffuse) = (wall.getamb(&first), wall.getdiff(&first));
    let other = hit(wall, [5.5, 3.0, 0.0], [0.0, 0.0, -1.0]).unwrap();
    assert_ne!(wall.getamb(&other), ambient);
    assert_eq!(hit(wall, [400.0, 6.0, 0.0], [0.0, 0.0, -1.0]), None);
    assert_eq!(
        (wall.getamb(&first), wall.getdiff(&first)),
        (ambient, diffuse)
    );
    assert_eq!(hit(wall, [4.0, 6.0, 0.0], [0.0, 0.0, -1.0]), Some(first));
}

/// G8: one texel function answers for ambient, diffuse and what goes through.
#[test]
fn there_is_one_texel_function() {
    let scene = scene(1.0, [0.0; 3]).scene();
    let wall = &*scene.surfaces[1];
    let material = Arc::clone(&wall.common().material);
    for x in 0..20u8 {
        let hit = hit(wall, [f64::from(x) / 2.0, 6.0, 0.0], [0.0, 0.0, -1.0]).unwrap();
        assert_eq!(wall.getamb(&hit), material.ambient * hit.texel);
        assert_eq!(wall.getdiff(&hit), material.diffuse * hit.texel);
    }
}

/// P2: what stands behind everything changes nothing.
#[test]
fn what_is_behind_everything_changes_nothing() {
    let behind = r#"
        sphere { material "red"; center 8 6 -40; radius 9 }
        finite-plane { material "blue"; point -20 0.5 -13; normal 0 0 1; xdir 1 0 0; dimensions 60 60 }
        triangle { material "red"; vertex1 0 0 -30; vertex2 9 0 -30; vertex3 0 9 -30 }"#;
    let room = r#"
        texture "oak" "../textures/oak-128.png"
        material "m" { ambient 1; diffuse 4; specular 0.25 }
        light { location 3 8 1; emissivity 6 }
        plane { material "m"; point 0 0 0; normal 0 1 0 }
        texture-plane {
            material "m"; point -50 -1 -12; normal 0 0 1; xdir 1 0 0; dimensions 200 200
            texture "oak"
        }
        sphere { material "m"; center 15 3 -6; radius 3 }"#;
    let alone = Stage::grid(room).film();
    assert_eq!(Stage::grid(&[room, behind].concat()).film(), alone);
    assert_eq!(Stage::grid(&[behind, room].concat()).film(), alone);
}

/// P5: a light behind the surface is sent no shadow ray, nor is any from a surface that receives
/// none; a scene without lights or mirrors has neither kind of ray.
#[test]
fn only_the_rays_that_are_called_for() {
    let plane = |material: &str, shadows: &str| {
        format!(
            r#"material "m" {{ {material} }}
            plane {{ material "m"; point 0 0 -4; normal 0 0 1; {shadows} }}"#
        )
    };
    let count = |text: &str| {
        let counts = Stage::grid(text).counts();
        [
            counts.camera_rays,
            counts.shadow_rays,
            counts.mirror_rays,
            counts.transmitted_rays,
        ]
    };
    let (before, behind) = (
        "light { location 0 0 0; emissivity 1 }",
        "light { location 0 0 -9; emissivity 1 }",
    );
    let matte = plane("diffuse 1", "");
    assert_eq!(count(&matte), [512, 0, 0, 0]);
    // Nothing can stand in the way, so no ray asks.
    assert_eq!(count(&[&matte, before].join("\n")), [512, 0, 0, 0]);
    // Something can before the wall, so rays from there ask, but none from the card itself.
    let near = "light { location 15 7 -1; emissivity 1 }";
    let card = "finite-plane {
        material \"m\"; point 13 6 -2; normal 0 0 1; xdir 1 0 0; dimensions 4 2 }";
    let [_, asking, mirrored, through] = count(&[&matte, card, near].join("\n"));
    assert_eq!(asking, 512 - 3);
    assert_eq!([mirrored, through], [0, 0]);
    assert_eq!(count(&[&matte, behind].join("\n")), [512, 0, 0, 0]);
    let backdrop = plane("diffuse 1", "shadows receive=#false");
    assert_eq!(count(&[&backdrop, before].join("\n")), [512, 0, 0, 0]);
    // Where nothing has a colour, no ray can bring one back.
    assert_eq!(count(&plane("specular 0.5", "")), [512, 0, 0, 0]);
    let mirror = plane("ambient 1; specular 0.5", "");
    assert_eq!(count(&mirror), [512, 0, 512, 0]);
    let pane = plane("ambient 1; transparency 0.5", "");
    assert_eq!(count(&pane), [512, 0, 0, 512]);
    assert_eq!(count(before), [512, 0, 0, 0]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// P1: a scene scaled by a power of two is the same picture, to the last bit.
    #[test]
    fn scale_does_not_change_a_picture(power in -60i32..60) {
        let original = scene(1.0, [0.0; 3]).film();
        let scaled = scene(2.0f64.powi(power), [0.0; 3]).film();
        prop_assert!(scaled == original);
    }

    /// P1: moved by whole units, however far, it is too.
    #[test]
    fn place_does_not_change_a_picture(at in prop::array::uniform3(-(1i32 << 20)..1 << 20)) {
        let original = scene(1.0, [0.0; 3]).film();
        let moved = scene(1.0, at.map(f64::from)).film();
        prop_assert!(moved == original);
    }
}
