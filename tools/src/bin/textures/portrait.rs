//! Draws a painted portrait of an invented woman against a warm dark background.

use crate::brush::repaint;
use crate::bust::{Part, sitter};
use crate::canvas::{Canvas, as_float};
use crate::colour::Colour;
use crate::complexion::paint;
use crate::noise::{cell, fractal};
use crate::shape::{length, smooth};
use crate::vector::{Vector, vector};

/// The width of the picture in pixels.
const WIDTH: usize = 480;
/// The height of the picture in pixels.
const HEIGHT: usize = 640;
/// The pixels per unit of the sitter's space; her head is about 2.5 units high.
const SCALE: f64 = 130.0;
/// The pixel at which the middle of her head lies.
const MIDDLE: (f64, f64) = (236.0, 282.0);
/// The direction towards the lamp, to the upper left in front.
const LAMP: Vector = vector(-0.56, 0.58, 0.59);
/// The share of the smooth sketch in the finished painting.
const SMOOTHNESS: f64 = 0.3;
/// The distance from which rays start and beyond which there is only background.
const DEPTH: (f64, f64) = (1.8, -1.8);

/// Draws the picture.
pub(crate) fn draw() -> Canvas {
    let sketch = Canvas::paint(WIDTH, HEIGHT, 2, |x, y| {
        let (right, up) = ((x - MIDDLE.0) / SCALE, (MIDDLE.1 - y) / SCALE);
        let colour = match hit(right, up) {
            Some((p, part)) => shade(p, part),
            None => background(x, y),
        };
        colour * vignette(x, y)
    });
    let painted = repaint(&sketch);
    // A little of the smooth sketch shows through, which keeps the face delicate.
    Canvas::paint(WIDTH, HEIGHT, 1, |x, y| {
        let (column, row) = (index(x), index(y));
        painted
            .get(column, row)
            .mix(sketch.get(column, row), SMOOTHNESS)
    })
}

/// The row or column in which a coordinate lies.
fn index(coordinate: f64) -> usize {
    usize::try_from(cell(coordinate)).unwrap_or(0)
}

/// Darkens the corners so that the face stays the brightest place.
fn vignette(x: f64, y: f64) -> f64 {
    let (u, v) = (x / as_float(WIDTH) - 0.47, y / as_float(HEIGHT) - 0.44);
    1.0 - 0.62 * smooth(0.30, 0.80, length(u, v))
}

/// A warm dark wall, lighter behind the shaded side of the face.
fn background(x: f64, y: f64) -> Colour {
    let glow = smooth(330.0, 30.0, length(x - 330.0, y - 250.0));
    let cloud = fractal(x / 120.0, y / 120.0, 4, 90, [0, 0]) - 0.5;
    let base = Colour::hex(0x33_20_18).mix(Colour::hex(0x8e_62_3a), 0.9 * glow);
    base.mix(Colour::hex(0x4c_4a_34), 0.35 + 0.6 * cloud) * (1.0 + 0.5 * cloud)
}

/// The first point of the sitter behind a place of the picture.
fn hit(x: f64, y: f64) -> Option<(Vector, Part)> {
    let mut z = DEPTH.0;
    for _ in 0..120 {
        let p = vector(x, y, z);
        let (distance, part) = sitter(p);
        if distance < 0.001 {
            return Some((p, part));
        }
        // The distances are estimates, so a cautious step is safer.
        z -= distance * 0.75;
        if z < DEPTH.1 {
            return None;
        }
    }
    None
}

/// The direction in which the surface faces.
fn normal(p: Vector, step: f64) -> Vector {
    let along = |d: Vector| sitter(p + d * step).0 - sitter(p - d * step).0;
    let (x, y, z) = (
        vector(1.0, 0.0, 0.0),
        vector(0.0, 1.0, 0.0),
        vector(0.0, 0.0, 1.0),
    );
    vector(along(x), along(y), along(z)).unit()
}

/// How much of the lamp a point sees, with a soft border, from 0 to 1.
fn open(p: Vector) -> f64 {
    let (mut reach, mut seen) = (0.05, 1.0_f64);
    while reach < 2.0 && seen > 0.02 {
        let (distance, _) = sitter(p + LAMP * reach);
        seen = seen.min(0.5 + 4.5 * distance / reach);
        reach += distance.clamp(0.025, 0.2);
    }
    smooth(0.0, 1.0, seen)
}

/// How free the surroundings of a point are, from 0 in a deep hollow to 1.
fn airy(p: Vector, n: Vector) -> f64 {
    let mut closed = 0.0;
    for (reach, weight) in [(0.05, 4.0), (0.12, 2.0), (0.26, 1.0), (0.5, 0.5)] {
        closed += (reach - sitter(p + n * reach).0).max(0.0) * weight;
    }
    (1.0 - 0.9 * closed).clamp(0.0, 1.0)
}

/// The painted colour of a point of the sitter.
fn shade(p: Vector, part: Part) -> Colour {
    let n = normal(p, 0.006);
    let [light, half, dark] = paint(part, p);
    let facing = n.dot(LAMP);
    let direct = smooth(-0.12, 1.0, facing) * open(p + n * 0.01);
    let airy = airy(p, n);
    // Light from the wall fills the shade, mostly from the right and from above.
    let fill = (0.26 + 0.16 * n.x + 0.14 * n.y) * airy;
    let level = 0.80 * direct + fill;
    let mut colour = dark
        .mix(half, smooth(0.0, 0.45, level))
        .mix(light, smooth(0.34, 1.10, level));
    let (gloss, width) = match part {
        Part::Skin => (0.10, 0.90),
        Part::Eye => (0.10, 0.96),
        Part::Hair => (0.20, 0.86),
        Part::Dress => (0.10, 0.80),
        Part::Collar => (0.0, 0.9),
        Part::Gold => (0.9, 0.85),
    };
    let middle = (LAMP + vector(0.0, 0.0, 1.0)).unit();
    let shine = smooth(width, 1.0, n.dot(middle)) * direct;
    colour = colour + Colour([1.0, 0.95, 0.85]) * (gloss * shine);
    // A thin cool rim on the right lifts her off the background.
    let rim = smooth(0.45, 0.0, n.z) * smooth(0.3, 0.9, n.x) * airy;
    colour + Colour([0.30, 0.20, 0.12]) * (0.55 * rim)
}
