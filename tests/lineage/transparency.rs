//! Transparency, without refraction.

use super::tools::{Stage, assert_color, assert_drawn, letters};

/// S11: own colour × (1 − t) + t × filter × what is behind; the filter is diffuse, its largest
/// channel made 1.
#[test]
fn a_pane_is_seen_and_seen_through() {
    let text = r#"
        material "pane" { ambient 6; diffuse 2 1 0; transparency 0.25 }
        material "wall" { ambient 8 }
        plane { material "pane"; point 0 0 -2; normal 0 0 1 }
        plane { material "wall"; point 0 0 -4; normal 0 0 1 }"#;
    assert_color(Stage::eye(text).pixel(), [1.0, 0.875, 0.75]);
}

/// S11: a pane without diffuse is clear, and panes behind each other multiply.
#[test]
fn panes_multiply() {
    let text = r#"
        material "clear" { transparency 0.5 }
        material "glass" { diffuse 3 0 0; transparency 0.5 }
        material "wall" { ambient 8 }
        plane { material "clear"; point 0 0 -2; normal 0 0 1 }
        plane { material "glass"; point 0 0 -3; normal 0 0 1 }
        plane { material "wall"; point 0 0 -4; normal 0 0 1 }"#;
    assert_color(Stage::eye(text).pixel(), [0.25, 0.0, 0.0]);
}

/// A wall with a light at (0, 3, 0), and panes between them that the eye does not look through.
fn shaded_by(panes: &str) -> heliodon::math::Rgb {
    let text = format!(
        r#"material "wall" {{ ambient 8; diffuse 8 }}
        material "yellowish" {{ diffuse 2 2 1; transparency 0.5 }}
        material "clear" {{ transparency 0.5 }}
        plane {{ material "wall"; point 0 0 -4; normal 0 0 1 }}
        light {{ location 0 3 0; emissivity 5 }}
        {panes}"#
    );
    Stage::eye(&text).pixel()
}

/// S11: light on its way is tinted by t × filter, for each pane once.
#[test]
fn panes_tint_shadows() {
    let pane = |material: &str, y: f64| {
        format!("plane {{ material \"{material}\"; point 0 {y} 0; normal 0 1 0 }}\n")
    };
    assert_color(shaded_by(&pane("yellowish", 1.0)), [1.4, 1.4, 1.2]);
    let two = [pane("yellowish", 1.0), pane("clear", 2.0)].concat();
    assert_color(shaded_by(&two), [1.2, 1.2, 1.1]);
    let blocked = [pane("yellowish", 1.0), pane("red", 2.0)].concat();
    assert_color(shaded_by(&blocked), [1.0; 3]);
}

/// P4, S11: of panes that coincide the first in the file counts, in shadows as for the eye.
#[test]
fn of_coincident_panes_the_first_tints() {
    let pane = |material: &str| {
        format!("plane {{ material \"{material}\"; point 0 1 0; normal 0 1 0 }}\n")
    };
    let yellowish = shaded_by(&pane("yellowish"));
    for second in ["clear", "yellowish", "red"] {
        let both = [pane("yellowish"), pane(second)].concat();
        assert_eq!(shaded_by(&both), yellowish, "{second}");
    }
}

/// P4, S11: round things that coincide are one sheet; a ray that leaves one does not meet the other.
#[test]
fn of_coincident_balls_the_first_is_seen() {
    let scene = |second: &str| {
        let text = format!(
            r#"
            material "glass" {{ ambient 3; diffuse 1 0 0; transparency 0.5 }}
            material "wall" {{ ambient 8 }}
            light {{ location 3 5 4; emissivity 3 }}
            sphere {{ material "glass"; center 4.1 3.2 -2.3; radius 1.7 }}
            {second}
            plane {{ material "wall"; point 0 0 -9; normal 0 0 1 }}"#
        );
        Stage::grid(&text).film()
    };
    let alone = scene("");
    let twin = "material \"glass\"; center 4.1 3.2 -2.3; radius 1.7";
    assert_eq!(scene(&format!("sphere {{ {twin} }}")), alone);
    assert_eq!(
        scene(&format!("ellipsoid {{ {twin}; scale 1 1 1 }}")),
        alone
    );
}

/// S11: a ball filters once, not where it is entered and again where it is left.
#[test]
fn a_ball_filters_once() {
    let ball = r#"sphere { material "yellowish"; center 0 1.5 -2; radius 0.5 }"#;
    assert_color(shaded_by(ball), [1.4, 1.4, 1.2]);
    let seen = r#"
        material "clear" { transparency 0.5 }
        material "wall" { ambient 8 }
        sphere { material "clear"; center 0 0 -2; radius 1 }
        plane { material "wall"; point 0 0 -4; normal 0 0 1 }"#;
    assert_color(Stage::eye(seen).pixel(), [0.5; 3]);
}

/// S11, S7: a window in front of a wall, and its coloured shadow beside it.
#[test]
fn a_window_throws_a_coloured_shadow() {
    let text = r#"
        material "wall" { ambient 0.1; diffuse 1 }
        material "glass" { diffuse 0 1 0; transparency 0.9 }
        light { location 4.5 7.5 0; emissivity 2 }
        plane { material "wall"; point 0 0 -12; normal 0 0 1 }
        finite-plane {
            material "glass"; point 5.5 5.5 -6; normal 0 0 -1; xdir 0 1 0; dimensions 4 5
        }"#;
    assert_drawn(
        &letters(&Stage::grid(text).film()),
        "
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWGGGGGGGGGGWWWWWWWWWWWWWWW|
        |WWWWWWWGGGGGGGGGGWWWWWWWWWWWWWWW|
        |WWWWWWGGGGGGGGGGGWWWWWWWWWWWWWWW|
        |WWWWWWGGGGGGGGGGGWWWWWWWWWWWWWWW|
        |WWWWWWGGGGGGGGGGGWWWWWWWWWWWWWWW|
        |WWWWWWGGGGGGGGGGGWWWWWWWWWWWWWWW|
        |WWWWWWWGGGGGGGGGGWWWWWWWWWWWWWWW|
        |WWWWWWWGGGGGGGGGGWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        |WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW|
        ",
    );
}

/// S5, S11: specular is added whole, not scaled by 1 − t.
#[test]
fn a_mirror_of_glass_is_a_whole_mirror() {
    let text = r#"
        material "glass" { specular 0.5; transparency 0.5 }
        material "ceiling" { ambient 11 }
        material "wall" { ambient 16 }
        plane { material "glass"; point 0 0 -4; normal 0 1 1 }
        plane { material "ceiling"; point 0 3 0; normal 0 -1 0 }
        plane { material "wall"; point 0 0 -12; normal 0 0 1 }"#;
    assert_color(Stage::eye(text).pixel(), [0.5 + 0.5; 3]);
}
