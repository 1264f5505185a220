//! Draws a cement tile: an eight-pointed star between quarters of a ring, which tiles complete.

use crate::canvas::Canvas;
use crate::colour::Colour;
use crate::noise::fractal;
use crate::shape::length;

/// The side of the picture in pixels.
const SIDE: usize = 128;

const CREAM: u32 = 0xf0_e2_c4;
const NAVY: u32 = 0x1c_3f_6e;
const TEAL: u32 = 0x2c_8c_8a;
const BRICK: u32 = 0xb8_4e_2a;
const GOLD: u32 = 0xdf_a5_3f;

/// Draws the picture.
pub(crate) fn draw() -> Canvas {
    Canvas::paint(SIDE, SIDE, 4, |x, y| {
        let colour = star(x, y, ring(x, y, Colour::hex(CREAM)));
        let joint = Colour::hex(0x8c_7f_6c);
        let edge = x.min(y).min(128.0 - x).min(128.0 - y);
        let colour = colour.cover(joint, edge - 0.9);
        // Cement takes up pigment unevenly.
        let worn = fractal(x / 16.0, y / 16.0, 4, 71, [8, 8]) - 0.5;
        colour * (1.0 + 0.22 * worn)
    })
}

/// The ring around a corner of the tile, of which a quarter lies in it.
fn ring(x: f64, y: f64, under: Colour) -> Colour {
    let from_corner = length(x.min(128.0 - x), y.min(128.0 - y));
    let band = |inner: f64, outer: f64| (inner - from_corner).max(from_corner - outer);
    under
        .cover(Colour::hex(NAVY), band(25.0, 47.0))
        .cover(Colour::hex(GOLD), band(33.0, 38.0))
        .cover(Colour::hex(TEAL), from_corner - 17.0)
        .cover(Colour::hex(CREAM), from_corner - 8.0)
}

/// The star in the middle: stars in stars, and a knob.
fn star(x: f64, y: f64, under: Colour) -> Colour {
    let (dx, dy) = ((x - 64.0).abs(), (y - 64.0).abs());
    // An upright square and one on its corner, of which either may hold a place.
    let reach = dx.max(dy).min((dx + dy) * 0.5_f64.sqrt());
    under
        .cover(Colour::hex(BRICK), reach - 33.0)
        .cover(Colour::hex(CREAM), reach - 27.5)
        .cover(Colour::hex(NAVY), reach - 24.0)
        .cover(Colour::hex(GOLD), reach - 13.0)
        .cover(Colour::hex(BRICK), length(dx, dy) - 8.0)
}
