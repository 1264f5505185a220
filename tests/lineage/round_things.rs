//! Spheres, ellipsoids, and images around them.

use glam::DVec3;

use super::tools::{Stage, assert_color, assert_drawn, hit, letters, shades};

/// S12: the outline of a sphere is a circle.
#[test]
fn a_sphere_is_round() {
    let text = r#"sphere { material "red"; center 15.5 7.5 -9; radius 6.4 }"#;
    assert_drawn(
        &letters(&Stage::grid(text).film()),
        "
        |................................|
        |................................|
        |.............RRRRRR.............|
        |...........RRRRRRRRRR...........|
        |...........RRRRRRRRRR...........|
        |..........RRRRRRRRRRRR..........|
        |..........RRRRRRRRRRRR..........|
        |..........RRRRRRRRRRRR..........|
        |..........RRRRRRRRRRRR..........|
        |..........RRRRRRRRRRRR..........|
        |..........RRRRRRRRRRRR..........|
        |...........RRRRRRRRRR...........|
        |...........RRRRRRRRRR...........|
        |.............RRRRRR.............|
        |................................|
        |................................|
        ",
    );
}

/// R24, S12: a flattened ellipsoid is a saucer; the half axes are radius × scale.
#[test]
fn an_ellipsoid_is_a_saucer() {
    let text = r#"ellipsoid { material "red"; center 15.5 7.5 -9; radius 2; scale 7 1.7 1 }"#;
    assert_drawn(
        &letters(&Stage::grid(text).film()),
        "
        |................................|
        |................................|
        |................................|
        |................................|
        |................................|
        |.......RRRRRRRRRRRRRRRRRR.......|
        |...RRRRRRRRRRRRRRRRRRRRRRRRRR...|
        |..RRRRRRRRRRRRRRRRRRRRRRRRRRRR..|
        |..RRRRRRRRRRRRRRRRRRRRRRRRRRRR..|
        |...RRRRRRRRRRRRRRRRRRRRRRRRRR...|
        |.......RRRRRRRRRRRRRRRRRR.......|
        |................................|
        |................................|
        |................................|
        |................................|
        |................................|
        ",
    );
}

/// S6, S12: a ball lit from the upper left is brightest where its normal points to the light.
#[test]
fn a_ball_is_shaded() {
    let text = r#"
        sphere { material "matte"; center 15.5 7.5 -9; radius 7 }
        light { location -984.5 1007.5 991; emissivity 1 }"#;
    assert_drawn(
        &shades(&Stage::grid(text).film()),
        "
        |                                |
        |             #%##+-             |
        |            @@@%#*+-            |
        |           @@@@%#*+=:           |
        |          @@@@%%#*+=:           |
        |         #@@@@%##*=-:           |
        |         %@@%%##*+=-.           |
        |         #%%%##*+=-:.           |
        |         #####*+=-:.            |
        |         +****+=-:.             |
        |         -+++==-:.              |
        |          -==--:.               |
        |           :::..                |
        |                                |
        |                                |
        |                                |
        ",
    );
}

/// S12: the nearer of the two places is hit; a touch is a miss; from inside nothing is hit.
#[test]
fn the_near_side_is_hit() {
    let text = r#"
        sphere { material "red"; center 0 0 -5; radius 1 }
        ellipsoid { material "red"; center 0 0 -5; radius 0.5; scale 2 2 2 }"#;
    let scene = Stage::eye(text).scene();
    for ball in &scene.surfaces {
        let t = |x, z| hit(&**ball, [x, 0.0, z], [0.0, 0.0, -1.0]).map(|hit| hit.t);
        assert_eq!(t(0.0, 0.0), Some(4.0));
        assert_eq!(t(1.0, 0.0), None, "a touch");
        assert_eq!(t(0.0, -5.0), None, "from the centre");
        assert_eq!(t(0.0, -7.0), None, "leading away");
        let found = hit(&**ball, [0.0; 3], [0.0, 0.0, -1.0]).unwrap();
        assert_eq!(found.normal, DVec3::Z);
        assert_eq!(found.point.world(), DVec3::new(0.0, 0.0, -4.0));
    }
}

/// S12: an ellipsoid's normal is across its surface, not along the line from its centre.
#[test]
fn the_normal_of_an_ellipsoid_is_across_its_surface() {
    let text = r#"ellipsoid { material "red"; center 0 0 -8; radius 1; scale 4 3 2 }"#;
    let scene = Stage::eye(text).scene();
    let found = hit(&*scene.surfaces[0], [2.4, 0.0, 0.0], [0.0, 0.0, -1.0]).unwrap();
    // x = 2.4 = 4 × 0.6, so z = −8 + 2 × 0.8, and the normal is along (0.6 / 4, 0, 0.8 / 2).
    assert!((found.point.world() - DVec3::new(2.4, 0.0, -6.4)).length() < 1e-14);
    let expected = DVec3::new(0.15, 0.0, 0.4).normalize();
    assert!(
        (found.normal - expected).length() < 1e-14,
        "{}",
        found.normal
    );
}

/// R27: spheres and ellipsoids wear images too: the middle faces +z, the top is at +y.
#[test]
fn round_things_wear_images() {
    for globe in [
        r#"sphere { material "white"; center 15.5 7.5 -9; radius 7; texture "map" }"#,
        r#"ellipsoid {
            material "white"; center 15.5 7.5 -9; radius 7; scale 1 1 0.5; texture "map" }"#,
    ] {
        let text = format!("texture \"map\" \"map.ppm\"\n{globe}");
        let map = ["WWWWWWWW", "RRGGBBYY", "YYBBGGRR", "MMMMCCCC"];
        let drawn = letters(&Stage::grid(&text).image("map", &map).film());
        assert_drawn(
            &drawn,
            "
            |................................|
            |.............WWWWWW.............|
            |............WWWWWWWW............|
            |...........GGGGGBBBBB...........|
            |..........GGGGGGBBBBBB..........|
            |.........GGGGGGGBBBBBBB.........|
            |.........GGGGGGGBBBBBBB.........|
            |.........GGGGGGGBBBBBBB.........|
            |.........BBBBBBBGGGGGGG.........|
            |.........BBBBBBBGGGGGGG.........|
            |.........BBBBBBBGGGGGGG.........|
            |..........BBBBBBGGGGGG..........|
            |...........BBBBBGGGGG...........|
            |............MMMMCCCC............|
            |.............MMMCCC.............|
            |................................|
            ",
        );
    }
}

/// R27, R29: the texel multiplies ambient and diffuse of a ball as of a plane.
#[test]
fn a_textured_ball_is_lit_like_a_textured_plane() {
    let text = r#"
        material "ball" { ambient 2; diffuse 3 }
        texture "one" "one.ppm"
        sphere { material "ball"; center 0 0 -5; radius 1; texture "one" }
        light { location 0 0 0; emissivity 6 }"#;
    let pixel = Stage::eye(text)
        .file("one.ppm", b"P6 1 1 255 \xff\x66\x00")
        .pixel();
    assert_color(pixel, [0.8125, 0.325, 0.0]);
}
