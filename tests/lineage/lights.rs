//! Lights that shine into a part of space only.

use heliodon::math::Rgb;

use super::tools::{Stage, assert_color, assert_drawn, letters};

/// A white wall with these lights; they may stand in front of the screen.
fn wall(lights: &str) -> Stage {
    Stage::grid(&format!(
        r#"{lights}
        plane {{ material "matte"; point 0 0 0; normal 0 0 1 }}"#
    ))
}

/// S8: a spotlight has a hard edge: it lights all that is inside of its cone, and the cone of 45°
/// from height 6 stands on a circle of radius 6.
#[test]
fn a_spotlight_lights_a_disk() {
    let light = "spotlight { location 15.5 7.5 6; emissivity 4; point 15.5 7.5 0; theta 45 }";
    let film = wall(light).film();
    assert_drawn(
        &letters(&film),
        "
        |................................|
        |................................|
        |..............WWWW..............|
        |............WWWWWWWW............|
        |...........WWWWWWWWWW...........|
        |...........WWWWWWWWWW...........|
        |..........WWWWWWWWWWWW..........|
        |..........WWWWWWWWWWWW..........|
        |..........WWWWWWWWWWWW..........|
        |..........WWWWWWWWWWWW..........|
        |...........WWWWWWWWWW...........|
        |...........WWWWWWWWWW...........|
        |............WWWWWWWW............|
        |..............WWWW..............|
        |................................|
        |................................|
        ",
    );
    for (index, pixel) in film.pixels().iter().enumerate() {
        let (x, y) = ((index % 32) as f64 - 15.5, 7.5 - (index / 32) as f64);
        let inside = x * x + y * y < 36.0;
        let distance = (x * x + y * y + 36.0).sqrt();
        let expected = if inside { 4.0 * 6.0 / distance } else { 0.0 };
        assert!(
            (pixel.g - expected).abs() < 1e-9,
            "{x} {y}: {} not {expected}",
            pixel.g
        );
    }
}

/// S8: theta is the half angle in degrees, and the axis points at `point`, however far it is.
#[test]
fn a_spotlight_is_aimed() {
    let lit = |location: &str, point: &str, theta: &str| {
        let text = format!(
            r#"spotlight {{ location {location}; emissivity 1; point {point}; theta {theta} }}
            material "wall" {{ diffuse 1 }}
            plane {{ material "wall"; point 0 0 -4; normal 0 0 1 }}"#
        );
        Stage::eye(&text).pixel() != Rgb::BLACK
    };
    // The eye sees (0, 0, −4); from the light, that is 45° away from straight ahead.
    assert!(lit("4 0 0", "4 0 -1", "45.001") && !lit("4 0 0", "4 0 -1", "44.999"));
    assert!(lit("4 0 0", "4 0 -1000", "45.001") && !lit("4 0 0", "4 0 -1000", "44.999"));
    assert!(lit("4 0 0", "0 0 -4", "0.01"), "aimed at it");
    assert!(lit("4 0 0", "4 4 0", "90.001") && !lit("4 0 0", "4 4 0", "89.999"));
}

/// S8: inside of its cone, a spotlight is a light.
#[test]
fn inside_the_cone_a_spotlight_is_a_light() {
    let place = "location 3 0 0; emissivity 6 5 4";
    let wall = r#"material "wall" { ambient 1; diffuse 2 }
        plane { material "wall"; point 0 0 -4; normal 0 0 1 }"#;
    let light = Stage::eye(&format!("{wall}\n light {{ {place} }}"));
    let spot = Stage::eye(&format!(
        "{wall}\n spotlight {{ {place}; point 0 0 -4; theta 5 }}"
    ));
    assert_eq!(light.pixel(), spot.pixel());
}

const LETTER: [&str; 4] = ["RRRR", "R..G", "RRR.", "BW.Y"];

fn projector(slide: &str) -> String {
    let text = format!(
        r#"texture "letter" "letter.ppm"
        projector {{ location 15.5 7.5 12; emissivity 2; {slide} }}"#
    );
    letters(&wall(&text).image("letter", &LETTER).film())
}

/// S9: a slide that faces the viewer is thrown upright onto the wall, twice as large at twice the
/// distance; beside it nothing is lit, and the slide itself is not seen.
#[test]
fn a_slide_is_projected_upright() {
    let slide = r#"
        point 9.5 4.5 6; normal 0 0 1; xdir 1 0 0; dimensions 12 6; texture "letter""#;
    assert_drawn(
        &projector(slide),
        "
        |................................|
        |................................|
        |....RRRRRRRRRRRRRRRRRRRRRRRR....|
        |....RRRRRRRRRRRRRRRRRRRRRRRR....|
        |....RRRRRRRRRRRRRRRRRRRRRRRR....|
        |....RRRRRR............GGGGGG....|
        |....RRRRRR............GGGGGG....|
        |....RRRRRR............GGGGGG....|
        |....RRRRRRRRRRRRRRRRRR..........|
        |....RRRRRRRRRRRRRRRRRR..........|
        |....RRRRRRRRRRRRRRRRRR..........|
        |....BBBBBBWWWWWW......YYYYYY....|
        |....BBBBBBWWWWWW......YYYYYY....|
        |....BBBBBBWWWWWW......YYYYYY....|
        |................................|
        |................................|
        ",
    );
}

/// S9: turned to face the wall, with xdir to the left, it is mirrored.
#[test]
fn a_turned_slide_is_mirrored() {
    let slide = r#"
        point 21.5 4.5 6; normal 0 0 -1; xdir -1 0 0; dimensions 12 6; texture "letter""#;
    assert_drawn(
        &projector(slide),
        "
        |................................|
        |................................|
        |....RRRRRRRRRRRRRRRRRRRRRRRR....|
        |....RRRRRRRRRRRRRRRRRRRRRRRR....|
        |....RRRRRRRRRRRRRRRRRRRRRRRR....|
        |....GGGGGG............RRRRRR....|
        |....GGGGGG............RRRRRR....|
        |....GGGGGG............RRRRRR....|
        |..........RRRRRRRRRRRRRRRRRR....|
        |..........RRRRRRRRRRRRRRRRRR....|
        |..........RRRRRRRRRRRRRRRRRR....|
        |....YYYYYY......WWWWWWBBBBBB....|
        |....YYYYYY......WWWWWWBBBBBB....|
        |....YYYYYY......WWWWWWBBBBBB....|
        |................................|
        |................................|
        ",
    );
}

/// S9: a slide can be tiled.
#[test]
fn a_slide_can_be_tiled() {
    let slide = r#"
        point 9.5 4.5 6; normal 0 0 1; xdir 1 0 0; dimensions 12 6
        texture "letter" mode="repeat" texel="1.5 1""#;
    assert_drawn(
        &projector(slide),
        "
        |................................|
        |................................|
        |....RRRRRRRRR...RRRRRRRRR.......|
        |....RRRRRRRRR...RRRRRRRRR.......|
        |....BBBWWW...YYYBBBWWW...YYY....|
        |....BBBWWW...YYYBBBWWW...YYY....|
        |....RRRRRRRRRRRRRRRRRRRRRRRR....|
        |....RRRRRRRRRRRRRRRRRRRRRRRR....|
        |....RRR......GGGRRR......GGG....|
        |....RRR......GGGRRR......GGG....|
        |....RRRRRRRRR...RRRRRRRRR.......|
        |....RRRRRRRRR...RRRRRRRRR.......|
        |....BBBWWW...YYYBBBWWW...YYY....|
        |....BBBWWW...YYYBBBWWW...YYY....|
        |................................|
        |................................|
        ",
    );
}

/// S9: the texel multiplies the emissivity; distance and angle are those of the location.
#[test]
fn the_slide_multiplies_the_emissivity() {
    let text = r#"
        material "wall" { ambient 2; diffuse 3 }
        texture "one" "one.ppm"
        projector {
            location 3 0 0; emissivity 6; texture "one"
            point -9 -9 -1; normal 0 0 1; xdir 1 0 0; dimensions 18 18
        }
        plane { material "wall"; point 0 0 -4; normal 0 0 1 }"#;
    let pixel = Stage::eye(text)
        .file("one.ppm", b"P6 1 1 255 \xff\x66\x00")
        .pixel();
    assert_color(pixel, [0.61, 0.25 + 0.4 * 0.36, 0.25]);
}

/// S9: what the light does not cross the slide to reach is dark: beside it, and behind the lamp.
#[test]
fn outside_of_the_beam_a_projector_lights_nothing() {
    let pixel = |z: &str, corner: &str| {
        let text = format!(
            r#"material "wall" {{ diffuse 3 }}
            texture "one" "one.ppm"
            projector {{
                location 0 0 0; emissivity 6; texture "one"
                point {corner} {z}; normal 0 0 1; xdir 1 0 0; dimensions 2 2
            }}
            plane {{ material "wall"; point 0 0 -4; normal 0 0 1 }}"#
        );
        Stage::eye(&text).image("one", &["W"]).pixel()
    };
    assert!(pixel("-1", "-1 -1") != Rgb::BLACK);
    assert_eq!(pixel("-1", "1 1"), Rgb::BLACK, "beside the slide");
    assert_eq!(
        pixel("1", "-1 -1"),
        Rgb::BLACK,
        "the slide is behind the lamp"
    );
}
