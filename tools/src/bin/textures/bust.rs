//! Models the sitter of the portrait in space, as distances to smoothly joined round forms.

use crate::angle::{direction, sine};
use crate::face::{eyeball, face};
use crate::hair::hair;
use crate::noise::fractal_space;
use crate::solid::{ball, carve, cone, join};
use crate::vector::{Vector, vector};

/// What a point of the sitter's surface is made of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Part {
    /// Face, neck and chest.
    Skin,
    /// One of the eyeballs.
    Eye,
    /// The auburn hair.
    Hair,
    /// The dark green dress.
    Dress,
    /// The white collar.
    Collar,
    /// The golden brooch.
    Gold,
}

/// By how much the shoulders are raised.
const LIFT: f64 = 0.16;
/// Sine and cosine of the head's turn towards the light, and of its tilt.
const TURN: (f64, f64) = (0.40, 0.916_5);
const TILT: (f64, f64) = (0.087, 0.996_2);

/// Turns a point of the picture's space into the head's own, in which the face looks along z.
pub(crate) fn head(p: Vector) -> Vector {
    let (x, z) = (p.x * TURN.1 + p.z * TURN.0, p.z * TURN.1 - p.x * TURN.0);
    let (x, y) = (x * TILT.1 + p.y * TILT.0, p.y * TILT.1 - x * TILT.0);
    vector(x, y, z)
}

/// The distance to the nearest part of the sitter, and which part that is.
pub(crate) fn sitter(p: Vector) -> (f64, Part) {
    let h = head(p);
    let neck = cone(
        p,
        vector(0.05, -0.5, -0.16),
        vector(0.08, -2.0, -0.3),
        0.29,
        0.33,
    );
    // The shoulders stand a little higher than modelled, which shortens the neck.
    let body = p - vector(0.0, LIFT, 0.0);
    let torso = torso(body);
    let skin = join(join(face(h), neck, 0.14), torso + 0.05, 0.22);
    let neckline = ball(body, vector(0.03, -1.62, 0.22), vector(0.74, 0.66, 0.72));
    let dress = carve(torso + 0.045 * folds(body), neckline, 0.03);
    // The collar is a band of the dress's surface around the neckline, slightly raised.
    let ruffle = 0.02 * sine(22.0 * direction(body.x, body.y + 1.2));
    let collar = (torso - 0.055 - ruffle).max((neckline - 0.12).abs() - 0.125);
    let brooch = ball(body, vector(-0.02, -2.36, 0.40), vector(0.085, 0.085, 0.07));
    let candidates = [
        (skin, Part::Skin),
        (eyeball(h), Part::Eye),
        (hair(h), Part::Hair),
        (dress, Part::Dress),
        (collar, Part::Collar),
        (brooch, Part::Gold),
    ];
    candidates
        .into_iter()
        .fold((f64::INFINITY, Part::Skin), |best, next| {
            if next.0 < best.0 { next } else { best }
        })
}

/// The folds of the dress, which hang from the shoulders.
fn folds(p: Vector) -> f64 {
    fractal_space([p.x * 4.5, p.y * 0.9 + p.x.abs() * 1.1, p.z * 2.0], 2, 60) - 0.5
}

/// Shoulders and chest.
fn torso(p: Vector) -> f64 {
    let chest = ball(p, vector(0.05, -2.95, -0.30), vector(1.35, 1.25, 0.72));
    let f = vector((p.x - 0.05).abs(), p.y, p.z);
    let shoulder = cone(
        f,
        vector(0.25, -1.92, -0.32),
        vector(1.28, -2.32, -0.36),
        0.30,
        0.36,
    );
    let arm = cone(
        f,
        vector(1.28, -2.32, -0.36),
        vector(1.55, -3.6, -0.25),
        0.36,
        0.36,
    );
    join(join(chest, shoulder, 0.30), arm, 0.12)
}
