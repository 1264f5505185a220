//! Perceived difference of pictures: FLIP.

use std::f64::consts::PI;

use glam::DVec3;
use rayon::prelude::*;

use super::kernel::{Border, Kernel, Plane};
use super::lab::{Lab, intensity_of_value, xyz_of_rgb};
use crate::film::Film;

/// Pixels per degree of vision: a screen of 3840 pixels, seen from as far away as it is wide.
const PIXELS_PER_DEGREE: f64 = 67.0;

/// Colours of a picture as the eye blurs them, and its edges and points.
///
/// Two of them give FLIP by Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild
/// 2020, "FLIP: A Difference Evaluator for Alternating Images", with its constants for pictures of
/// limited brightness.
// Written out here, because the authors' library is built from C++.
#[derive(Debug, Clone)]
pub struct Appearance {
    colors: Vec<Lab>,
    /// Strength of edges and of points at each pixel.
    features: Vec<[f64; 2]>,
}

impl Appearance {
    /// Appearance of a picture as it is shown; its values are taken for sRGB, as screens do.
    #[must_use]
    pub fn of(film: &Film) -> Self {
        let (intensity, to_xyz) = (intensity_of_value(), xyz_of_rgb());
        let opponents = film.pixels().par_iter().map(|pixel| {
            let light = pixel.channels().map(&intensity);
            let DVec3 { x, y, z } = to_xyz * DVec3::from(light);
            [y, x - y, y - z]
        });
        let opponents: Vec<_> = opponents.collect();
        let planes = [0, 1, 2].map(|channel| Plane {
            values: opponents.iter().map(|values| values[channel]).collect(),
            width: film.width(),
        });
        Self {
            colors: colors(&planes),
            features: features(&planes[0]),
        }
    }

    /// Mean of the FLIP map of two pictures of the same size, from 0 (no visible difference) to 1.
    ///
    /// Symmetric; 0 for pictures without pixels.
    #[must_use]
    pub fn flip(&self, other: &Self) -> f64 {
        let largest = Lab::largest_difference();
        let colors = self.colors.par_iter().zip(&other.colors);
        let features = self.features.par_iter().zip(&other.features);
        let errors = colors.zip(features).map(|(colors, features)| {
            let error = color_error(colors.0.difference(*colors.1) / largest);
            power(error, 1.0 - feature_error(*features.0, *features.1))
        });
        // Summed in one order on any number of threads.
        let errors: Vec<_> = errors.collect();
        #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
        let count = errors.len().max(1) as f64;
        errors.iter().sum::<f64>() / count
    }
}

/// Colours from blurred brightness, red against green, and yellow against blue.
fn colors(opponents: &[Plane; 3]) -> Vec<Lab> {
    // Contrast sensitivity of each is a sum of Gaussians of the frequency, and so is the blur:
    // amplitude and square of the spread of each.
    const BRIGHT: &[[f64; 2]] = &[[1.0, 0.0047]];
    const RED_GREEN: &[[f64; 2]] = &[[1.0, 0.0053]];
    const YELLOW_BLUE: &[[f64; 2]] = &[[34.1, 0.04], [13.5, 0.025]];
    let [bright, red, yellow] = opponents;
    let bright = blurred(bright, BRIGHT);
    let red = blurred(red, RED_GREEN);
    let yellow = blurred(yellow, YELLOW_BLUE);
    let to_xyz = xyz_of_rgb();
    let to_rgb = to_xyz.inverse();
    let color = |at: usize| {
        let (x, y, z) = (bright[at] + red[at], bright[at], bright[at] - yellow[at]);
        let rgb = to_rgb * DVec3::new(x, y, z);
        Lab::of_xyz(to_xyz * rgb.clamp(DVec3::ZERO, DVec3::ONE))
    };
    (0..bright.len()).into_par_iter().map(color).collect()
}

/// Sum of Gaussian blurs of a plane.
fn blurred(plane: &Plane, gaussians: &[[f64; 2]]) -> Vec<f64> {
    /// Square of the largest spread; three standard deviations of it count.
    const WIDEST: f64 = 0.04;
    let reach = 3.0 * (WIDEST / 2.0).sqrt() / PI;
    let parts = gaussians.iter().map(|[amplitude, spread]| {
        let weights = weights(reach, |degrees| {
            libm::exp(-PI * PI * degrees * degrees / spread)
        });
        let sum: f64 = weights.iter().sum();
        let kernel = Kernel::new(&weights, Border::Same);
        let part = kernel.down(&kernel.across(plane)).values;
        (amplitude * (PI / spread).sqrt() * sum * sum, part)
    });
    let parts: Vec<_> = parts.collect();
    let all: f64 = parts.iter().map(|(amount, _)| amount).sum();
    let mut blurred = vec![0.0; plane.values.len()];
    for (amount, part) in &parts {
        for (sum, value) in blurred.iter_mut().zip(part) {
            *sum += amount / all * value;
        }
    }
    blurred
}

/// Strength of edges and points of brightness: its blurred first and second derivatives.
fn features(bright: &Plane) -> Vec<[f64; 2]> {
    /// Width of the edge detectors of the eye, in degrees.
    const WIDTH: f64 = 0.082;
    let deviation = WIDTH / 2.0;
    let gaussian = |x: f64| libm::exp(-x * x / 2.0);
    let kernel = |derivative: &dyn Fn(f64) -> f64| {
        let weights = weights(3.0 * deviation, |degrees| {
            let x = degrees / deviation;
            derivative(x) * gaussian(x)
        });
        Kernel::new(&weights, Border::Same)
    };
    let smooth = kernel(&|_| 1.0);
    let smoothed = smooth.across(bright);
    let strength = |derivative: &Kernel| {
        let across = smooth.down(&derivative.across(bright)).values;
        let down = derivative.down(&smoothed).values;
        let pairs = across.into_iter().zip(down);
        pairs.map(|(x, y)| (x * x + y * y).sqrt())
    };
    let edges = strength(&kernel(&|x| -x));
    let points = strength(&kernel(&|x| x * x - 1.0));
    edges.zip(points).map(<[f64; 2]>::from).collect()
}

/// Weights of pixels by their distances in degrees, up to a reach.
fn weights(reach: f64, weight: impl Fn(f64) -> f64) -> Vec<f64> {
    #[expect(clippy::cast_possible_truncation, reason = "some pixels")]
    let reach = (reach * PIXELS_PER_DEGREE).ceil() as i32;
    let pixels = -reach..=reach;
    let weights = pixels.map(|pixel| weight(f64::from(pixel) / PIXELS_PER_DEGREE));
    weights.collect()
}

/// Error of a colour difference, a share of the largest one: small differences count more.
fn color_error(share: f64) -> f64 {
    const EXPONENT: f64 = 0.7;
    /// Point where the compression of errors changes.
    const BEND: [f64; 2] = [0.4, 0.95];
    let share = power(share, EXPONENT).min(1.0);
    if share < BEND[0] {
        share * BEND[1] / BEND[0]
    } else {
        BEND[1] + (share - BEND[0]) / (1.0 - BEND[0]) * (1.0 - BEND[1])
    }
}

/// Error of different edges or points, from 0 to 1.
fn feature_error(features: [f64; 2], other: [f64; 2]) -> f64 {
    let [edge, point] = [0, 1].map(|kind| (features[kind] - other[kind]).abs());
    // The exponent is a half.
    (edge.max(point) / 2.0_f64.sqrt()).sqrt()
}

/// Power of a number from 0 on, within a few roundings; three times as fast as an exact one.
fn power(base: f64, exponent: f64) -> f64 {
    if base > 0.0 {
        libm::exp(exponent * libm::log(base))
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    fn picture(codes: impl Fn(u32, u32) -> [u32; 3]) -> Film {
        let mut film = Film::new(48, 40).expect("memory");
        let places = (0..40).flat_map(|y| (0..48).map(move |x| (x, y)));
        for (pixel, (x, y)) in film.pixels_mut().iter_mut().zip(places) {
            let [r, g, b] = codes(x, y).map(|code| f64::from(code) / 255.0);
            *pixel = Rgb::new(r, g, b);
        }
        film
    }

    fn flip(one: impl Fn(u32, u32) -> [u32; 3], other: impl Fn(u32, u32) -> [u32; 3]) -> f64 {
        let [one, other] = [picture(one), picture(other)].map(|film| Appearance::of(&film));
        let flip = one.flip(&other);
        assert_eq!(flip, other.flip(&one), "the same in both directions");
        assert_eq!(one.flip(&one), 0.0);
        assert!((0.0..=1.0).contains(&flip), "{flip}");
        flip
    }

    /// The authors' program has these means of its maps, as crate `nv-flip` 0.1.2 and as Python's
    /// `flip-evaluator` 1.7 at 67 pixels in a degree. It reckons with 32 bits and a slightly other white.
    #[test]
    fn the_program_of_the_authors_sees_the_same() {
        let edge = |at: u32| move |x: u32, y: u32| [if x + y / 3 > at { 255 } else { 20 }; 3];
        let lines = |x, y| [if x % 20 == 7 || y % 30 == 11 { 255 } else { 20 }; 3];
        let gradient = |x, y| [5 * x, 6 * y, 250 - 5 * x];
        let other_gradient = |x, y| [5 * x + 4, 6 * y, 240 - 5 * x];
        let squares = |by: u32| {
            move |x: u32, y: u32| match ((x + 2 * by) / 5 + (y + by) / 5) % 2 {
                0 => [0, 0, 255],
                _ => [255, 255, 0],
            }
        };
        let speck = |of: u32| 120 + of % 17;
        let red = |x, y| speck(7 * x * x + 13 * x * y);
        let grain = |x, y| [red(x, y), 128, speck(5 * x * y + 3 * y * y)];
        let flat = |color: [u32; 3]| move |_, _| color;
        let (rose, green) = (flat([200, 120, 120]), flat([120, 200, 120]));
        for (name, flip, expected) in [
            ("edge", flip(edge(24), edge(25)), 0.070_540_09),
            ("lines", flip(lines, flat([20; 3])), 0.375_803_82),
            ("gradient", flip(gradient, other_gradient), 0.143_015_25),
            ("squares", flip(squares(0), squares(1)), 0.678_178_22),
            ("grain", flip(flat([128; 3]), grain), 0.041_675_18),
            ("tints", flip(rose, green), 0.954_624_89),
            ("code", flip(flat([100; 3]), flat([101; 3])), 0.030_788_91),
            ("most", flip(flat([0, 255, 0]), flat([0, 0, 255])), 1.0),
        ] {
            assert!((flip - expected).abs() < 2e-5, "{name}: {flip}");
        }
    }

    #[test]
    fn what_is_cut_off_is_not_seen_and_without_pixels_nothing_is() {
        let [white, glaring] = [255, 999].map(|code| Appearance::of(&picture(|_, _| [code; 3])));
        assert_eq!(white.flip(&glaring), 0.0);
        let nothing = Appearance::of(&Film::new(0, 0).expect("memory"));
        assert_eq!(nothing.flip(&nothing), 0.0);
    }
}
