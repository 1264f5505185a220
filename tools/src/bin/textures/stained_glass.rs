//! Draws a stained glass window: a rosette above a lattice of lozenges, all set in lead.

use crate::angle::{cosine, direction, sine};
use crate::canvas::Canvas;
use crate::colour::Colour;
use crate::noise::{cell, fractal, puffs, random};
use crate::shape::{Point, bump, ellipse, fraction, length, smooth};
use std::f64::consts::TAU;

/// The width of the picture in pixels.
const WIDTH: usize = 256;
/// The height of the picture in pixels.
const HEIGHT: usize = 384;
/// Half the width of a lead line in pixels.
const LEAD: f64 = 2.0;
/// The middle of the rosette.
const CENTRE: Point = (128.0, 128.0);
/// The radii of the rosette's circles, the innermost first.
const RINGS: [f64; 3] = [19.0, 64.0, 101.0];
/// The inner edge of the border panes.
const BORDER: f64 = 22.0;
/// The row below which the lattice begins.
const SILL: f64 = 236.0;
/// The distance between opposite sides of a lozenge.
const LOZENGE: f64 = 27.0;

// The glass colours.
const RUBY: u32 = 0xc4_14_22;
const COBALT: u32 = 0x14_3c_c0;
const AZURE: u32 = 0x2e_86_dc;
const EMERALD: u32 = 0x0f_8c_46;
const AMBER: u32 = 0xf2_a0_18;
const STRAW: u32 = 0xf8_d6_5a;
const VIOLET: u32 = 0x6e_22_9e;

/// A pane at a point: its colour, its number, and the distance to the nearest lead's middle.
type Pane = (u32, i64, f64);

/// Draws the picture.
pub(crate) fn draw() -> Canvas {
    Canvas::paint(WIDTH, HEIGHT, 4, |x, y| {
        let (hue, number, distance) = pane((x, y));
        glass((x, y), hue, number, distance)
    })
}

/// Lead, or the glass of a pane with its streaks, bubbles and dirt in the corners.
fn glass(p: Point, hue: u32, number: i64, distance: f64) -> Colour {
    let pick = |slot: i64| random([number, slot, 0], 4);
    let tilt = 0.5 + pick(0);
    let streak = fractal(
        p.0 / (9.0 * tilt) + 40.0 * pick(1),
        p.1 / 16.0 + p.0 / 30.0,
        4,
        6,
        [0, 0],
    ) - 0.5;
    let seed = bump(puffs(p.0 / 11.0, p.1 / 11.0, 8), 0.13);
    let grime = smooth(0.0, 9.0, distance - LEAD);
    let tone = (0.86 + 0.28 * pick(2)) * (0.72 + 0.34 * grime) * (1.0 + 0.42 * streak);
    let colour = Colour::hex(hue).mix(Colour::WHITE, 0.10 * pick(3) + 0.25 * seed) * tone;
    // Lead is round: a faint gleam runs along its upper left.
    let gleam = 0.06 + 0.07 * smooth(1.6, 0.0, distance);
    let lead = Colour([gleam, gleam, gleam * 1.1]);
    lead.mix(colour, smooth(LEAD - 0.5, LEAD + 0.5, distance))
}

/// The pane at a point.
fn pane(p: Point) -> Pane {
    let (width, height) = (256.0, 384.0);
    let edge = p.0.min(width - p.0).min(p.1).min(height - p.1);
    if edge < BORDER {
        return border(p, edge);
    }
    let frame = edge - BORDER;
    let (hue, number, distance) = if p.1 < SILL { upper(p) } else { lattice(p) };
    (hue, number, distance.min(frame).min((p.1 - SILL).abs()))
}

/// The border: squares and oblongs in turn around the window.
fn border(p: Point, edge: f64) -> Pane {
    let upright = p.0.min(256.0 - p.0) < p.1.min(384.0 - p.1);
    let (along, length) = if upright { (p.1, 384.0) } else { (p.0, 256.0) };
    let ends = along.min(length - along);
    let outer = edge.min(BORDER - edge);
    if ends < BORDER {
        let corner = i64::from(p.0 > 128.0) * 2 + i64::from(p.1 > 192.0);
        return (RUBY, 900 + corner, outer.min(BORDER - ends));
    }
    let count = if upright { 17.0 } else { 11.0 };
    let place = (along - BORDER) / (length - 2.0 * BORDER) * count;
    let step = (length - 2.0 * BORDER) / count;
    let gap = fraction(place).min(1.0 - fraction(place)) * step;
    let index = cell(place);
    let side = if upright {
        i64::from(p.0 > 128.0)
    } else {
        2 + i64::from(p.1 > 192.0)
    };
    let hue = if index % 2 == 0 { COBALT } else { AMBER };
    (hue, 1000 + index * 4 + side, outer.min(gap))
}

/// The rosette and the spandrels around it.
fn upper(p: Point) -> Pane {
    let (dx, dy) = (p.0 - CENTRE.0, p.1 - CENTRE.1);
    let away = length(dx, dy);
    let turn = fraction(direction(dx, -dy) / TAU + 1.0);
    let rings = RINGS
        .iter()
        .map(|ring| (away - ring).abs())
        .fold(f64::INFINITY, f64::min);
    // The share of the turn is folded into one of several equal wedges around the middle.
    let wedge = |count: f64, shift: f64| {
        let place = turn * count + shift;
        let offset = (fraction(place) - 0.5) / count * TAU;
        let rim = (0.5 / count * TAU - offset.abs()).min(1.0);
        (
            cell(place).rem_euclid(cell(count)),
            away * cosine(offset),
            away * sine(offset),
            away * sine(rim),
        )
    };
    if away < RINGS[0] {
        let spokes = wedge(6.0, 0.0);
        let bud = (away - 8.5).abs();
        let hue = if away < 8.5 { RUBY } else { STRAW };
        let spoke = if away < 8.5 { bud } else { bud.min(spokes.3) };
        return (
            hue,
            if away < 8.5 { 99 } else { spokes.0 },
            rings.min(spoke),
        );
    }
    if away < RINGS[1] {
        let (index, out, aside, rim) = wedge(8.0, 0.5);
        let petal = ellipse((out, aside), (41.5, 0.0), (22.0, 13.0));
        if petal < 0.0 {
            let hue = if index % 2 == 0 { RUBY } else { AMBER };
            return (hue, 20 + index, rings.min(-petal));
        }
        let lead = rings.min(petal).min((out - 41.5).abs()).min(rim);
        let (outside, hue) = if out > 41.5 {
            (0, COBALT)
        } else {
            (1, EMERALD)
        };
        return (hue, 40 + index * 2 + outside, lead);
    }
    if away < RINGS[2] {
        let (index, out, aside, rim) = wedge(16.0, 0.5);
        let roundel = length(out - 83.0, aside) - 10.0;
        if roundel < 0.0 {
            let hue = if index % 2 == 0 { STRAW } else { RUBY };
            return (hue, 60 + index, -roundel);
        }
        let hue = if index % 2 == 0 { VIOLET } else { AZURE };
        return (hue, 80 + index, rings.min(rim).min(roundel));
    }
    let corner = (
        if dx < 0.0 { 34.0 } else { 222.0 },
        if dy < 0.0 { 34.0 } else { 222.0 },
    );
    let stud = length(p.0 - corner.0, p.1 - corner.1) - 18.0;
    let number = 120 + i64::from(dx > 0.0) * 2 + i64::from(dy > 0.0);
    if stud < 0.0 {
        (AMBER, number, -stud)
    } else {
        (
            EMERALD,
            number + 10,
            rings.min(stud).min(dx.abs()).min(dy.abs()),
        )
    }
}

/// The lozenges below.
fn lattice(p: Point) -> Pane {
    const HUES: [u32; 6] = [AZURE, STRAW, EMERALD, AZURE, RUBY, COBALT];
    let (right, down) = ((p.0 - 128.0) / 35.33, (p.1 - SILL) / 42.0);
    // In these coordinates the lozenges are unit squares, and leads run where one is whole.
    let (first, second) = (right + down + 0.5, down - right + 0.5);
    let near = |value: f64| fraction(value).min(1.0 - fraction(value)) * LOZENGE;
    let (i, j) = (cell(first), cell(second));
    let hue = HUES[usize::try_from((i * 2 + j * 2 + (i - j).abs()).rem_euclid(6)).unwrap_or(0)];
    (hue, 200 + i * 16 + j, near(first).min(near(second)))
}
