//! How far a picture is from what it should be.

use serde::Serialize;

use super::change::shown;
use super::{Appearance, Change, similarity};
use crate::film::Film;

/// How far a picture is from a reference of the same size; what is brighter than the largest code
/// value is shown as that, and compared as that.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Deviation {
    /// The largest error of a channel, and how many pixels are off by more than half a code value.
    #[serde(flatten)]
    pub change: Change,
    /// The root of the mean square of all channels' errors; 1 is the largest code value.
    pub rmse: f64,
    /// The peak signal-to-noise ratio in decibels; `None` if there is no error.
    pub psnr: Option<f64>,
    /// The mean structural similarity ([`similarity`]); 1 is the same.
    pub ssim: f64,
    /// How different the pictures look ([`Appearance::flip`]), from 0 to 1; 0 is the same.
    pub flip: f64,
}

impl Deviation {
    /// How far `picture` is from `reference`, of which an eye sees `appearance`.
    #[must_use]
    pub fn of(picture: &Film, reference: &Film, appearance: &Appearance) -> Self {
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

/// The root mean square of the differences of all channels; 1 is the largest code value.
pub(super) fn rmse(picture: &Film, reference: &Film) -> f64 {
    let pairs = picture.pixels().iter().zip(reference.pixels());
    let squares = pairs.map(|(picture, reference)| {
        let [picture, reference] = [picture, reference].map(|pixel| pixel.channels().map(shown));
        let channels = picture.iter().zip(&reference);
        channels.map(|(a, b)| (a - b) * (a - b)).sum::<f64>()
    });
    #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
    let count = (3 * picture.pixels().len()).max(1) as f64;
    (squares.sum::<f64>() / count).sqrt() / shown(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

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
