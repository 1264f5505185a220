//! Shadows.

use heliodon::math::Rgb;

use super::tools::{Stage, assert_color, assert_drawn, letters};

/// A white wall in z = −12, a light at (4.5, 7.5, 0), and what stands between them.
fn wall(between: &str) -> String {
    let text = format!(
        r#"light {{ location 4.5 7.5 0; emissivity 2 }}
        plane {{ material "matte"; point 0 0 -12; normal 0 0 1 }}
        {between}"#
    );
    letters(&Stage::grid(&text).film())
}

/// S7: a square in half the distance from the light throws a shadow of twice its size.
#[test]
fn a_square_throws_a_square_shadow() {
    let square = r#"finite-plane {
        material "green"; point 5.5 5.5 -6; normal 0 0 1; xdir 1 0 0; dimensions 5 4
    }"#;
    assert_drawn(
        &wall(square),
        "
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWW..........WWWWWWWWWWWWWWW|
        |WWWWWWW..........WWWWWWWWWWWWWWW|
        |WWWWWWGGGGG......WWWWWWWWWWWWWWW|
        |WWWWWWGGGGG......WWWWWWWWWWWWWWW|
        |WWWWWWGGGGG......WWWWWWWWWWWWWWW|
        |WWWWWWGGGGG......WWWWWWWWWWWWWWW|
        |WWWWWWW..........WWWWWWWWWWWWWWW|
        |WWWWWWW..........WWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        ",
    );
}

/// S7: the shadow of a ball, seen beside it.
#[test]
fn a_ball_throws_a_round_shadow() {
    let ball = r#"sphere { material "green"; center 8.5 7.5 -6; radius 2 }"#;
    assert_drawn(
        &wall(ball),
        "
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWW......WWWWWWWWWWWWWWW|
        |WWWWWWWWWW........WWWWWWWWWWWWWW|
        |WWWWWWWWGG.........WWWWWWWWWWWWW|
        |WWWWWWWGGGG........WWWWWWWWWWWWW|
        |WWWWWWWGGGG........WWWWWWWWWWWWW|
        |WWWWWWWWGG.........WWWWWWWWWWWWW|
        |WWWWWWWWWW........WWWWWWWWWWWWWW|
        |WWWWWWWWWWW......WWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        ",
    );
}

/// S7: the shadow of a triangle, and of a saucer.
#[test]
fn triangles_and_saucers_throw_shadows() {
    let both = r#"
        triangle { material "green"; vertex1 6.5 8.5 -6; vertex2 11.5 8.5 -6; vertex3 6.5 11 -6 }
        ellipsoid { material "red"; center 9 4.5 -6; radius 1; scale 3 1 1 }"#;
    assert_drawn(
        &wall(both),
        "
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWW.WWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWW...WWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWW.....WWWWWWWWWWWWWWWWWW|
        |WWWWWWWWW.......WWWWWWWWWWWWWWWW|
        |WWWWWWWGG.........WWWWWWWWWWWWWW|
        |WWWWWWWGGGGWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWRRRRRWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWRRRRRWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWW........WWWWWWWWWWWWWW|
        |WWWWWWWW............WWWWWWWWWWWW|
        |WWWWWWWW.............WWWWWWWWWWW|
        |WWWWWWWWWW..........WWWWWWWWWWWW|
        ",
    );
}

/// What the eye sees of a wall with a light at (0, 3, 0) and something more.
fn seen(wall: &str, more: &str) -> Rgb {
    let text = format!(
        r#"material "wall" {{ ambient 8; diffuse 8 }}
        plane {{ material "wall"; point 0 0 -4; normal 0 0 1; {wall} }}
        light {{ location 0 3 0; emissivity 5 }}
        {more}"#
    );
    Stage::eye(&text).pixel()
}

const LIT: [f64; 3] = [1.8; 3];
const DARK: [f64; 3] = [1.0; 3];
/// In the middle of the way from the wall to the light, which the eye does not look through.
const BALL: &str = "sphere { material \"red\"; center 0 1.5 -2; radius 0.5 }";

/// S7: in shadow there is the ambient part alone.
#[test]
fn a_shadow_leaves_the_ambient_part() {
    assert_color(seen("", ""), LIT);
    assert_color(seen("", BALL), DARK);
}

/// S7: only what is nearer than the light, on the lit side, casts a shadow.
#[test]
fn only_what_is_between_casts_a_shadow() {
    let above = r#"sphere { material "red"; center 0 4.2 0; radius 1 }"#;
    let beyond = r#"plane { material "red"; point 0 6 0; normal 0 1 0 }"#;
    let behind = r#"plane { material "red"; point 0 0 -5; normal 0 0 1 }"#;
    let in_it = r#"finite-plane {
        material "red"; point 1 1 -4; normal 0 0 1; xdir 1 0 0; dimensions 9 9 }"#;
    let through_the_light = r#"plane { material "red"; point 0 3 0; normal 0 1 0 }"#;
    for other in [above, beyond, behind, in_it, through_the_light] {
        assert_color(seen("", other), LIT);
    }
    let ceiling = r#"plane { material "red"; point 0 2.9 0; normal 0 1 0 }"#;
    assert_color(seen("", ceiling), DARK);
}

/// R26, G13: `shadows receive=#false` switches the light-visibility test off for one surface.
#[test]
fn a_surface_may_receive_no_shadows() {
    assert_color(seen("shadows receive=#false", BALL), LIT);
    let facing_away = "light { location 0 0 -9; emissivity 5 }";
    assert_color(seen("shadows receive=#false", facing_away), LIT);
}

/// G13: `shadows cast=#false` takes one surface out of all shadow tests.
#[test]
fn a_surface_may_cast_no_shadow() {
    let ball = BALL.replace("radius 0.5", "radius 0.5; shadows cast=#false");
    assert_color(seen("", &ball), LIT);
    assert_color(seen("", &[&ball, "\n", BALL].concat()), DARK);
}

/// R25, R26: saucers throw shadows onto the photograph behind them, which are wrong, since it is
/// not deep; switched off for the backdrop alone, the picture has none, and the saucers still
/// shade each other.
#[test]
fn a_backdrop_needs_no_shadows() {
    let drawn = |shadows: &str| {
        let text = format!(
            r#"texture "sky" "sky.ppm"
            material "sky" {{ ambient 0.125; diffuse 1 }}
            material "hull" {{ ambient 0 0.25 0; diffuse 0 1 0 }}
            texture-plane {{
                material "sky"; point -0.5 -0.5 -12; normal 0 0 1; xdir 1 0 0; dimensions 32 16
                texture "sky"; {shadows}
            }}
            ellipsoid {{ material "hull"; center 7.5 9.5 -5; radius 1; scale 4 1.5 1.5 }}
            ellipsoid {{ material "hull"; center 18.5 6 -8; radius 1; scale 6 2 2 }}
            light {{ location -8 13 2; emissivity 2 }}"#
        );
        letters(&Stage::grid(&text).image("sky", &["B", "W"]).film())
    };
    assert_drawn(
        &drawn(""),
        "
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBGGGGGGggBBBBBBBBBBBBBBBBBBBB|
        |BBBBGGGGGgggBBBBBBBbbbbbbBBBBBBB|
        |BBBBBBBBBBBBBBBbbbbbbbbbbbbbbbBB|
        |WWWWWWWWWWWWWWgggGGGGGggwwwwwwww|
        |WWWWWWWWWWWWWGGGGGGGGggggwwwwwww|
        |WWWWWWWWWWWWWWGGGGGgggggwwwwwwww|
        |WWWWWWWWWWWWWWWWWWwwwwwwwwwwwwww|
        |WWWWWWWWWWWWWWWWWWWWwwwwwwwwwwww|
        |WWWWWWWWWWWWWWWWWWWWWWwwwwwwwwww|
        |WWWWWWWWWWWWWWWWWWWWWWWWwwwwwwww|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWwwww|
        ",
    );
    assert_drawn(
        &drawn("shadows receive=#false"),
        "
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBGGGGGGggBBBBBBBBBBBBBBBBBBBB|
        |BBBBGGGGGgggBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |WWWWWWWWWWWWWWgggGGGGGggWWWWWWWW|
        |WWWWWWWWWWWWWGGGGGGGGggggWWWWWWW|
        |WWWWWWWWWWWWWWGGGGGgggggWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        ",
    );
}

/// S7: lights in front of the screen light what lies behind it.
#[test]
fn lights_in_front_of_the_screen_shine() {
    let text = r#"
        material "wall" { diffuse 8 }
        plane { material "wall"; point 0 0 -4; normal 0 0 1 }
        light { location 0 0 8; emissivity 3 }"#;
    assert_color(Stage::eye(text).pixel(), [0.25; 3]);
}
