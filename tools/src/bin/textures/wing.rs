//! Draws the view from an airliner's cabin window: a wing above a sea of clouds.

use crate::canvas::{Canvas, as_float};
use crate::cloud::{SUN, sky};
use crate::colour::Colour;
use crate::noise::{cell, fractal, random};
use crate::shape::{Point, bump, ellipse, fraction, smooth};
use crate::vector::{Vector, vector};
use crate::winglet::winglet;

/// The width of the picture in pixels.
const WIDTH: usize = 1024;
/// The height of the picture in pixels.
const HEIGHT: usize = 768;
/// The row of the horizon.
const HORIZON: f64 = 318.0;
/// The tangent of half the horizontal field of view.
const SPREAD: f64 = 0.62;
/// The sine and cosine of the angle by which the traveller looks forward along the cabin.
const TURN: Point = (0.4226, 0.9063);
/// The distance from the window to the wing tip in metres.
const TIP: f64 = 15.0;
/// Where the straight inner part of the trailing edge ends.
const KINK: f64 = 5.2;
/// The places of the flap track fairings along the wing.
const FAIRINGS: [f64; 3] = [4.4, 7.6, 10.6];

/// Draws the picture.
pub(crate) fn draw() -> Canvas {
    let backdrop = Canvas::paint(WIDTH, HEIGHT, 2, |x, y| sky(ray(x, y)));
    Canvas::paint(WIDTH, HEIGHT, 4, |x, y| {
        let pixel = |value: f64| usize::try_from(cell(value)).unwrap_or(0);
        let behind = backdrop.get(pixel(x), pixel(y));
        aeroplane(ray(x, y)).unwrap_or(behind)
    })
}

/// The direction seen at a point of the picture: x runs forward, y up, z away from the cabin.
fn ray(x: f64, y: f64) -> Vector {
    let half = as_float(WIDTH) / 2.0;
    let (right, up) = ((x - half) / half * SPREAD, (HORIZON - y) / half * SPREAD);
    vector(right * TURN.1 + TURN.0, up, TURN.1 - right * TURN.0)
}

/// The front edge of the wing at a distance from the cabin.
fn leading(z: f64) -> f64 {
    11.0 - 0.667 * z
}

/// The rear edge of the wing.
fn trailing(z: f64) -> f64 {
    if z < KINK {
        3.7 - 0.08 * z
    } else {
        3.284 - 0.395 * (z - KINK)
    }
}

/// The height of the wing against the eye; lift bends it upwards.
fn rise(z: f64) -> f64 {
    -2.45 + 0.045 * z + 0.0048 * z * z
}

/// The colour of the part of the aeroplane in a direction, if there is one.
fn aeroplane(ray: Vector) -> Option<Colour> {
    // Where the ray meets the bent surface is the smaller root of a quadratic equation.
    let (a, b) = (0.0048 * ray.z * ray.z, 0.045 * ray.z - ray.y);
    let root = b * b + 4.0 * a * 2.45;
    let reach = if root >= 0.0 {
        (root.sqrt() - b) / (2.0 * a)
    } else {
        0.0
    };
    let (x, z) = (ray.x * reach, ray.z * reach);
    if reach > 0.0 && z > 0.0 && z < TIP {
        if x < leading(z) && x > trailing(z) {
            return Some(skin(x, z, ray));
        }
        if let Some(colour) = fairing(x, z) {
            return Some(colour);
        }
    }
    winglet(ray, TIP, rise(TIP))
}

/// A line of the given half width, dark where it is close to its place.
fn line(offset: f64, half: f64) -> f64 {
    1.0 - smooth(half * 0.6, half * 1.4, offset.abs())
}

/// The upper surface of the wing.
fn skin(x: f64, z: f64, ray: Vector) -> Colour {
    let chord = leading(z) - trailing(z);
    let share = (leading(z) - x) / chord;
    let slope = 0.34 * (1.0 - 2.0 * share) + 0.5 * bump(share, 0.10);
    let normal = vector(slope, 1.0, -0.045 - 0.0096 * z).unit();
    let facing = normal.dot(SUN.unit()).max(0.0);
    let paint = Colour::hex(0xc9_cd_d2);
    let metal = Colour::hex(0xe2_e4_e6);
    let base = paint.mix(metal, smooth(0.125, 0.12, share));
    let mut colour = base * (0.50 + 0.68 * facing);
    // Gloss: the sky's glare grows as the view grazes the surface, and the sun's patch is broad.
    let view = ray.unit() * -1.0;
    let graze = 1.0 - normal.dot(view).clamp(0.0, 1.0);
    colour = colour.mix(Colour::hex(0xdc_e8_f4), 0.30 * graze * graze * graze);
    let half = (view + SUN.unit()).unit().dot(normal).max(0.0);
    let gloss = smooth(0.80, 1.0, half);
    colour = colour + Colour([1.0, 0.97, 0.9]) * (0.22 * gloss * gloss);
    // Panels differ a little in tone; ribs and stringers show as faint lines.
    let panel = random([cell(z / 1.35), cell(share * 5.0), 0], 31) - 0.5;
    let cloudy = fractal(x * 0.8, z * 0.8, 4, 33, [0, 0]) - 0.5;
    colour = colour * (1.0 + 0.045 * panel + 0.09 * cloudy);
    let ribs = line((fraction(z / 1.35) - 0.5) * 1.35, 0.012) * smooth(0.62, 0.6, share);
    let stringer = line((fraction(share * 5.0) - 0.5) / 5.0 * chord, 0.010);
    // The thin rear edge is bare and catches the light.
    colour = colour.mix(
        Colour::hex(0xf2_f4_f6),
        0.6 * line((1.0 - share) * chord, 0.025),
    );
    let colour = colour * (1.0 - 0.12 * rivets(share, z, chord));
    colour
        * (1.0 - 0.15 * ribs.max(0.6 * stringer))
        * (1.0 - seams(share, z, chord))
        * dirt(x, z, share)
}

/// The heads of the rivets along ribs and hinges, from 0 between them to 1.
fn rivets(share: f64, z: f64, chord: f64) -> f64 {
    const PITCH: f64 = 0.085;
    let dots = |along: f64| line((fraction(along / PITCH) - 0.5) * PITCH, 0.014);
    let beside = |offset: f64| line(offset.abs() - 0.05, 0.014);
    let rib = beside((fraction(z / 1.35) - 0.5) * 1.35) * dots(share * chord);
    let hinge = line((share - 0.715) * chord, 0.016).max(line((share - 0.148) * chord, 0.016));
    rib.max(hinge * dots(z))
}

/// The dark gaps between the wing's moving parts: 0 for none, about 0.6 in a gap.
fn seams(share: f64, z: f64, chord: f64) -> f64 {
    let across = |place: f64, half: f64| line((share - place) * chord, half);
    let cut = |places: &[f64], half: f64| {
        places
            .iter()
            .map(|&place| line(z - place, half))
            .fold(0.0, f64::max)
    };
    let slat =
        across(0.125, 0.018) + smooth(0.125, 0.12, share) * cut(&[3.4, 6.3, 9.1, 11.9], 0.02);
    let spoiler = smooth(5.4, 5.42, z) * smooth(11.2, 11.18, z);
    let lids = spoiler * smooth(0.60, 0.605, share) * smooth(0.73, 0.725, share);
    let lids = lids * cut(&[5.45, 6.85, 8.25, 9.65, 11.15], 0.02) + spoiler * across(0.605, 0.014);
    let hinge = across(0.73, 0.034) * smooth(14.3, 14.2, z);
    let flaps = smooth(0.73, 0.735, share) * cut(&[KINK, 11.3, 14.25], 0.03);
    let tab = across(0.87, 0.012) * smooth(11.25, 11.3, z) * smooth(14.3, 14.25, z);
    // The painted outline of the strip on which mechanics may walk.
    let walk = across(0.22, 0.02).max(across(0.56, 0.02)) * smooth(7.0, 6.98, z);
    let walk =
        walk.max(line(z - 7.0, 0.03) * smooth(0.215, 0.22, share) * smooth(0.565, 0.56, share));
    // A row of small fins that keep the air flow attached.
    let fins =
        line((fraction(z * 3.0) - 0.5) / 3.0, 0.02) * across(0.30, 0.10) * smooth(8.4, 8.5, z);
    let dark = 0.55 * slat.max(lids).max(tab) + 0.68 * hinge.max(flaps);
    dark.max(0.42 * walk)
        .max(0.4 * fins * smooth(13.6, 13.5, z))
        .min(0.75)
}

/// The factor by which soot and oil, smeared back by the wind, darken the skin.
fn dirt(x: f64, z: f64, share: f64) -> f64 {
    let streak = fractal(z * 7.0, x * 0.30, 4, 35, [0, 0]);
    let fine = fractal(z * 26.0, x * 0.55, 3, 37, [0, 0]);
    let behind = smooth(0.10, 0.9, share);
    let gap = bump(share - 0.80, 0.12).max(bump(share - 0.66, 0.07));
    let soot = smooth(0.50, 0.85, streak) * (0.16 * behind + 0.14 * gap)
        + smooth(0.55, 0.85, fine) * 0.12 * behind;
    1.0 - soot
}

/// The pods that carry the flap tracks, where they show behind the rear edge.
fn fairing(x: f64, z: f64) -> Option<Colour> {
    FAIRINGS.iter().find_map(|&place| {
        let middle = trailing(place) + 0.15;
        let distance = ellipse((x, z), (middle, place), (1.25, 0.19));
        (distance < 0.0).then(|| {
            let round = (z - place) / 0.19;
            let shadow = smooth(0.0, 0.3, trailing(z) - x);
            let tone = 0.68 + 0.18 * round.clamp(-1.0, 1.0) + 0.08 * shadow;
            Colour::hex(0xd4_d8_dc) * tone
        })
    })
}
