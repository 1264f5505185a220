//! Brightness, computed on paper.
//!
//! The eye at (0, 0, 4) looks at a wall in z = −4, so what it sees is divided by 8.

use heliodon::math::Rgb;

use super::tools::{Stage, assert_color, hit};

/// A wall with this material's attributes and these lights.
fn wall(material: &str, lights: &str) -> Rgb {
    Stage::eye(&format!(
        r#"material "wall" {{ {material} }}
        plane {{ material "wall"; point 0 0 -4; normal 0 0 1 }}
        {lights}"#
    ))
    .pixel()
}

/// The same with an image of one texel, of value (1, 0.4, 0).
fn textured(material: &str, lights: &str) -> Rgb {
    Stage::eye(&format!(
        r#"material "wall" {{ {material} }}
        texture "one" "one.ppm"
        texture-plane {{
            material "wall"; point -1 -1 -4; normal 0 0 1; xdir 1 0 0; dimensions 2 2
            texture "one"
        }}
        {lights}"#
    ))
    .file("one.ppm", b"P6 1 1 255 \xff\x66\x00")
    .pixel()
}

const LAMP: &str = "light { location 0 0 0; emissivity 6 }";

/// S6: (ambient + diffuse × emissivity × cos / d) / path, with d = 4, cos = 1 and path = 8.
#[test]
fn a_light_straight_ahead() {
    assert_color(wall("ambient 2; diffuse 3", LAMP), [0.8125; 3]);
}

/// S6: the same from aside, with d = 5 and cos = 4/5.
#[test]
fn a_light_from_aside() {
    let lamp = "light { location 3 0 0; emissivity 6 }";
    assert_color(wall("ambient 2; diffuse 3", lamp), [0.61; 3]);
}

/// S6: colours are multiplied channel by channel, and may be above 1.
#[test]
fn channels_do_not_mix() {
    let lamp = "light { location 0 0 0; emissivity 4 8 0 }";
    assert_color(
        wall("ambient 0 0 16; diffuse 2 0 3", lamp),
        [0.25, 0.0, 2.0],
    );
}

/// S6: the lights are summed.
#[test]
fn lights_are_summed() {
    let lamps = "light { location 0 0 0; emissivity 6 }
        light { location 3 0 0; emissivity 6 }";
    assert_color(wall("ambient 2; diffuse 3", lamps), [0.8125 + 0.36; 3]);
}

/// S6, R33: the light's distance divides once, or as the scene says.
#[test]
fn the_fall_off_can_be_chosen() {
    let with = |falloff: &str| {
        let lamp = format!("{LAMP}\n lighting {{ falloff \"{falloff}\" }}");
        wall("diffuse 8", &lamp)
    };
    assert_color(with("none"), [6.0; 3]);
    assert_color(with("inverse"), [1.5; 3]);
    assert_color(with("inverse-square"), [0.375; 3]);
}

/// G16, S6: a light behind the surface, or in its plane, adds nothing; ambient always counts.
#[test]
fn lighting_is_one_sided() {
    for location in ["0 0 -5", "3 -2 -100", "7 0 -4"] {
        let lamp = format!("light {{ location {location}; emissivity 6 }}");
        assert_eq!(
            wall("ambient 2; diffuse 3", &lamp),
            Rgb::WHITE * 0.25,
            "{location}"
        );
    }
}

/// G16: normals are not turned to the viewer: a wall that faces away is seen, but not lit.
#[test]
fn a_plane_seen_from_behind_has_ambient_only() {
    let away = r#"
        material "wall" { ambient 2; diffuse 3 }
        plane { material "wall"; point 0 0 -4; normal 0 0 -1 }
        light { location 0 0 0; emissivity 6 }"#;
    assert_eq!(Stage::eye(away).pixel(), Rgb::WHITE * 0.25);
}

/// S6: a light exactly on the surface lights nothing there, and gives no infinite number.
#[test]
fn a_light_on_the_surface_is_nothing() {
    let lamp = "light { location 0 0 -4; emissivity 6 }";
    assert_eq!(wall("ambient 2; diffuse 3", lamp), Rgb::WHITE * 0.25);
}

/// S6: lights are not seen.
#[test]
fn lights_are_not_seen() {
    let lamps = "light { location 0 0 0; emissivity 6 }
        light { location 0 0 -2; emissivity 6 }";
    assert_eq!(Stage::eye(lamps).pixel(), Rgb::BLACK);
}

/// R28: without an image, `getamb` and `getdiff` are the material's values.
#[test]
fn the_default_is_the_material() {
    let scene = Stage::eye(
        r#"material "m" { ambient 1 2 3; diffuse 4 5 6 }
        plane { material "m"; point 0 0 -4; normal 0 0 1 }
        finite-plane { material "m"; point -1 -1 -4; normal 0 0 1; xdir 1 0 0; dimensions 2 2 }
        sphere { material "m"; center 0 0 -4; radius 1 }"#,
    )
    .scene();
    for surface in &scene.surfaces {
        let hit = hit(&**surface, [0.0; 3], [0.0, 0.0, -1.0]).unwrap();
        assert_eq!(surface.getamb(&hit), Rgb::new(1.0, 2.0, 3.0));
        assert_eq!(surface.getdiff(&hit), Rgb::new(4.0, 5.0, 6.0));
    }
}

/// R28, R29, R30, R37: the texel multiplies ambient and diffuse, channel by channel, and all else
/// is as on any plane.
#[test]
fn the_texel_multiplies_ambient_and_diffuse() {
    assert_color(textured("ambient 2", LAMP), [0.25, 0.1, 0.0]);
    assert_color(textured("diffuse 3", LAMP), [0.5625, 0.225, 0.0]);
    assert_color(textured("ambient 2; diffuse 3", LAMP), [0.8125, 0.325, 0.0]);
}

/// R31: the mirror is not multiplied by the texel. The tilted mirror shows a ceiling at path 11.
#[test]
fn the_mirror_is_not_textured() {
    let mirror = |point: &str| {
        format!(
            r#"material "mirror" {{ specular 0.5 }}
            material "ceiling" {{ ambient 11 }}
            texture "one" "one.ppm"
            texture-plane {{
                material "mirror"; {point}; normal 0 1 1; xdir 1 0 0; dimensions 2 4
                texture "one"
            }}
            plane {{ material "ceiling"; point 0 3 0; normal 0 -1 0 }}"#
        )
    };
    let stage = Stage::eye(&mirror("point -1 -1 -3")).image("one", &["."]);
    assert_color(stage.pixel(), [0.5; 3]);
}

/// R31: the glint is not multiplied by the texel either.
#[test]
fn the_glint_is_not_textured() {
    assert_color(textured("specular 0.5; shininess 9", LAMP), [0.375; 3]);
}

/// R32: a textured surface is darker; a raised ambient makes up for it.
#[test]
fn a_raised_ambient_makes_up_for_the_texel() {
    let (plain, dark) = (wall("ambient 2", ""), textured("ambient 2", ""));
    assert!(dark.g < plain.g);
    assert_color(textured("ambient 5", ""), [0.625, plain.g, 0.0]);
}

/// R33: diffuse alone carries the change of brightness with the distance from the lights.
#[test]
fn diffuse_carries_the_distance_from_the_lights() {
    let far = "light { location 0 0 4; emissivity 6 }";
    assert_eq!(textured("ambient 2", LAMP), textured("ambient 2", far));
    assert!(textured("ambient 2; diffuse 1", LAMP).r > textured("ambient 2; diffuse 1", far).r);
}

/// R21: half as much ambient again adds half of the ambient part, wherever it is seen.
#[test]
fn ambient_times_one_and_a_half() {
    let (before, after) = (
        textured("ambient 2; diffuse 3", LAMP),
        textured("ambient 3; diffuse 3", LAMP),
    );
    assert_color(after, [before.r + 0.125, before.g + 0.05, 0.0]);
}

/// S10: the glint is emissivity × specular × (h·n)^shininess, divided by the path but not by d.
///
/// With the light at 45° from the eye, h is at 22.5°, whose squared cosine is (1 + √½) / 2.
#[test]
fn the_glint_lies_halfway_between_eye_and_light() {
    let lamp = "light { location 8 0 4; emissivity 6 }";
    let expected = 6.0 * 0.5 * (1.0 + 0.5f64.sqrt()) / 2.0 / 8.0;
    assert_color(wall("specular 0.5; shininess 2", lamp), [expected; 3]);
    assert_color(wall("specular 0.5", lamp), [0.0; 3]);
    assert_color(wall("shininess 2", lamp), [0.0; 3]);
}
