//! Models the wavy hair of the portrait's sitter, in head coordinates.

use crate::angle::{direction, sine};
use crate::noise::fractal_space;
use crate::shape::smooth;
use crate::solid::{ball, carve, cone, join};
use crate::vector::{Vector, vector};

/// Where the hair parts, in head coordinates as seen from the front.
const PARTING: (f64, f64) = (0.22, 1.46);

/// A wavy bob with a side parting.
pub(crate) fn hair(h: Vector) -> f64 {
    let f = h.folded();
    let cap = ball(h, vector(0.0, 0.38, -0.20), vector(0.90, 1.00, 1.04));
    let opening = ball(h, vector(0.05, -0.30, 0.98), vector(0.66, 1.06, 0.80));
    let fall = ball(f, vector(0.70, -0.42, -0.16), vector(0.27, 0.90, 0.50));
    let nape = ball(h, vector(0.0, -0.35, -0.55), vector(0.75, 0.85, 0.50));
    let crown = carve(cap, opening, 0.10);
    // Two locks sweep from the parting over the forehead to the temples.
    let long = cone(
        h,
        vector(0.30, 1.14, 0.50),
        vector(-0.61, 0.60, 0.47),
        0.17,
        0.14,
    );
    let long = join(
        long,
        cone(
            h,
            vector(-0.61, 0.60, 0.47),
            vector(-0.76, -0.05, 0.30),
            0.14,
            0.14,
        ),
        0.20,
    );
    let short = cone(
        h,
        vector(0.34, 1.08, 0.50),
        vector(0.68, 0.62, 0.40),
        0.15,
        0.15,
    );
    let short = join(
        short,
        cone(
            h,
            vector(0.68, 0.62, 0.40),
            vector(0.77, -0.05, 0.25),
            0.15,
            0.13,
        ),
        0.12,
    );
    let whole = join(join(crown, fall, 0.16), nape, 0.2);
    let whole = join(join(whole, long, 0.10), short, 0.10);
    let wave = 0.035 * sine(h.y * 6.5 + 2.0 * h.x) * smooth(0.6, -0.4, h.y);
    whole + wave - 0.075 * (strands(h) - 0.5)
}

/// The strands of the hair, from 0 in a furrow to 1 on a lock.
pub(crate) fn strands(h: Vector) -> f64 {
    let (x, y) = (h.x - PARTING.0, h.y - PARTING.1);
    let turn = direction(-y, x);
    let away = (x * x + y * y).sqrt();
    let wave = 0.10 * sine(away * 4.5 + h.z * 2.0);
    fractal_space([(turn + wave) * 10.0, away * 0.8, h.z * 3.2], 4, 70)
}
