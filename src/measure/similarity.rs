//! Structural similarity of pictures: SSIM.

use super::kernel::{Border, Kernel, Plane};
use crate::film::Film;
use crate::math::Rgb;

/// Gaussian window of 11 pixels with a standard deviation of 1.5; its weights add up to 1.
const WINDOW: [f64; 11] = [
    0.001_028_380_1,
    0.007_598_758_1,
    0.036_000_772_1,
    0.109_360_689_5,
    0.213_005_537_7,
    0.266_011_724_9,
    0.213_005_537_7,
    0.109_360_689_5,
    0.036_000_772_1,
    0.007_598_758_1,
    0.001_028_380_1,
];

/// Mean structural similarity of two pictures of the same size, from −1 to 1 (equal).
///
/// The formula of Wang, Bovik, Sheikh and Simoncelli 2004, "Image quality assessment: from error
/// visibility to structural similarity", with their window and constants, on luma by Rec. 601; at
/// borders on the part of the window that is inside. 1 for pictures without pixels.
// Written out here, because libraries compare rounded code values or square blocks.
#[must_use]
pub fn similarity(one: &Film, other: &Film) -> f64 {
    const STABILIZERS: [f64; 2] = [0.01 * 0.01, 0.03 * 0.03];
    let window = Kernel::new(&WINDOW, Border::Zero);
    let sums = |values| {
        let width = one.width();
        window.down(&window.across(&Plane { values, width })).values
    };
    let [x, y] = [one, other].map(lumas);
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).collect();
    let squares = [product(&x, &x), product(&y, &y), product(&x, &y)];
    let [xx, yy, xy] = squares.map(sums);
    let inside = sums(vec![1.0; x.len()]);
    let [x, y] = [x, y].map(sums);
    let mut sum = 0.0;
    for (at, inside) in inside.iter().enumerate() {
        let mean = |sums: &[f64]| sums[at] / inside;
        let (mean_x, mean_y) = (mean(&x), mean(&y));
        let [spread_x, spread_y, together] = [
            mean(&xx) - mean_x * mean_x,
            mean(&yy) - mean_y * mean_y,
            mean(&xy) - mean_x * mean_y,
        ];
        let [light, contrast] = STABILIZERS;
        sum += (2.0 * mean_x * mean_y + light) * (2.0 * together + contrast)
            / ((mean_x * mean_x + mean_y * mean_y + light) * (spread_x + spread_y + contrast));
    }
    #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
    let count = x.len() as f64;
    if x.is_empty() { 1.0 } else { sum / count }
}

/// Luma of each pixel as it is shown, from 0 to 1.
fn lumas(film: &Film) -> Vec<f64> {
    let luma = |pixel: &Rgb| {
        let [r, g, b] = pixel.channels().map(|channel| channel.clamp(0.0, 1.0));
        0.299 * r + 0.587 * g + 0.114 * b
    };
    film.pixels().iter().map(luma).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn film(width: usize, height: usize, luma: impl Fn(usize, usize) -> f64) -> Film {
        let mut film = Film::new(width, height).expect("memory");
        for (at, pixel) in film.pixels_mut().iter_mut().enumerate() {
            let luma = luma(at % width, at / width);
            *pixel = Rgb::new(luma, luma, luma);
        }
        film
    }

    #[test]
    fn flat_pictures_differ_by_their_means_alone() {
        let [dark, bright] = [0.2, 0.6].map(|luma| film(20, 9, |_, _| luma));
        let expected = (2.0 * 0.2 * 0.6 + 0.0001) / (0.2 * 0.2 + 0.6 * 0.6 + 0.0001);
        assert!((similarity(&dark, &bright) - expected).abs() < 1e-6);
        assert!((similarity(&dark, &dark) - 1.0).abs() < 1e-12);
        assert_eq!(
            similarity(&film(0, 0, |_, _| 0.0), &film(0, 0, |_, _| 0.0)),
            1.0
        );
    }

    #[test]
    fn a_pattern_is_unlike_its_negative_and_what_is_cut_off_is_not_seen() {
        let stripes = film(24, 24, |column, _| f64::from(u8::from(column % 4 < 2)));
        let negative = film(24, 24, |column, _| f64::from(u8::from(column % 4 >= 2)));
        assert!(similarity(&stripes, &negative) < -0.9);
        let glaring = film(24, 24, |column, _| {
            7.0 * f64::from(u8::from(column % 4 < 2))
        });
        assert!((similarity(&stripes, &glaring) - 1.0).abs() < 1e-12);
    }
}
