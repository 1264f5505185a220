//! Colours the sitter of the portrait: skin, lips, brows, eyes, hair and clothes.

use crate::angle::{direction, sine};
use crate::bust::{Part, head};
use crate::colour::Colour;
use crate::face::{EYE, OPENING, lid_gap};
use crate::hair::strands;
use crate::noise::fractal_space;
use crate::shape::{bump, length, smooth};
use crate::vector::{Vector, vector};

/// The colours of a material in full light, in half light and in shade.
pub(crate) type Ramp = [Colour; 3];

/// Three hexadecimal colours as a ramp.
fn ramp(light: u32, half: u32, shade: u32) -> Ramp {
    [Colour::hex(light), Colour::hex(half), Colour::hex(shade)]
}

/// Blends two ramps step by step.
fn blend(a: Ramp, b: Ramp, share: f64) -> Ramp {
    [0, 1, 2].map(|step| a[step].mix(b[step], share))
}

/// The paint for a point on a part of the sitter.
pub(crate) fn paint(part: Part, p: Vector) -> Ramp {
    let h = head(p);
    match part {
        Part::Skin => skin(h),
        Part::Eye => eye(h),
        Part::Hair => {
            let lock = smooth(0.34, 0.66, strands(h));
            let dark = ramp(0x8a_42_1c, 0x50_22_10, 0x20_0f_0a);
            blend(dark, ramp(0xe2_92_4a, 0x9c_4c_1e, 0x3c_1a_0e), lock)
        }
        Part::Dress => ramp(0x3c_7c_74, 0x1c_4c_4c, 0x0c_20_26),
        Part::Collar => ramp(0xfa_f2_de, 0xc8_b8_9c, 0x6c_5c_54),
        Part::Gold => ramp(0xff_e2_8a, 0xc8_8c_2c, 0x5a_34_10),
    }
}

/// Skin with rosy cheeks, red lips, brows, lashes and lid creases, in head coordinates.
fn skin(h: Vector) -> Ramp {
    let f = h.folded();
    let bare = ramp(0xfc_dc_bc, 0xd8_96_72, 0x6a_34_28);
    let warm = ramp(0xf8_b4_98, 0xc8_6c_54, 0x64_2a_22);
    let front = smooth(0.1, 0.3, h.z);
    let mottle = fractal_space([h.x * 4.0, h.y * 4.0, h.z * 4.0], 2, 80) - 0.5;
    let cheek = smooth(0.34, 0.0, length(f.x - 0.40, 1.15 * (h.y + 0.27)));
    let nose = smooth(0.20, 0.0, length(h.x, h.y + 0.29)) * smooth(0.85, 1.0, h.z);
    let chin = smooth(0.26, 0.0, length(h.x, h.y + 0.98));
    let rose = 0.62 * cheek + 0.42 * nose + 0.22 * chin + 0.18 * mottle;
    let mut paint = blend(bare, warm, rose * front);
    // The hollows around the eyes are a little darker.
    let hollow = smooth(0.26, 0.08, length(f.x - EYE.x, 1.3 * (h.y - EYE.y - 0.03)));
    paint = blend(
        paint,
        ramp(0xe4_b0_90, 0xa8_68_50, 0x4e_26_20),
        0.55 * hollow * front,
    );
    let (lip, seam) = mouth(f);
    paint = blend(
        paint,
        ramp(0xda_6a_60, 0xa8_3a_3a, 0x58_1c_1e),
        0.92 * lip * front,
    );
    paint = blend(
        paint,
        ramp(0x6c_22_20, 0x54_18_18, 0x34_0e_10),
        0.9 * seam * front,
    );
    let dark = ramp(0x4c_28_18, 0x38_1c_10, 0x20_10_0a);
    paint = blend(paint, dark, 0.82 * brow(f) * front);
    blend(
        paint,
        ramp(0x2c_16_0e, 0x22_10_0a, 0x18_0a_08),
        lashes(f) * front,
    )
}

/// How much a point belongs to the lips, and to the line between them.
fn mouth(f: Vector) -> (f64, f64) {
    let across = f.x / 0.262;
    let square = across * across;
    let top = -0.526 - 0.030 * square - 0.016 * bump(f.x, 0.045);
    let bottom = -0.702 + 0.146 * square;
    let line = -0.605 + 0.052 * square - 0.008 * bump(f.x, 0.05);
    let inside = (top - f.y).min(f.y - bottom);
    let lip = smooth(-0.004, 0.016, inside) * smooth(1.02, 0.92, across);
    (
        lip,
        smooth(0.017, 0.004, (f.y - line).abs()) * smooth(1.08, 0.85, across),
    )
}

/// How much a point belongs to an eyebrow.
fn brow(f: Vector) -> f64 {
    let out = f.x - 0.35;
    let away = (f.y - 0.335 + 1.35 * out * out).abs();
    let width = 0.040 * smooth(0.60, 0.22, f.x) + 0.006;
    smooth(width, 0.15 * width, away) * smooth(0.12, 0.19, f.x) * smooth(0.57, 0.52, f.x)
}

/// How much a point belongs to the lashes or the crease of the upper lid.
fn lashes(f: Vector) -> f64 {
    let gap = lid_gap(f);
    let above = smooth(EYE.y - 0.05, EYE.y + 0.02, f.y);
    let rim = smooth(0.028, 0.010, gap.abs()) * (0.10 + 0.75 * above);
    let outer = smooth(0.0, 0.16, f.x - EYE.x);
    let wing = smooth(0.014 + 0.014 * outer, 0.004, (gap - 0.012).abs()) * above;
    let crease =
        0.5 * smooth(0.020, 0.004, (gap - 0.066).abs()) * smooth(EYE.y + 0.02, EYE.y + 0.07, f.y);
    rim.max(wing).max(crease)
}

/// The white, the iris and the pupil of an eye that looks at the viewer.
fn eye(h: Vector) -> Ramp {
    let centre = if h.x < 0.0 {
        vector(-EYE.x, EYE.y, EYE.z)
    } else {
        EYE
    };
    let look = (h - centre).unit();
    // The viewer stands where z points before the head was turned.
    let gaze = head(vector(if h.x < 0.0 { -0.13 } else { 0.0 }, -0.03, 1.0)).unit();
    let away = (look - gaze).length();
    let white = ramp(0xf4_ec_e2, 0xc4_b0_a6, 0x60_48_44);
    let iris = ramp(0x7c_b0_6c, 0x4a_80_58, 0x24_3c_30);
    let rim = ramp(0x1c_34_2c, 0x14_26_22, 0x0c_14_14);
    let pupil = ramp(0x12_0c_0c, 0x0c_08_08, 0x08_06_06);
    let ray = 0.5 + 0.5 * sine(19.0 * direction(look.x - gaze.x, look.y - gaze.y));
    let mut paint = blend(white, rim, smooth(0.50, 0.46, away));
    paint = blend(
        paint,
        blend(iris, rim, 0.25 * ray),
        smooth(0.44, 0.38, away),
    );
    paint = blend(paint, pupil, smooth(0.22, 0.18, away));
    // The lid throws a shadow over the upper part of the ball.
    let lid = smooth(0.25, 1.0, (h.y - EYE.y) / OPENING.1);
    paint = blend(paint, pupil, 0.55 * lid);
    let glint = (look - (gaze + vector(-0.14, 0.17, 0.0)).unit()).length();
    let spark = [Colour::WHITE; 3];
    blend(paint, spark, smooth(0.115, 0.07, glint))
}
