//! How large an image is on a plane.

use super::tools::{Stage, assert_color, assert_drawn, hit, letters};

/// R16, R34, R39: an image is stretched upright over the whole plane.
#[test]
fn clamp_stretches_the_image() {
    let stage = Stage::grid(
        r#"texture "letter" "letter.ppm"
        texture-plane {
            material "white"; point 1.5 1.5 0; normal 0 0 1; xdir 1 0 0; dimensions 27 12
            texture "letter" mode="clamp"
        }"#,
    );
    let letter = ["RRR", "R.G", "RR.", "B.Y"];
    assert_drawn(
        &letters(&stage.image("letter", &letter).film()),
        "
        |................................|
        |................................|
        |..RRRRRRRRRRRRRRRRRRRRRRRRRRR...|
        |..RRRRRRRRRRRRRRRRRRRRRRRRRRR...|
        |..RRRRRRRRRRRRRRRRRRRRRRRRRRR...|
        |..RRRRRRRRR.........GGGGGGGGG...|
        |..RRRRRRRRR.........GGGGGGGGG...|
        |..RRRRRRRRR.........GGGGGGGGG...|
        |..RRRRRRRRRRRRRRRRRR............|
        |..RRRRRRRRRRRRRRRRRR............|
        |..RRRRRRRRRRRRRRRRRR............|
        |..BBBBBBBBB.........YYYYYYYYY...|
        |..BBBBBBBBB.........YYYYYYYYY...|
        |..BBBBBBBBB.........YYYYYYYYY...|
        |................................|
        |................................|
        ",
    );
}

/// R17, R40: REPEAT tiles the image from the corner at its own scale.
#[test]
fn repeat_tiles_the_image() {
    let stage = Stage::grid(
        r#"texture "letter" "letter.ppm"
        texture-plane {
            material "white"; point 1.5 1.5 0; normal 0 0 1; xdir 1 0 0; dimensions 27 12
            texture "letter" mode="repeat" texel="2 1"
        }"#,
    );
    let letter = ["RRR", "R.G", "RR.", "B.Y"];
    assert_drawn(
        &letters(&stage.image("letter", &letter).film()),
        "
        |................................|
        |................................|
        |..RRRRRRRRRRRRRRRRRRRRRRRRRRR...|
        |..RR..GGRR..GGRR..GGRR..GGRR....|
        |..RRRR..RRRR..RRRR..RRRR..RRR...|
        |..BB..YYBB..YYBB..YYBB..YYBB....|
        |..RRRRRRRRRRRRRRRRRRRRRRRRRRR...|
        |..RR..GGRR..GGRR..GGRR..GGRR....|
        |..RRRR..RRRR..RRRR..RRRR..RRR...|
        |..BB..YYBB..YYBB..YYBB..YYBB....|
        |..RRRRRRRRRRRRRRRRRRRRRRRRRRR...|
        |..RR..GGRR..GGRR..GGRR..GGRR....|
        |..RRRR..RRRR..RRRR..RRRR..RRR...|
        |..BB..YYBB..YYBB..YYBB..YYBB....|
        |................................|
        |................................|
        ",
    );
}

/// R36, R40: the world size of a pixel can be set for each plane, along x and y.
#[test]
fn the_pixel_size_can_be_set() {
    let color = |texel: &str| {
        let text = format!(
            r#"texture "row" "row.ppm"
            texture-plane {{
                material "white"; point -5.25 -1 0; normal 0 0 1; xdir 1 0 0; dimensions 9 9
                texture "row" mode="repeat" texel={texel}
            }}"#
        );
        letters(&Stage::eye(&text).image("row", &["RG", "BW"]).film())
    };
    // The eye sees the offset (5.25, 1).
    assert_eq!(color("1"), "|g|");
    assert_eq!(color("5"), "|w|");
    assert_eq!(color("6"), "|b|");
    assert_eq!(color("\"6 1\""), "|r|");
}

/// R42: without it, a texel is as large as a pixel of the screen, so a picture twice as large
/// shows the image half as large.
#[test]
fn a_texel_is_a_pixel_of_the_screen() {
    let wall = r#"
        image 4 2
        camera { viewpoint 2 1 1000000; screen 4 2 }
        lighting { view-falloff "none" }
        texture "row" "row.ppm"
        texture-plane {
            material "white"; point 0 0 0; normal 0 0 1; xdir 1 0 0; dimensions 4 2
            texture "row" mode="repeat"
        }"#;
    let stage = || Stage::new(wall).image("row", &["RG", "BW"]);
    let texel = |stage: Stage, x, y| {
        let scene = stage.scene();
        let plane = &*scene.surfaces[0];
        hit(plane, [x, y, 1.0], [0.0, 0.0, -1.0]).unwrap().texel
    };
    // Offset 1.5 is the second pixel of four over four units, the fourth of eight.
    assert_color(texel(stage(), 1.25, 0.25), [1.0, 1.0, 1.0]);
    assert_color(texel(stage().sized(8, 4), 1.25, 0.25), [0.0, 0.0, 1.0]);
}

/// R15, R19: an image enlarged three times shows bricks three times as large in REPEAT, and the
/// same in CLAMP.
#[test]
fn an_enlarged_image_has_larger_bricks() {
    let large = ["RRRGGG", "RRRGGG", "RRRGGG", "BBBWWW", "BBBWWW", "BBBWWW"];
    let count = |mode: &str, rows: &[&str]| {
        let text = format!(
            r#"texture "brick" "brick.ppm"
            texture-plane {{
                material "white"; point -0.5 -0.5 0; normal 0 0 1; xdir 1 0 0; dimensions 32 16
                texture "brick" mode="{mode}"
            }}"#
        );
        let film = Stage::grid(&text).image("brick", rows).film();
        let lowest: Vec<_> = (0..32).map(|x| film.pixel(x, 15)).collect();
        1 + lowest.windows(2).filter(|pair| pair[0] != pair[1]).count()
    };
    let (small, large) = (["RG", "BW"], large);
    assert!(count("repeat", &small) > 2 * count("repeat", &large));
    assert_eq!(count("clamp", &small), 2);
    assert_eq!(count("clamp", &large), 2);
}
