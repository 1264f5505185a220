//! The tiled plane.

use super::tools::{Stage, assert_drawn, letters};

fn tiles(place: &str) -> String {
    let text =
        format!(r#"tiled-plane {{ material "red"; alternate "blue"; normal 0 0 1; {place} }}"#);
    letters(&Stage::grid(&text).film())
}

/// R3, S13: the plane's point is the lower-left corner of a tile of the main material, and the
/// tiles alternate evenly on all four sides of it.
#[test]
fn the_point_is_the_corner_of_a_main_tile() {
    assert_drawn(
        &tiles("point 11.5 6.5 0; xdir 1 0 0; dimensions 6 4"),
        "
        |RRRRRRBBBBBBRRRRRRBBBBBBRRRRRRBB|
        |BBBBBBRRRRRRBBBBBBRRRRRRBBBBBBRR|
        |BBBBBBRRRRRRBBBBBBRRRRRRBBBBBBRR|
        |BBBBBBRRRRRRBBBBBBRRRRRRBBBBBBRR|
        |BBBBBBRRRRRRBBBBBBRRRRRRBBBBBBRR|
        |RRRRRRBBBBBBRRRRRRBBBBBBRRRRRRBB|
        |RRRRRRBBBBBBRRRRRRBBBBBBRRRRRRBB|
        |RRRRRRBBBBBBRRRRRRBBBBBBRRRRRRBB|
        |RRRRRRBBBBBBRRRRRRBBBBBBRRRRRRBB|
        |BBBBBBRRRRRRBBBBBBRRRRRRBBBBBBRR|
        |BBBBBBRRRRRRBBBBBBRRRRRRBBBBBBRR|
        |BBBBBBRRRRRRBBBBBBRRRRRRBBBBBBRR|
        |BBBBBBRRRRRRBBBBBBRRRRRRBBBBBBRR|
        |RRRRRRBBBBBBRRRRRRBBBBBBRRRRRRBB|
        |RRRRRRBBBBBBRRRRRRBBBBBBRRRRRRBB|
        |RRRRRRBBBBBBRRRRRRBBBBBBRRRRRRBB|
        ",
    );
}

/// R3, S13: xdir turns the tiles.
#[test]
fn xdir_turns_the_tiles() {
    assert_drawn(
        &tiles("point 15.25 7.5 0; xdir 1 1 0; dimensions 5 5"),
        "
        |BRBBBBBBRBBBBBBRBBBBBBRBBBBBBRBB|
        |BRBBBBBBRBBBBBBRBBBBBBRBBBBBBRBB|
        |RRRBBBBRRRBBBBRRRBBBBRRRBBBBRRRB|
        |RRRRBBRRRRRBBRRRRRBBRRRRRBBRRRRR|
        |RRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRR|
        |RRRRBBRRRRRBBRRRRRBBRRRRRBBRRRRR|
        |RRRBBBBRRRBBBBRRRBBBBRRRBBBBRRRB|
        |BRBBBBBBRBBBBBBRBBBBBBRBBBBBBRBB|
        |BRBBBBBBRBBBBBBRBBBBBBRBBBBBBRBB|
        |RRRBBBBRRRBBBBRRRBBBBRRRBBBBRRRB|
        |RRRRBBRRRRRBBRRRRRBBRRRRRBBRRRRR|
        |RRRRRRRRRRRRRRRRRRRRRRRRRRRRRRRR|
        |RRRRBBRRRRRBBRRRRRBBRRRRRBBRRRRR|
        |RRRBBBBRRRBBBBRRRBBBBRRRBBBBRRRB|
        |BRBBBBBBRBBBBBBRBBBBBBRBBBBBBRBB|
        |BRBBBBBBRBBBBBBRBBBBBBRBBBBBBRBB|
        ",
    );
}

/// S13: counted as the course's programs did, the tiles start at the world's origin, 100,000 is
/// added before dividing, and an odd sum is the main material.
#[test]
fn the_courses_tiles_start_at_the_worlds_origin() {
    let drawn = tiles("point 11.5 6.5 0; xdir 1 0 0; dimensions 8 3; start \"course\"");
    assert_drawn(
        &drawn,
        "
        |BBBBBBBBRRRRRRRRBBBBBBBBRRRRRRRR|
        |BBBBBBBBRRRRRRRRBBBBBBBBRRRRRRRR|
        |RRRRRRRRBBBBBBBBRRRRRRRRBBBBBBBB|
        |RRRRRRRRBBBBBBBBRRRRRRRRBBBBBBBB|
        |RRRRRRRRBBBBBBBBRRRRRRRRBBBBBBBB|
        |BBBBBBBBRRRRRRRRBBBBBBBBRRRRRRRR|
        |BBBBBBBBRRRRRRRRBBBBBBBBRRRRRRRR|
        |BBBBBBBBRRRRRRRRBBBBBBBBRRRRRRRR|
        |RRRRRRRRBBBBBBBBRRRRRRRRBBBBBBBB|
        |RRRRRRRRBBBBBBBBRRRRRRRRBBBBBBBB|
        |RRRRRRRRBBBBBBBBRRRRRRRRBBBBBBBB|
        |BBBBBBBBRRRRRRRRBBBBBBBBRRRRRRRR|
        |BBBBBBBBRRRRRRRRBBBBBBBBRRRRRRRR|
        |BBBBBBBBRRRRRRRRBBBBBBBBRRRRRRRR|
        |RRRRRRRRBBBBBBBBRRRRRRRRBBBBBBBB|
        |RRRRRRRRBBBBBBBBRRRRRRRRBBBBBBBB|
        ",
    );
}

/// S13: only ambient and diffuse alternate.
#[test]
fn only_ambient_and_diffuse_alternate() {
    let text = |alternate: &str| {
        format!(
            r#"material "main" {{ ambient 1; specular 0.5 }}
            material "glass" {{ ambient 1; transparency 0.9; shininess 3 }}
            plane {{ material "blue"; point 0 0 -9; normal 0 0 1 }}
            tiled-plane {{
                material "main"; alternate "{alternate}"
                point 15.5 7.5 -1; normal 0 0 1; xdir 1 0 0; dimensions 4 4
            }}"#
        )
    };
    assert_eq!(
        Stage::grid(&text("glass")).film(),
        Stage::grid(&text("main")).film()
    );
}
