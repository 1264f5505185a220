//! Draws a wall of red-brown bricks in running bond, small and enlarged, tiling both ways.

use crate::canvas::{Canvas, as_float};
use crate::colour::Colour;
use crate::noise::{cell, fractal, random};
use crate::shape::{Point, fraction, rectangle, smooth};

/// The side of the small picture in pixels; the pattern is measured in these pixels.
const SIZE: usize = 128;
/// How much larger the large picture is.
const ENLARGEMENT: usize = 3;
/// The width of a brick with its mortar; four fit across.
const WIDTH: f64 = 32.0;
/// The height of a brick with its mortar; eight fit down.
const HEIGHT: f64 = 16.0;
/// Half the thickness of the mortar between bricks.
const MORTAR: f64 = 1.05;
/// How far the bevel reaches into a brick.
const BEVEL: f64 = 1.5;

/// Draws the small picture.
pub(crate) fn draw_small() -> Canvas {
    Canvas::paint(SIZE, SIZE, 4, |x, y| shade((x, y), 0))
}

/// Draws the enlarged picture: the same bricks, with finer roughness than the small one shows.
pub(crate) fn draw_large() -> Canvas {
    let side = SIZE * ENLARGEMENT;
    let scale = 1.0 / as_float(ENLARGEMENT);
    Canvas::paint(side, side, 3, |x, y| shade((x * scale, y * scale), 1))
}

/// The brick at a point: its distance field, its column and its row.
fn brick(p: Point) -> (f64, i64, i64) {
    let row = cell(p.1 / HEIGHT).rem_euclid(8);
    let shift = if row % 2 == 0 { 0.0 } else { WIDTH / 2.0 };
    let column = cell((p.0 - shift) / WIDTH).rem_euclid(4);
    let pick = |slot: i64| random([column, row, slot], 21) - 0.5;
    // No two bricks are laid alike: each is a little off its place and its size.
    let x = fraction((p.0 - shift) / WIDTH) * WIDTH - WIDTH / 2.0 + 0.5 * pick(0);
    let y = fraction(p.1 / HEIGHT) * HEIGHT - HEIGHT / 2.0 + 0.4 * pick(1);
    let half = (
        WIDTH / 2.0 - MORTAR - 0.3 * pick(2).abs(),
        HEIGHT / 2.0 - MORTAR,
    );
    let chipped = tiled(p, 16, 3, 30) - 0.5 + 0.5 * (tiled(p, 64, 3, 34) - 0.5);
    (
        rectangle((x, y), (0.0, 0.0), half, 1.3) + 1.1 * chipped,
        column,
        row,
    )
}

/// Fractal noise with the given number of cells across the picture, which tiles with it.
fn tiled(p: Point, cells: u32, octaves: u32, seed: u32) -> f64 {
    let scale = f64::from(cells) / as_float(SIZE);
    fractal(
        p.0 * scale,
        p.1 * scale,
        octaves,
        seed,
        [i64::from(cells); 2],
    )
}

/// How far the wall stands out at a point: 0 in the mortar, about 1 on a brick.
fn relief(p: Point, finer: u32) -> f64 {
    let (distance, ..) = brick(p);
    let face = smooth(0.0, BEVEL, -distance);
    let rough = tiled(p, 32, 3 + finer, 40) - 0.5;
    let pit = smooth(0.58, 0.88, tiled(p, 64, 2 + finer, 45));
    face + (0.35 + 0.35 * face) * rough - 0.30 * face * pit + 0.1 * tiled(p, 16, 2, 49)
}

/// The colour at a point of the pattern; `finer` adds octaves for the enlarged picture.
fn shade(p: Point, finer: u32) -> Colour {
    const STEP: f64 = 0.33;
    let (distance, column, row) = brick(p);
    let pick = |slot: i64| random([column, row, slot], 22);
    let clay = Colour::hex(0xa2_52_3a).mix(Colour::hex(0x84_3c_2c), pick(0));
    let clay = clay.mix(Colour::hex(0xb8_74_50), 0.7 * smooth(0.6, 1.0, pick(1)));
    let clay = clay.mix(Colour::hex(0x66_36_30), 0.75 * smooth(0.78, 1.0, pick(2)));
    let clay = clay * (0.94 + 0.14 * pick(3));
    // Burnt patches, pale bloom and grains of sand.
    let patch = tiled(p, 8, 4 + finer, 50) - 0.5;
    let bloom = smooth(0.56, 0.78, tiled(p, 16, 4 + finer, 56));
    let sand = tiled(p, 64, 2 + finer, 61) - 0.5;
    let clay = clay.mix(Colour::hex(0xc8_9c_80), 0.28 * bloom) * (1.0 + 0.45 * patch + 0.22 * sand);
    let lime = Colour::hex(0xb9_ae_9c) * (0.88 + 0.3 * (tiled(p, 32, 3 + finer, 65) - 0.2));
    let mut colour = lime.mix(clay, smooth(0.35, -0.35, distance));
    // Light falls from the upper left; slopes towards it brighten, others darken.
    let here = relief(p, finer);
    let slope = (relief((p.0 + STEP, p.1), finer) - here) / STEP
        + 1.2 * (relief((p.0, p.1 + STEP), finer) - here) / STEP;
    colour = colour * (1.0 + (0.30 * slope).clamp(-0.42, 0.34));
    // A brick above and to the left throws a shadow into the mortar.
    let (above, ..) = brick((p.0 - 0.8, p.1 - 1.0));
    let hidden = smooth(0.3, -0.5, above) * smooth(-0.4, 0.3, distance);
    colour * (1.0 - 0.42 * hidden)
}
