//! Draws oak floor boards: four boards side by side, tiling in both directions.

use crate::canvas::Canvas;
use crate::colour::Colour;
use crate::noise::{cell, fractal, plane, random};
use crate::shape::{bump, fraction, smooth};

/// The side of the picture in pixels.
const SIZE: usize = 128;
/// The width of a board in pixels; four fit across.
const BOARD: f64 = 32.0;
/// The length of a board in pixels; it ends where its next copy begins.
const LENGTH: f64 = 128.0;
/// Where across each board the tree's pith lay; outside 0 to 1 the grain runs straight.
const PITHS: [f64; 4] = [0.56, -0.35, 0.42, 1.15];
/// Where the end joint of each board lies, staggered as a floor layer would.
const JOINTS: [f64; 4] = [20.0, 84.0, 46.0, 112.0];
/// How light each board is against the mean.
const TONES: [f64; 4] = [1.03, 0.95, 1.07, 0.985];
/// How red each board is against the mean.
const WARMTHS: [f64; 4] = [0.2, 0.55, 0.0, 0.8];
/// Half the width of the gap between boards in pixels.
const GAP: f64 = 0.55;

/// Draws the picture.
pub(crate) fn draw() -> Canvas {
    Canvas::paint(SIZE, SIZE, 4, shade)
}

/// The colour at a point.
fn shade(x: f64, y: f64) -> Colour {
    let index = cell(x / BOARD).rem_euclid(4);
    let board = usize::try_from(index).unwrap_or(0);
    let across = fraction(x / BOARD) * BOARD;
    // The grain restarts at the joint, so it need not repeat by itself.
    let along = fraction((y - JOINTS[board]) / LENGTH) * LENGTH;
    let wood = grain(across, along, index) * TONES[board];
    let wood = wood.filter(Colour([1.0, 1.0, 1.0]).mix(Colour([1.02, 0.95, 0.86]), WARMTHS[board]));
    let side = across.min(BOARD - across);
    let end = along.min(LENGTH - along);
    let edge = side.min(end);
    // Board edges are eased a little: they catch light on the left and top, shade on the right.
    let lit = bump(across - GAP - 0.6, 1.2) + 0.6 * bump(along - GAP - 0.6, 1.2);
    let dim = bump(BOARD - across - GAP - 0.6, 1.6) + 0.6 * bump(LENGTH - along - GAP - 0.6, 1.6);
    let wood = wood * (1.0 + 0.06 * lit - 0.10 * dim);
    Colour::hex(0x3a_24_12).mix(wood, smooth(GAP - 0.4, GAP + 0.5, edge))
}

/// The bare wood of one board at a point measured from its top left corner.
fn grain(across: f64, along: f64, board: i64) -> Colour {
    let seed = 40 + u32::try_from(board).unwrap_or(0) * 16;
    let pick = |slot: i64| random([board, slot, 7], 11);
    // A flat-sawn board cuts the tree's rings at a slant, which gives the cathedral arches:
    // rings are circles around the pith, and the pith comes nearer along the board.
    let sway = 7.0 * (fractal(across / 40.0, along / 46.0, 2, seed, [0, 0]) - 0.5);
    let centre = BOARD * PITHS[usize::try_from(board).unwrap_or(0)];
    let sideways = (across - centre + sway) / 4.6;
    let flip = if pick(1) < 0.5 { along } else { LENGTH - along };
    let depth = 0.4 + flip * (0.022 + 0.012 * pick(2));
    let wobble = 0.7 * fractal(across / 12.0, along / 70.0, 3, seed + 4, [0, 0]);
    let ring = (sideways * sideways + depth * depth).sqrt() * 0.92 + wobble;
    // Each year starts with a porous dark band and fades into dense light wood.
    let year = fraction(ring);
    let early = (1.0 - smooth(0.0, 0.62, year)) * smooth(0.0, 0.10, year)
        + 0.35 * (1.0 - smooth(0.0, 0.10, year));
    let strength = 0.6 + 0.8 * random([cell(ring), board, 3], 5);
    // Fibres are long and thin; pores are short dark dashes, thickest in the early wood.
    let fibre = fractal(across * 0.9, along / 22.0, 3, seed + 8, [0, 0]) - 0.5;
    let pore = smooth(
        0.70,
        0.92,
        plane(across * 1.25, along / 5.5, seed + 12, [0, 0]),
    );
    let fleck = smooth(
        0.80,
        0.96,
        plane(across / 2.1, along / 3.2, seed + 13, [0, 0]),
    );
    let drift = fractal(across / 24.0, along / 50.0, 2, seed + 14, [0, 0]) - 0.5;
    let dark = 0.46 * early * strength + pore * (0.14 + 0.22 * early) - 0.09 * fleck;
    let light = Colour::hex(0xba_85_4c);
    let deep = Colour::hex(0x66_3b_1a);
    light.mix(deep, 0.12 + dark + 0.34 * fibre) * (1.0 + 0.12 * drift)
}
