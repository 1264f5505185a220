//! From a place on a plane to a texel.

use std::collections::HashSet;
use std::path::PathBuf;
use std::sync::Arc;

use glam::DVec2;
use heliodon::math::Rgb;
use heliodon::surface::Hit;
use heliodon::texture::{Texels, Texture, TextureMap};

use super::tools::{Stage, hit};

/// Red numbers the columns from the left, green the rows from the top.
fn numbered(width: u16, height: u16) -> Arc<Texture> {
    let channels = (0..height).flat_map(|row| (0..width).map(move |column| [column, row, 0]));
    let texels = Texels {
        width: width.into(),
        height: height.into(),
        channels: channels.collect(),
        deep: true,
    };
    Arc::new(Texture::new(
        "numbered",
        "numbered.png",
        PathBuf::new(),
        texels,
        255.0,
    ))
}

/// Column from the left and row from the top of the texel at an offset.
fn texel(map: &TextureMap, x: f64, y: f64) -> (f64, f64) {
    let color = map.at(DVec2::new(x, y)) * 65_535.0;
    (color.r.round(), color.g.round())
}

/// R38, R39: CLAMP divides the offset by width and height and takes the nearest lower texel; the
/// corner is at the lower left of the upright image.
#[test]
fn clamp_is_upright_and_fills_the_plane() {
    let map = TextureMap::clamp(numbered(4, 5), DVec2::new(8.0, 10.0));
    assert_eq!(texel(&map, 0.0, 0.0), (0.0, 4.0));
    assert_eq!(texel(&map, 1.99, 1.99), (0.0, 4.0));
    assert_eq!(texel(&map, 2.0, 2.0), (1.0, 3.0));
    assert_eq!(texel(&map, 7.99, 9.99), (3.0, 0.0));
}

/// R41, G4: in REPEAT, whole pixel offsets are taken modulo the image's size.
#[test]
fn repeat_is_the_remainder_of_whole_pixels() {
    let map = TextureMap::repeat(numbered(5, 3), DVec2::new(0.5, 0.25));
    for (column, row) in [(0u16, 0u16), (4, 2), (5, 3), (17, 8), (50_003, 29_999)] {
        let (x, y) = (f64::from(column) * 0.5, f64::from(row) * 0.25);
        let expected = (f64::from(column % 5), f64::from(2 - row % 3));
        assert_eq!(texel(&map, x, y), expected, "at the pixel's edge");
        assert_eq!(texel(&map, x + 0.49, y + 0.24), expected, "at its end");
    }
}

/// G3: whole pixel offsets take every row and every column exactly once, in both modes.
#[test]
fn no_row_or_column_is_lost_or_doubled() {
    for side in [3u16, 7, 49, 100, 128, 200, 300, 384] {
        let whole = f64::from(side);
        for map in [
            TextureMap::clamp(numbered(side, side), DVec2::splat(whole)),
            TextureMap::clamp(numbered(side, side), DVec2::splat(whole / 8.0)),
            TextureMap::repeat(numbered(side, side), DVec2::splat(1.0)),
            TextureMap::repeat(numbered(side, side), DVec2::splat(0.125)),
        ] {
            let pixel = if map.size.x == whole || map.size.x == 1.0 {
                1.0
            } else {
                0.125
            };
            for number in 0..side {
                let offset = f64::from(number) * pixel;
                let expected = (f64::from(number), f64::from(side - 1 - number));
                assert_eq!(
                    texel(&map, offset, offset),
                    expected,
                    "{side} {:?}",
                    map.wrap
                );
            }
        }
    }
}

/// G1: the right and upper borders, which belong to the plane, show the last column and top row.
#[test]
fn the_far_borders_show_the_last_texels() {
    for side in [1u16, 3, 128, 300] {
        let map = TextureMap::clamp(numbered(side, side), DVec2::splat(0.7));
        assert_eq!(texel(&map, 0.7, 0.7), (f64::from(side - 1), 0.0));
    }
}

/// G2: offsets outside of the image, which only rounding could give, show its border.
#[test]
fn offsets_outside_show_the_border() {
    let map = TextureMap::clamp(numbered(4, 4), DVec2::ONE);
    assert_eq!(texel(&map, -1e-17, -1e-17), (0.0, 3.0));
    assert_eq!(texel(&map, 1.0f64.next_up(), 7.0), (3.0, 0.0));
    assert_eq!(texel(&map, f64::NAN, f64::NAN), (0.0, 3.0));
}

/// R14, R43: a texture plane is met exactly as the finite plane of the same shape.
#[test]
fn a_texture_plane_is_a_finite_plane() {
    let shape = "point 1 2 -3; normal 1 2 3; xdir 3 1 -1; dimensions 4 2";
    let text = format!(
        r#"texture "letter" "letter.ppm"
        finite-plane {{ material "white"; {shape} }}
        texture-plane {{ material "white"; {shape}; texture "letter" }}"#
    );
    let scene = Stage::eye(&text).image("letter", &["RG"]).scene();
    let [plane, textured] = [&*scene.surfaces[0], &*scene.surfaces[1]];
    let mut met = 0;
    for x in 0..40u8 {
        for y in 0..40u8 {
            let origin = [f64::from(x) / 4.0 - 2.0, f64::from(y) / 4.0 - 2.0, 2.0];
            let direction = [0.25, 0.125, -1.0];
            let found = hit(plane, origin, direction);
            let bare = |hit: Hit| Hit {
                texel: Rgb::WHITE,
                ..hit
            };
            assert_eq!(found, hit(textured, origin, direction).map(bare));
            met += u32::from(found.is_some());
        }
    }
    assert!(met > 50, "{met}");
    assert_eq!(plane.shape().bounds(), textured.shape().bounds());
}

/// G14: the nearest texel is shown, and nothing between two.
#[test]
fn no_colours_are_mixed() {
    let text = r#"
        texture "two" "two.ppm"
        texture-plane {
            material "white"; point -0.5 -0.5 0; normal 0 0 1; xdir 3 1 0; dimensions 40 12
            texture "two"
        }"#;
    let film = Stage::grid(text).image("two", &["RB"]).film();
    let colors: HashSet<_> = film
        .pixels()
        .iter()
        .map(|pixel| format!("{pixel:?}"))
        .collect();
    assert_eq!(colors.len(), 3, "red, blue, and black beside the plane");
}

/// G15: a channel of 255 is exactly 1; the course's 256 can be asked for.
#[test]
fn channels_are_divided_by_255() {
    let white = |divisor: &str| {
        let text = format!(
            r#"lighting {{ view-falloff "none" }}
            texture "white" "white.ppm" {divisor}
            texture-plane {{
                material "white"; point 0 0 0; normal 0 0 1; xdir 1 0 0; dimensions 1 1
                texture "white"
            }}"#
        );
        Stage::eye(&text).image("white", &["W"]).pixel()
    };
    assert_eq!(white(""), Rgb::WHITE);
    assert_eq!(white("divisor=256"), Rgb::WHITE * 255.0 / 256.0);
}
