//! Draws the sky at cruising height: a blue gradient, thin veils and a sea of clouds below.

use crate::colour::Colour;
use crate::noise::{fractal, puffs};
use crate::shape::{length, smooth};
use crate::vector::{Vector, vector};

/// The direction towards the sun, which stands to the upper left.
pub(crate) const SUN: Vector = vector(-0.74, 0.52, 0.36);
/// How far the clouds reach below their highest tops; the eye is 1 above the tops.
const THICKNESS: f64 = 0.52;
/// The period of noise that never repeats.
const ENDLESS: [i64; 2] = [0, 0];
/// The number of steps with which a ray looks for the clouds.
const STEPS: u32 = 72;

/// The colour seen in a direction.
pub(crate) fn sky(direction: Vector) -> Colour {
    let ray = direction.unit();
    if ray.y >= 0.0 { air(ray) } else { sea(ray) }
}

/// The pale colour in which everything far away drowns, brighter towards the sun.
fn haze(ray: Vector) -> Colour {
    let flat = length(ray.x, ray.z).max(1e-9);
    let towards = (ray.x * SUN.x + ray.z * SUN.z) / (flat * length(SUN.x, SUN.z));
    Colour::hex(0xbc_d3_e6).mix(Colour::hex(0xf2_f0_e8), smooth(-0.2, 1.15, towards))
}

/// The sky above the horizon.
fn air(ray: Vector) -> Colour {
    let low = Colour::hex(0x86_b6_de);
    let high = Colour::hex(0x1e_5c_ae);
    let top = Colour::hex(0x0f_3c_86);
    let blue = low
        .mix(high, smooth(0.02, 0.26, ray.y))
        .mix(top, smooth(0.15, 0.50, ray.y));
    let blue = haze(ray).mix(blue, smooth(-0.015, 0.12, ray.y));
    // The sun itself stays outside; its glow still whitens the corner nearest to it.
    let glow = smooth(0.55, 1.0, ray.dot(SUN.unit()));
    let blue = blue.mix(Colour::hex(0xe8_f2_fa), 0.55 * glow);
    // Thin ice veils, drawn out in the wind; far above, so they crowd towards the horizon.
    let (x, z) = (ray.x / (ray.y + 0.05), ray.z / (ray.y + 0.05));
    let bend = fractal(x * 0.3, z * 0.3, 3, 70, ENDLESS) * 2.5;
    let veil = fractal(
        x * 0.35 + z * 0.2 + bend,
        z * 1.1 - x * 0.5 + bend,
        5,
        75,
        ENDLESS,
    );
    let veil = smooth(0.50, 0.85, veil) * smooth(0.0, 0.05, ray.y);
    blue.mix(Colour::hex(0xf4_f8_fc), 0.42 * veil)
}

/// The clouds below the horizon.
fn sea(ray: Vector) -> Colour {
    let near = 1.0 / -ray.y;
    let step = near * THICKNESS / f64::from(STEPS);
    let mut reach = near;
    for _ in 0..STEPS {
        if tops(ray.x * reach, ray.z * reach, false) > ray.y * reach {
            break;
        }
        reach += step;
    }
    // Halve the last step again and again to find where the ray met the cloud.
    let (mut before, mut after) = (reach - step, reach);
    for _ in 0..5 {
        let middle = f64::midpoint(before, after);
        if tops(ray.x * middle, ray.z * middle, false) > ray.y * middle {
            after = middle;
        } else {
            before = middle;
        }
    }
    let lit = light(ray.x * after, ray.z * after, after);
    lit.mix(
        haze(ray),
        smooth(2.5, 26.0, after) * 0.55 + smooth(0.075, 0.0, -ray.y) * 0.45,
    )
}

/// The height of the clouds' upper surface; `fine` adds the small curls.
fn tops(x: f64, z: f64, fine: bool) -> f64 {
    let broad = fractal(x * 0.33 + 3.1, z * 0.33 + 8.2, 3, 80, ENDLESS);
    let bend = |seed: u32| 0.30 * (fractal(x * 1.1, z * 1.1, 2, seed, ENDLESS) - 0.5);
    let (u, v) = (x + bend(85), z + bend(87));
    // Each heap is a round puff that carries smaller puffs.
    let heap = |scale: f64, seed: u32| {
        let distance = puffs(u * scale, v * scale, seed);
        1.0 - distance * distance
    };
    // Some stretches boil, others lie smooth under a veil.
    let boil = 0.30 + 0.70 * smooth(0.36, 0.58, fractal(x * 0.5 + 5.0, z * 0.5, 2, 96, ENDLESS));
    let swell = 1.45 * (broad - 0.40) + 0.30 * heap(0.62, 89);
    let mut height = swell + boil * (0.26 * heap(1.45, 90) + 0.13 * heap(3.3, 91));
    if fine {
        let wisps = fractal(u * 12.0, v * 12.0, 3, 97, ENDLESS) - 0.5;
        height += boil * (0.055 * heap(7.3, 92) + 0.024 * heap(17.0, 93)) + 0.030 * wisps;
    }
    // The tallest tops flatten gently, as under a lid of warm air.
    let over = (height - 0.7).max(0.0);
    let height = height.clamp(0.0, 0.7) + 0.3 * over / (over + 0.3);
    -1.0 - THICKNESS * (1.0 - height)
}

/// The sunlit colour of the cloud surface at a place, seen from a distance.
fn light(x: f64, z: f64, distance: f64) -> Colour {
    // Finer slopes than a pixel would only sparkle.
    let span = (0.0035 * distance).max(0.006);
    let here = tops(x, z, true);
    let slope_x = (tops(x + span, z, true) - here) / span;
    let slope_z = (tops(x, z + span, true) - here) / span;
    let normal = vector(-slope_x, 1.0, -slope_z).unit();
    let facing = normal.dot(SUN.unit());
    // Walk towards the sun: cloud that stands above the walk throws soft shade.
    let mut hidden: f64 = 0.0;
    for index in 1..=9 {
        let walk = 0.035 * f64::from(index);
        let above = tops(x + SUN.x * walk, z + SUN.z * walk, false) - (here + SUN.y * walk);
        hidden = hidden.max(above / (0.02 + 0.22 * walk));
    }
    let open = 1.0 - 0.8 * smooth(-0.1, 1.0, hidden);
    let depth = smooth(-1.0 - THICKNESS, -1.02, here);
    let shade = Colour::hex(0x6c_8a_b6).mix(Colour::hex(0xaa_bd_d8), depth);
    let bright = Colour::hex(0xff_fb_f2);
    // Light wanders inside a cloud, so its shaded side never turns dark.
    let sunny = (0.10 + 0.90 * smooth(-0.25, 1.0, facing)) * open;
    shade.mix(bright, sunny * (0.5 + 0.5 * depth))
}
