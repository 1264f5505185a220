//! Difference of two pictures, channel by channel.

use serde::Serialize;

use super::{Appearance, similarity};
use crate::film::Film;

/// Largest code value of 8 bits.
const LARGEST_CODE: f64 = 255.0;

/// Change from one picture to another, in code values of 8 bits before rounding.
///
/// Intensities outside of 0 to 1 are compared as they are shown: limited to that range.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Change {
    /// Share of the pixels of which a channel differs by more than half a code value.
    pub pixels: f64,
    /// Largest difference of a channel, in code values.
    pub largest: f64,
}

/// Difference of a picture from a reference of the same size.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Deviation {
    /// Largest error, and share of the pixels off by more than half a code value.
    #[serde(flatten)]
    pub change: Change,
    /// Root mean square error of all channels; 1 is the largest code value.
    pub rmse: f64,
    /// Peak signal-to-noise ratio in decibels; `None` without error.
    pub psnr: Option<f64>,
    /// Mean structural similarity ([`similarity`]); 1 for equal pictures.
    pub ssim: f64,
    /// Perceived difference ([`Appearance::flip`]), from 0 (none) to 1.
    pub flip: f64,
}

impl Change {
    /// Compares two pictures of the same size.
    #[must_use]
    pub fn between(before: &Film, after: &Film) -> Self {
        Self {
            pixels: share(before, after, |error| error > 0.5),
            largest: largest_errors(before, after).fold(0.0, f64::max),
        }
    }
}

impl Deviation {
    /// Compares `picture` with `reference`, whose appearance is known already.
    #[must_use]
    pub(super) fn of(picture: &Film, reference: &Film, appearance: &Appearance) -> Self {
        let rmse = rmse(picture, reference);
        Self {
            change: Change::between(reference, picture),
            rmse,
            psnr: (rmse > 0.0).then(|| -20.0 * libm::log10(rmse)),
            ssim: similarity(picture, reference),
            flip: Appearance::of(picture).flip(appearance),
        }
    }
}

/// Share of the pixels that differ by at most `limit`, where 1 is the largest code value.
pub(super) fn share_within(before: &Film, after: &Film, limit: f64) -> f64 {
    let codes = LARGEST_CODE * limit;
    share(before, after, |error| error <= codes)
}

/// Share of the pixels whose largest error satisfies a condition; zero without pixels.
fn share(before: &Film, after: &Film, counts: impl Fn(f64) -> bool) -> f64 {
    let [mut counted, mut all] = [0.0, 0.0];
    for error in largest_errors(before, after) {
        counted += f64::from(counts(error));
        all += 1.0;
    }
    counted / f64::max(all, 1.0)
}

/// Root mean square difference of all channels; 1 is the largest code value.
pub(super) fn rmse(picture: &Film, reference: &Film) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
    let count = (3 * picture.pixels().len()).max(1) as f64;
    let sum: f64 = squared_errors(picture, reference).sum();
    (sum / count).sqrt() / LARGEST_CODE
}

/// Largest channel difference of each pixel, in code values.
pub(super) fn largest_errors(one: &Film, other: &Film) -> impl Iterator<Item = f64> {
    errors(one, other).map(|channels| channels.into_iter().fold(0.0, f64::max))
}

/// Sum of the squared channel differences of each pixel, in code values squared.
pub(super) fn squared_errors(one: &Film, other: &Film) -> impl Iterator<Item = f64> {
    errors(one, other).map(|channels| channels.iter().map(|error| error * error).sum())
}

/// Absolute channel differences of each pixel, in code values.
fn errors(one: &Film, other: &Film) -> impl Iterator<Item = [f64; 3]> {
    let shown = |intensity: f64| LARGEST_CODE * intensity.clamp(0.0, 1.0);
    let pairs = one.pixels().iter().zip(other.pixels());
    pairs.map(move |(one, other)| {
        let [one, other] = [one, other].map(|pixel| pixel.channels().map(shown));
        [0, 1, 2].map(|channel| f64::abs(one[channel] - other[channel]))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    #[test]
    fn what_cannot_be_seen_is_no_change() {
        let mut before = Film::new(4, 1).expect("memory");
        let mut after = before.clone();
        let code = |code: f64| Rgb::new(0.0, code / 255.0, 0.0);
        let pixels = [[9.0, 9.5], [9.0, 9.501], [0.0, 40.0], [300.0, 400.0]];
        for (index, [from, to]) in pixels.into_iter().enumerate() {
            before.pixels_mut()[index] = code(from);
            after.pixels_mut()[index] = code(to);
        }
        let change = Change::between(&before, &after);
        assert_eq!(change.pixels, 0.5);
        assert!((change.largest - 40.0).abs() < 1e-9, "{change:?}");
        for (codes, share) in [(0.0, 0.25), (0.5001, 0.5), (39.0, 0.75), (41.0, 1.0)] {
            assert_eq!(share_within(&before, &after, codes / 255.0), share);
        }
    }

    #[test]
    fn one_wrong_channel_of_four_pixels() {
        let reference = Film::new(2, 2).expect("memory");
        let mut picture = reference.clone();
        picture.pixels_mut()[1] = Rgb::new(0.0, 0.6, 0.0);
        let deviation = Deviation::of(&picture, &reference, &Appearance::of(&reference));
        assert!((deviation.rmse - (0.36_f64 / 12.0).sqrt()).abs() < 1e-12);
        assert!((deviation.psnr.expect("an error") - 15.228_787).abs() < 1e-5);
        assert!((deviation.change.largest - 153.0).abs() < 1e-9);
        assert_eq!(deviation.change.pixels, 0.25);
        assert!(deviation.ssim < 0.9, "{deviation:?}");
        assert!(deviation.flip > 0.1, "{deviation:?}");
    }

    #[test]
    fn no_error_has_no_signal_to_noise_ratio() {
        let film = Film::new(3, 2).expect("memory");
        let deviation = Deviation::of(&film, &film, &Appearance::of(&film));
        assert_eq!((deviation.rmse, deviation.psnr), (0.0, None));
        assert_eq!(deviation.flip, 0.0);
        assert!((deviation.ssim - 1.0).abs() < 1e-12);
    }
}
