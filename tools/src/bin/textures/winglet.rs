//! Draws the upturned wing tip of the airliner in the colours of its airline.

use crate::colour::Colour;
use crate::shape::{Point, length, polygon, smooth};
use crate::vector::Vector;

/// The colour of the wing tip in a direction, if it is there; it stands at the distance `tip`,
/// and its foot is at the height `foot` against the eye.
pub(crate) fn winglet(ray: Vector, tip: f64, foot: f64) -> Option<Colour> {
    const LEAN: f64 = 0.22;
    const OUTLINE: [Point; 7] = [
        (1.0, 0.0),
        (0.42, 0.32),
        (-0.35, 1.15),
        (-0.92, 2.25),
        (-1.42, 2.28),
        (-1.2, 1.2),
        (-0.6, 0.0),
    ];
    let reach = (tip - LEAN * foot) / (ray.z - LEAN * ray.y);
    let (x, height) = (ray.x * reach, ray.y * reach - foot);
    if polygon((x, height), &OUTLINE) > 0.0 {
        return None;
    }
    let navy = Colour::hex(0x24_3f_7c);
    let stripe = Colour::hex(0xe8_9a_2c);
    let slant = height + 0.35 * x;
    let coat = Colour::hex(0xd6_da_de).mix(stripe, smooth(0.38, 0.40, slant));
    let coat = coat.mix(navy, smooth(0.52, 0.54, slant));
    // The airline's emblem is a small rising sun.
    let disc = length(x + 0.72, height - 1.30) - 0.20;
    let coat = coat.mix(Colour::hex(0xf6_cf_5c), smooth(0.015, -0.015, disc));
    // The fold at the foot turns from the wing's light to the upright side's.
    let tone = 0.70 + 0.16 * smooth(0.0, 0.35, height) + 0.14 * smooth(0.9, -1.3, x);
    Some(coat * tone)
}
