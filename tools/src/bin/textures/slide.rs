//! Draws a projector slide: a small cheerful landscape in bright colours.

use crate::angle::{direction, sine};
use crate::canvas::Canvas;
use crate::colour::Colour;
use crate::farm::{house, tree};
use crate::noise::{cell, corner, fractal, random};
use crate::shape::{Point, circles, fraction, length, smooth};

/// The width of the picture in pixels.
const WIDTH: usize = 320;
/// The height of the picture in pixels.
const HEIGHT: usize = 240;
/// The middle of the sun.
const SUN: Point = (72.0, 54.0);
/// The clouds as circles: place and radius.
const PUFFS: [(f64, f64, f64); 9] = [
    (168.0, 52.0, 11.0),
    (182.0, 45.0, 15.0),
    (199.0, 49.0, 13.0),
    (212.0, 54.0, 9.0),
    (256.0, 82.0, 8.0),
    (267.0, 76.0, 11.0),
    (280.0, 79.0, 9.0),
    (128.0, 88.0, 6.0),
    (137.0, 85.0, 8.0),
];
/// Draws the picture.
pub(crate) fn draw() -> Canvas {
    Canvas::paint(WIDTH, HEIGHT, 4, |x, y| {
        let p = (x, y);
        let picture = tree(p, house(p, meadow(p, hills(p, clouds(p, heaven(p))))));
        // Grain like that of film keeps large areas alive.
        let grain = fractal(x * 0.45, y * 0.45, 2, 3, [0, 0]) - 0.5;
        picture * (1.0 + 0.05 * grain)
    })
}

/// Sky, sun and sunbeams.
fn heaven(p: Point) -> Colour {
    let sky = Colour::hex(0x1f_86_e8).mix(Colour::hex(0xa6_e2_fb), smooth(0.0, 150.0, p.1));
    let (dx, dy) = (p.0 - SUN.0, p.1 - SUN.1);
    let away = length(dx, dy);
    let beam = fraction(direction(dx, dy) / std::f64::consts::TAU * 14.0) - 0.5;
    let width =
        smooth(0.20, 0.12, beam.abs()) * smooth(34.0, 38.0, away) * smooth(62.0, 56.0, away);
    let glow = sky.mix(Colour::hex(0xff_f3_a8), 0.6 * smooth(90.0, 24.0, away));
    let rays = glow.mix(Colour::hex(0xff_cf_2e), width);
    let disc = Colour::hex(0xff_e4_4a).mix(Colour::hex(0xff_b4_1a), smooth(4.0, 28.0, away));
    rays.cover(disc, away - 27.0)
}

/// White clouds with a pale blue underside.
fn clouds(p: Point, under: Colour) -> Colour {
    let body = circles(p, &PUFFS);
    let shade = circles((p.0 + 2.0, p.1 + 5.0), &PUFFS);
    let white = Colour::hex(0xc3_dc_f4).mix(Colour::WHITE, smooth(1.0, -3.0, shade));
    under.cover(white, body)
}

/// Two blue mountains with snow and two rows of green hills.
fn hills(p: Point, under: Colour) -> Colour {
    let jag = 5.0 * (fractal(p.0 * 0.09, p.1 * 0.05, 4, 5, [0, 0]) - 0.5);
    let peak = |x: f64, y: f64, steep: f64| y + (p.0 - x).abs() * steep + 2.0 * jag - p.1;
    let ridge = peak(232.0, 86.0, 0.62).min(peak(292.0, 100.0, 0.55));
    let left = if p.0 < 232.0 || (p.0 > 266.0 && p.0 < 292.0) {
        1.0
    } else {
        0.0
    };
    let rock = Colour::hex(0x5b_72_b8).mix(Colour::hex(0x86_9e_da), left);
    let snow = smooth(-22.0 + 2.5 * jag, -20.0 + 2.5 * jag, ridge);
    let picture = under.cover(rock.mix(Colour::hex(0xf4_f8_ff), snow), ridge);
    let far = 148.0 + 12.0 * sine(p.0 * 0.021 + 0.6) - p.1;
    let green = Colour::hex(0x74_c2_5a).mix(Colour::hex(0x4a_a0_4e), smooth(0.0, 45.0, -far));
    let picture = picture.cover(green, far);
    let near = 166.0 + 13.0 * sine(p.0 * 0.026 + 3.4) - p.1;
    let green = Colour::hex(0x6c_cc_3c).mix(Colour::hex(0x38_9c_34), smooth(0.0, 40.0, -near));
    // Ploughed rows give the nearer hill its curve.
    let row = fraction((p.1 * 0.5 - p.0 * 0.22) / 5.0);
    let green = green.mix(
        Colour::hex(0x52_b4_30),
        0.5 * smooth(0.45, 0.55, row) * smooth(150.0, 200.0, p.0),
    );
    picture.cover(green, near)
}

/// The flowery meadow in front and the path to the house.
fn meadow(p: Point, under: Colour) -> Colour {
    let edge = 196.0 + 6.0 * sine(p.0 * 0.018 + 1.0) - p.1;
    let grass = Colour::hex(0x5c_c4_2c).mix(Colour::hex(0x22_8a_2c), smooth(0.0, 44.0, -edge));
    let blade = fractal(p.0 * 0.5, p.1 * 0.14, 2, 8, [0, 0]) - 0.5;
    let mut picture = under.cover(grass * (1.0 + 0.22 * blade), edge);
    let down = (p.1 - 190.0) / 50.0;
    let path = (p.0 - 214.0 + 26.0 * sine(down * 2.6)).abs() - 5.0 - 15.0 * down.max(0.0);
    picture = picture.cover(
        Colour::hex(0xf2_d4_8a) * (1.0 + 0.1 * blade),
        path.max(190.0 - p.1),
    );
    let (i, j) = (cell(p.0 / 11.0), cell(p.1 / 11.0));
    let pick = |slot: i64| random([i, j, slot], 9);
    let middle = (
        (corner(i) + 0.25 + 0.5 * pick(0)) * 11.0,
        (corner(j) + 0.25 + 0.5 * pick(1)) * 11.0,
    );
    if pick(2) < 0.45 && middle.1 > 206.0 && path > 4.0 {
        let petals = [0xff_4a_5e, 0xff_f0_5a, 0xff_ff_ff, 0xd0_6a_f0];
        let petal = petals[usize::try_from(cell(pick(3) * 3.99)).unwrap_or(0)];
        let away = length(p.0 - middle.0, p.1 - middle.1);
        picture = picture.cover(Colour::hex(petal), away - 2.3);
        picture = picture.cover(Colour::hex(0xf6_a8_1c), away - 0.8);
    }
    picture
}
