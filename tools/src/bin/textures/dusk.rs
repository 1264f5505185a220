//! Draws a wall of evening sky, with the sun or without; left and right ends fit together.

use crate::canvas::Canvas;
use crate::colour::Colour;
use crate::noise::fractal;
use crate::shape::{length, smooth};

/// The width of the picture in pixels.
const WIDTH: usize = 1024;
/// The height of the picture in pixels.
const HEIGHT: usize = 384;
/// Where the sun is.
const SUN: (f64, f64) = (330.0, 322.0);

/// Pixels above the horizon, and the colour there.
const SKY: [(f64, u32); 6] = [
    (0.0, 0xff_cf_8e),
    (24.0, 0xff_ae_7a),
    (70.0, 0xe0_86_84),
    (130.0, 0x96_76_a6),
    (220.0, 0x52_64_a6),
    (384.0, 0x26_3c_78),
];

/// Draws the sky without the sun.
pub(crate) fn draw() -> Canvas {
    paint(0.0)
}

/// Draws the sky around the sun.
pub(crate) fn draw_with_sun() -> Canvas {
    paint(1.0)
}

/// A sky around a sun that is as bright as this, from 0 to 1.
fn paint(sun: f64) -> Canvas {
    Canvas::paint(WIDTH, HEIGHT, 2, |x, y| {
        let height = 384.0 - y;
        let away = length(x - SUN.0, y - SUN.1);
        let glow = sun * smooth(300.0, 0.0, away);
        let clear = sky(height).mix(Colour::hex(0xff_e2_a6), 0.9 * glow * glow);
        let clear = clear.mix(Colour::hex(0xff_fc_ee), sun * smooth(17.0, 13.0, away));
        clouds(x, height, glow, clear)
    })
}

/// The sky with nothing in it.
fn sky(height: f64) -> Colour {
    let mut colour = Colour::hex(SKY[0].1);
    for pair in SKY.windows(2) {
        let ((from, _), (to, above)) = (pair[0], pair[1]);
        colour = colour.mix(Colour::hex(above), smooth(from, to, height));
    }
    colour
}

/// Long clouds, which the sun lights from below; the lower the thinner, for they are farther away.
fn clouds(x: f64, height: f64, glow: f64, under: Colour) -> Colour {
    let far = 900.0 / (height + 60.0);
    let body = fractal(x / 128.0, far, 5, 91, [8, 0]);
    let veil = smooth(0.46, 0.74, body) * smooth(14.0, 60.0, height) * smooth(330.0, 120.0, height);
    let lit = Colour::hex(0xa8_7c_94).mix(Colour::hex(0xff_d8_a4), 0.3 + 0.7 * glow);
    under.mix(lit, 0.85 * veil)
}
