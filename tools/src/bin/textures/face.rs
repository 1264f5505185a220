//! Models the face of the portrait's sitter, in head coordinates: z points out of the face.

use crate::shape::ellipse;
use crate::solid::{ball, carve, cone, join};
use crate::vector::{Vector, vector};

/// The middle of the eyeball on the positive side.
pub(crate) const EYE: Vector = vector(0.295, 0.02, 0.60);
/// Half the width and height of the opening between the lids.
pub(crate) const OPENING: (f64, f64) = (0.163, 0.082);
/// The face with the lids, without the eyeballs, in head coordinates.
pub(crate) fn face(h: Vector) -> f64 {
    let f = h.folded();
    let skull = ball(h, vector(0.0, 0.36, -0.15), vector(0.78, 0.90, 0.95));
    let mask = ball(h, vector(0.0, -0.13, 0.12), vector(0.605, 0.92, 0.72));
    let chin = ball(h, vector(0.0, -0.98, 0.47), vector(0.17, 0.14, 0.18));
    let cheek = ball(f, vector(0.36, -0.27, 0.50), vector(0.22, 0.20, 0.20));
    let jaw = cone(
        f,
        vector(0.42, -0.44, 0.05),
        vector(0.07, -0.96, 0.46),
        0.10,
        0.10,
    );
    let brow = cone(
        f,
        vector(0.16, 0.22, 0.76),
        vector(0.44, 0.23, 0.60),
        0.05,
        0.07,
    );
    let mut skin = join(skull, mask, 0.22);
    skin = join(skin, chin, 0.26);
    skin = join(skin, cheek, 0.22);
    skin = join(skin, jaw, 0.20);
    skin = join(skin, brow, 0.14);
    skin = carve(
        skin,
        ball(f, vector(0.29, 0.03, 0.86), vector(0.19, 0.11, 0.14)),
        0.13,
    );
    skin = join(skin, nose(h, f), 0.07);
    skin = join(skin, lips(f), 0.045);
    let ear = ball(f, vector(0.78, -0.10, -0.02), vector(0.08, 0.22, 0.14));
    skin = join(skin, ear, 0.05);
    // The lids are a ball around the eye with an almond cut out for the view.
    let opening = lid_gap(f);
    let lid = ball(f, EYE, vector(0.192, 0.192, 0.192)).max(-opening);
    let lined = carve(skin, opening.max(0.5 - f.z), 0.02);
    join(lined, lid, 0.03)
}

/// The signed distance to the almond between the lids, seen from the front.
pub(crate) fn lid_gap(f: Vector) -> f64 {
    // The outer corner lies a little higher than the inner one.
    let y = f.y - EYE.y - 0.10 * (f.x - EYE.x);
    let flat = if y > 0.0 { y } else { y * 1.35 };
    ellipse((f.x - EYE.x, flat), (0.0, 0.0), OPENING)
}

/// The nose with its wings and nostrils.
fn nose(h: Vector, f: Vector) -> f64 {
    let bridge = cone(
        h,
        vector(0.0, 0.16, 0.76),
        vector(0.0, -0.25, 0.985),
        0.055,
        0.075,
    );
    let tip = ball(h, vector(0.0, -0.285, 0.985), vector(0.088, 0.075, 0.085));
    let side = ball(f, vector(0.098, -0.325, 0.86), vector(0.065, 0.058, 0.085));
    let nostril = ball(f, vector(0.055, -0.375, 0.93), vector(0.032, 0.022, 0.045));
    carve(join(join(bridge, tip, 0.06), side, 0.05), nostril, 0.02)
}

/// Both lips, up to their corners.
fn lips(f: Vector) -> f64 {
    let upper = cone(
        f,
        vector(0.035, -0.560, 0.80),
        vector(0.240, -0.560, 0.65),
        0.042,
        0.018,
    );
    let lower = cone(
        f,
        vector(0.0, -0.652, 0.785),
        vector(0.155, -0.622, 0.71),
        0.052,
        0.028,
    );
    carve(
        join(upper, lower, 0.02),
        cone(
            f,
            vector(0.0, -0.605, 0.865),
            vector(0.25, -0.548, 0.69),
            0.012,
            0.012,
        ),
        0.02,
    )
}

/// The eyeball on either side.
pub(crate) fn eyeball(h: Vector) -> f64 {
    (h.folded() - EYE).length() - 0.168
}
