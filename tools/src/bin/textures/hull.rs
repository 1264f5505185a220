//! Draws the hull of a flying saucer: metal panels, rivets and a ring of lit windows.

use crate::angle::cosine;
use crate::canvas::{Canvas, as_float};
use crate::colour::Colour;
use crate::noise::{cell, fractal, random};
use crate::shape::{Point, bump, fraction, length, rectangle, smooth};
use std::f64::consts::PI;

/// The width of the picture in pixels, once around the hull.
const WIDTH: usize = 512;
/// The height of the picture in pixels, from pole to pole.
const HEIGHT: usize = 256;
/// The row of the equator.
const EQUATOR: f64 = 128.0;
/// The rows at which rings of panels meet.
const SEAMS: [f64; 8] = [18.0, 40.0, 72.0, 108.0, 148.0, 184.0, 216.0, 238.0];
/// How many panels each ring has; fewer near the poles, where the hull is narrow.
const PANELS: [i64; 9] = [1, 8, 16, 32, 64, 32, 16, 8, 1];
/// Half the height of the window band.
const BAND: f64 = 13.0;
/// The distance from one window to the next.
const PITCH: f64 = 16.0;
/// The distance from one rivet to the next.
const RIVETS: f64 = 6.0;

/// Draws the picture.
pub(crate) fn draw() -> Canvas {
    Canvas::paint(WIDTH, HEIGHT, 4, |x, y| {
        let p = (x, y);
        let metal = dirt(p, plates(p));
        let (trim, inside) = ((y - EQUATOR).abs() - BAND, (y - EQUATOR).abs() < BAND);
        let colour = if inside { windows(p, trim) } else { metal };
        // A polished rail borders the band on both sides.
        let rail = bump(trim - 1.4, 2.6);
        let shine = Colour::hex(0xf0_f2_f4).mix(Colour::hex(0x6a_70_78), smooth(0.0, 2.8, trim));
        poles(p, colour.mix(shine, smooth(0.0, 0.5, rail)))
    })
}

/// Noise that repeats once around the hull, with the given number of cells across and down.
fn around(p: Point, across: u32, down: u32, octaves: u32, seed: u32) -> f64 {
    let x = p.0 / as_float(WIDTH) * f64::from(across);
    let y = p.1 / as_float(HEIGHT) * f64::from(down);
    fractal(x, y, octaves, seed, [i64::from(across), 0])
}

/// How much of the hull's girth a row has: towards the poles a pixel covers less and less.
fn shrink(row: f64) -> f64 {
    cosine((row - EQUATOR) / EQUATOR * PI / 2.0).max(0.02)
}

/// Brushed metal plates with seams and rivets.
fn plates(p: Point) -> Colour {
    let ring = SEAMS.iter().take_while(|&&seam| p.1 > seam).count();
    let count = PANELS[ring];
    let step = as_float(WIDTH) / crate::noise::corner(count);
    let shift = if ring % 2 == 0 { 0.0 } else { 0.5 };
    let place = p.0 / step + shift;
    let panel = cell(place).rem_euclid(count);
    let ring_number = i64::try_from(ring).unwrap_or(0);
    let pick = |slot: i64| random([panel, ring_number, slot], 2);
    let narrow = shrink(p.1);
    let side = fraction(place).min(1.0 - fraction(place)) * step * narrow;
    let side = if count == 1 { f64::INFINITY } else { side };
    let offset = SEAMS
        .iter()
        .map(|seam| p.1 - seam)
        .min_by(|a, b| a.abs().total_cmp(&b.abs()));
    let level = offset.unwrap_or(f64::INFINITY);
    let seam = side.min(level.abs());
    let brushed = around(p, 32, 256, 3, 10) - 0.5;
    let broad = around(p, 6, 5, 3, 14) - 0.5;
    let cool = Colour::hex(0xa8_b0_b8).mix(Colour::hex(0xb8_b2_a8), pick(0));
    let tone = 0.93 + 0.14 * pick(1) + 0.16 * brushed + 0.14 * broad;
    let lit = 0.10 * bump(level - 1.6, 1.4) - 0.10 * bump(level + 1.6, 1.4);
    let mut metal = cool * (tone + lit);
    metal = metal.mix(Colour::hex(0x2c_30_36), 0.85 * smooth(1.1, 0.35, seam));
    // Rivets sit in rows beside every seam, each with a gleam and a shadow.
    let girth = as_float(WIDTH) * shrink(p.1 - level) / RIVETS;
    let along = if side < level.abs() {
        p.1 / RIVETS
    } else {
        p.0 / as_float(WIDTH) * girth.ceil()
    };
    let spot = (fraction(along) - 0.5) * RIVETS;
    let beside = seam - 3.2;
    let rivet = length(spot, beside);
    metal = metal.mix(Colour::hex(0x54_5a_62), 0.7 * smooth(1.5, 1.0, rivet));
    let gleam = length(spot + 0.35, beside.abs() + 0.1);
    let metal = metal.mix(Colour::hex(0xe6_ea_ee), 0.8 * smooth(0.9, 0.4, gleam));
    // A few inspection lids break the pattern.
    let lid = rectangle(
        (
            (fraction(place) - 0.5) * step * narrow,
            p.1 - 90.0 - 76.0 * f64::from(u8::from(p.1 > EQUATOR)),
        ),
        (0.0, 0.0),
        (4.5, 6.0),
        1.5,
    );
    if pick(2) < 0.3 {
        metal.mix(Colour::hex(0x3a_3f_46), 0.75 * bump(lid, 0.9))
    } else {
        metal
    }
}

/// Darkens the metal by soot and rust that ran away from the window band.
fn dirt(p: Point, metal: Colour) -> Colour {
    let away = (p.1 - EQUATOR).abs() - BAND;
    let run = around(p, 128, 4, 3, 20);
    let reach = 12.0 + 50.0 * around(p, 64, 1, 2, 24);
    let streak = smooth(0.52, 0.8, run) * smooth(reach, 0.0, away);
    let stain = smooth(0.55, 0.8, around(p, 12, 8, 5, 28));
    let colour = metal.mix(Colour::hex(0x4e_42_36), 0.55 * streak + 0.22 * stain);
    let scorch = smooth(0.60, 0.75, around(p, 20, 12, 4, 33));
    colour.mix(Colour::hex(0x2e_30_34), 0.30 * scorch)
}

/// The dark band with its ring of lit windows; `trim` is negative inside the band.
fn windows(p: Point, trim: f64) -> Colour {
    let index = cell(p.0 / PITCH);
    let pick = |slot: i64| random([index, slot, 0], 41);
    let x = (fraction(p.0 / PITCH) - 0.5) * PITCH;
    let pane = rectangle((x, p.1 - EQUATOR), (0.0, 0.0), (4.6, 6.6), 4.4);
    let brush = around(p, 64, 256, 2, 44) - 0.5;
    let band =
        Colour::hex(0x3c_42_4c) * (0.9 + 0.3 * brush) * (0.75 + 0.25 * smooth(0.0, -4.0, trim));
    // Every fourth light is a signal lamp, the others show the warm cabin.
    let lamp = match index.rem_euclid(4) {
        0 => Colour::hex(0x6a_f0_d8),
        _ => Colour::hex(0xff_d8_78),
    };
    let core = lamp.mix(Colour::WHITE, 0.75 * smooth(-0.5, -4.5, pane)) * (0.86 + 0.14 * pick(0));
    let halo = band.mix(lamp, 0.45 * smooth(5.0, 0.5, pane));
    let frame = halo.mix(Colour::hex(0xb4_ba_c2), bump(pane - 0.9, 1.1));
    frame.mix(core, smooth(0.3, -0.3, pane))
}

/// Lays a glass dome over the north pole and a glowing drive ring around the south pole.
fn poles(p: Point, under: Colour) -> Colour {
    let dome = Colour::hex(0x1c_3a_50).mix(Colour::hex(0x6a_a8_c4), smooth(4.0, 18.0, p.1));
    let colour = under.mix(dome, smooth(18.5, 17.5, p.1));
    let ring = bump(p.1 - 227.0, 8.0);
    let pulse = 0.75 + 0.25 * around(p, 32, 8, 2, 51);
    let glow = Colour::hex(0x5a_e0_ff).mix(Colour::WHITE, smooth(0.55, 1.0, ring)) * pulse;
    let colour = colour.mix(glow, smooth(0.0, 0.7, ring));
    colour.mix(Colour::hex(0x22_26_2c), smooth(237.5, 238.5, p.1))
}
