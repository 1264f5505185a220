//! Triangles and procedural planes.

use super::tools::{Stage, assert_color, assert_drawn, letters, shades};

const SAIL: &str = "vertex1 4.5 2.5 -3; vertex2 27.5 2.5 -3; vertex3 12.5 13.5 -3";

/// S12: the outline of a triangle.
#[test]
fn a_triangle_has_three_sides() {
    let text = format!("triangle {{ material \"red\"; {SAIL} }}");
    assert_drawn(
        &letters(&Stage::grid(&text).film()),
        "
        |................................|
        |................................|
        |.............R..................|
        |............RRR.................|
        |...........RRRRR................|
        |..........RRRRRRRR..............|
        |..........RRRRRRRRR.............|
        |.........RRRRRRRRRRR............|
        |........RRRRRRRRRRRRRR..........|
        |........RRRRRRRRRRRRRRR.........|
        |.......RRRRRRRRRRRRRRRRRR.......|
        |......RRRRRRRRRRRRRRRRRRRR......|
        |.....RRRRRRRRRRRRRRRRRRRRRR.....|
        |................................|
        |................................|
        |................................|
        ",
    );
}

/// G16, S12: a triangle is lit where its vertices run counter-clockwise, and seen from both sides.
#[test]
fn a_triangle_is_lit_on_its_counter_clockwise_side() {
    let pixel = |vertices: &str| {
        let text = format!(
            r#"material "sail" {{ ambient 2; diffuse 3 }}
            triangle {{ material "sail"; {vertices} }}
            light {{ location 0 0 0; emissivity 6 }}"#
        );
        Stage::eye(&text).pixel()
    };
    assert_color(
        pixel("vertex1 -1 -1 -4; vertex2 1 -1 -4; vertex3 0 3 -4"),
        [0.8125; 3],
    );
    assert_color(
        pixel("vertex1 -1 -1 -4; vertex2 0 3 -4; vertex3 1 -1 -4"),
        [0.25; 3],
    );
}

/// S12: two triangles that share an edge leave no gap between them.
#[test]
fn two_triangles_leave_no_gap() {
    let text = r#"
        triangle { material "red"; vertex1 -9 -9 -3; vertex2 40 -8 -3; vertex3 -3 30 -3 }
        triangle { material "blue"; vertex1 -3 30 -3; vertex2 40 -8 -3; vertex3 50 30 -3 }"#;
    let drawn = letters(&Stage::grid(text).film());
    assert!(!drawn.contains('.'), "{drawn}");
    assert!(drawn.contains('R') && drawn.contains('B'), "{drawn}");
}

/// S14: stripes take red or blue away, by trunc(1000 + xy²/100 + xy/100).
#[test]
fn stripes() {
    let text = r#"
        procedural-plane {
            material "white"; point 15.5 7.5 -3; normal 0 0 1; shader "stripes"
        }"#;
    assert_drawn(
        &letters(&Stage::grid(text).film()),
        "
        |YYCYYCCYCCYCCYCCYYCYYCYYCYYCCYCC|
        |YYCCYYCCYYCCYYCCYYCCYYCCYYCCYYCC|
        |YYCCCYYYCCYYYCCCYYYCCCYYCCCYYYCC|
        |YYYYCCCCYYYYCCCCYYYYCCCCYYYYCCCC|
        |CCCYYYYYYYCCCCCCYYYYYYCCCCCCCYYY|
        |YYYYYCCCCCCCCCCCYYYYYYYYYYYCCCCC|
        |CCCCCCCCCCCCCCCCYYYYYYYYYYYYYYYY|
        |CCCCCCCCCCCCCCCCYYYYYYYYYYYYYYYY|
        |YYYYYYYYYYYYYYYYCCCCCCCCCCCCCCCC|
        |CCCCCCCCCCCCCCCCYYYYYYYYYYYYYYYY|
        |CCCCCCCCCCCCCCCCYYYYYYYYYYYYYYYY|
        |YYYYYCCCCCCCCCCCYYYYYYYYYYYCCCCC|
        |CCCYYYYYYYCCCCCCYYYYYYCCCCCCCYYY|
        |YYYYCCCCYYYYCCCCYYYYCCCCYYYYCCCC|
        |YYCCCYYYCCYYYCCCYYYCCCYYCCCYYYCC|
        |YYCCYYCCYYCCYYCCYYCCYYCCYYCCYYCC|
        ",
    );
}

/// S14: the colour wheel multiplies the channels by 1 + cos(2a), a third of a turn apart; the
/// picture shows the red one.
#[test]
fn the_colour_wheel() {
    let text = r#"
        material "half" { ambient 0.5 0 0 }
        procedural-plane {
            material "half"; point 15.5 7.5 -3; normal 0 0 1; shader "color-wheel"
        }"#;
    assert_drawn(
        &shades(&Stage::grid(text).film()),
        "
        |%####**+==-:..     .:-=++**####%|
        |%%%###**+==-:.    .:-=++**###%%%|
        |%%%%%###*+==:.    .:=++*###%%%%%|
        |@@%%%%%##*+=-:.   :-++*##%%%%%@@|
        |@@@@@%%%%##*=-.  .-+*##%%%@@@@@@|
        |@@@@@@@@%%%#*=:  :+*#%%@@@@@@@@@|
        |@@@@@@@@@@@%%#=. +#%%@@@@@@@@@@@|
        |@@@@@@@@@@@@@@%=+@@@@@@@@@@@@@@@|
        |@@@@@@@@@@@@@@%=+@@@@@@@@@@@@@@@|
        |@@@@@@@@@@@%%#=. +#%%@@@@@@@@@@@|
        |@@@@@@@@%%%#*=:  :+*#%%@@@@@@@@@|
        |@@@@@%%%%##*=-.  .-+*##%%%@@@@@@|
        |@@%%%%%##*+=-:.   :-++*##%%%%%@@|
        |%%%%%###*+==:.    .:=++*###%%%%%|
        |%%%###**+==-:.    .:-=++**###%%%|
        |%####**+==-:..     .:-=++**####%|
        ",
    );
}

/// S14: a formula changes the ambient part alone.
#[test]
fn formulas_change_the_ambient_part_alone() {
    let text = r#"
        material "m" { ambient 8; diffuse 8 }
        procedural-plane { material "m"; point 0 0 -4; normal 0 0 1; shader "stripes" }
        light { location 0 0 0; emissivity 4 }"#;
    assert_color(Stage::eye(text).pixel(), [2.0, 2.0, 1.0]);
}
