//! Draws an invented planet with seas, land, ice caps and clouds, as a map of the whole globe.

use crate::angle::{cosine, sine};
use crate::canvas::{Canvas, as_float};
use crate::colour::Colour;
use crate::noise::fractal_space;
use crate::shape::smooth;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The width of the map in pixels; the height is half of it.
const WIDTH: usize = 512;
/// The noise level at which land rises from the sea.
const SHORE: f64 = 0.53;

/// Draws the picture: the north pole along the top row, the equator in the middle.
pub(crate) fn draw() -> Canvas {
    let scale = PI / as_float(WIDTH / 2);
    Canvas::paint(WIDTH, WIDTH / 2, 3, |x, y| {
        let longitude = x / as_float(WIDTH) * TAU;
        let latitude = FRAC_PI_2 - y * scale;
        let ring = cosine(latitude);
        shade([
            ring * cosine(longitude),
            sine(latitude),
            ring * sine(longitude),
        ])
    })
}

/// The colour at a point of the unit sphere; noise in space has no seam on it.
fn shade(point: [f64; 3]) -> Colour {
    let scaled = |factor: f64, shift: f64| point.map(|part| part * factor + shift);
    let bend = |seed: u32| fractal_space(scaled(2.1, 9.0), 3, seed) - 0.5;
    let warp = [bend(1), bend(2), bend(3)];
    let place = [0, 1, 2].map(|axis| point[axis] * 1.55 + warp[axis] * 1.3 + 4.7);
    let height =
        fractal_space(place, 7, 10) + 0.10 * (fractal_space(scaled(9.0, 2.0), 4, 20) - 0.5);
    let cold = point[1].abs() + 0.16 * (fractal_space(scaled(5.0, 3.0), 4, 30) - 0.5);
    let mut colour = if height < SHORE {
        sea(height)
    } else {
        land(height, cold, scaled(3.5, 1.0))
    };
    colour = colour.mix(Colour::hex(0xee_f4_f8), smooth(0.92, 0.95, cold));
    // Clouds are drawn out along the parallels, as winds do.
    let wind = [0, 1, 2].map(|axis| {
        let stretch = if axis == 1 { 5.2 } else { 2.6 };
        point[axis] * stretch + 1.6 * warp[(axis + 1) % 3] + 20.0
    });
    let cloud = smooth(0.52, 0.74, fractal_space(wind, 6, 50));
    colour.mix(Colour::hex(0xfa_fb_fd), 0.92 * cloud)
}

/// Water, paler and greener where it is shallow.
fn sea(height: f64) -> Colour {
    let depth = smooth(SHORE, SHORE - 0.13, height);
    let shallow = Colour::hex(0x3f_a6_b4).mix(Colour::hex(0x1c_68_a2), smooth(0.0, 0.25, depth));
    shallow.mix(Colour::hex(0x0c_32_6e), smooth(0.15, 1.0, depth))
}

/// Ground: green lowland, ochre deserts away from the poles, brown and white mountains.
fn land(height: f64, cold: f64, place: [f64; 3]) -> Colour {
    let rise = (height - SHORE) / 0.20;
    let dry = smooth(0.42, 0.62, fractal_space(place, 4, 40)) * smooth(0.75, 0.35, cold);
    let green = Colour::hex(0x3d_7a_34).mix(Colour::hex(0x24_5a_2c), smooth(0.0, 0.4, cold));
    let low = green.mix(Colour::hex(0xcb_a9_66), dry);
    let low = low.mix(Colour::hex(0x7d_82_62), smooth(0.70, 0.90, cold));
    let beach = Colour::hex(0xd8_c8_92);
    let ground = beach.mix(low, smooth(0.0, 0.07, rise));
    let ground = ground.mix(Colour::hex(0x7c_60_42), smooth(0.40, 0.75, rise));
    ground.mix(
        Colour::hex(0xf2_f2_f0),
        smooth(1.02, 1.3, rise + 0.35 * cold),
    )
}
