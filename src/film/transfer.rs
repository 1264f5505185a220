//! From intensities to the values that code values stand for.

use crate::language::words;
use crate::math::exact::{Exact, Sign};

/// The curve between an intensity and the value that its code value is a share of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Transfer {
    /// The value is the intensity, as in the chapter.
    #[default]
    None,
    /// The curve that screens expect (IEC 61966-2-1:1999): dark intensities get more of the code values.
    Srgb,
}

words!(Transfer {
    None: "none",
    Srgb: "srgb",
});

impl Transfer {
    /// The value of an intensity, right but for a few roundings: 0 for 0, and 1 for 1.
    #[must_use]
    pub fn value(self, intensity: f64) -> f64 {
        match self {
            Self::None => intensity,
            Self::Srgb if intensity <= 0.003_130_8 => 12.92 * intensity,
            Self::Srgb => {
                // The power 1/2.4 = 1/3 + 1/12, which takes half as long this way.
                let root = libm::cbrt(intensity);
                1.055 * (root * root.sqrt().sqrt()) - 0.055
            }
        }
    }

    /// The intensity of a value between 0 and 1, right but for a few roundings.
    #[must_use]
    pub fn intensity(self, value: f64) -> f64 {
        match self {
            Self::None => value,
            Self::Srgb if value <= 0.040_45 => value / 12.92,
            Self::Srgb => libm::pow((value + 0.055) / 1.055, 2.4),
        }
    }

    /// By how much at most the value changes for each bit that the intensity does.
    ///
    /// The curve of sRGB is steepest at black. Behind the straight part its slope is at most
    /// 1.055/2.4 · 0.0031308^(−1.4/2.4) = 12.71.
    #[must_use]
    pub fn steepest(self) -> f64 {
        match self {
            Self::None => 1.0,
            Self::Srgb => 12.92,
        }
    }

    /// How far the value of what is shown may be off, if an intensity is off by no more than `error`;
    /// what is above white is shown as white.
    ///
    /// As the curve bends downward, that is how far it falls towards black.
    #[must_use]
    pub fn error(self, intensity: f64, error: f64) -> f64 {
        let darkest = intensity - error;
        match self {
            _ if darkest >= 1.0 => 0.0,
            Self::None => error,
            Self::Srgb => self.value(intensity.min(1.0).max(error)) - self.value(darkest.max(0.0)),
        }
    }

    /// How far from a threshold, in code values, [`value`](Self::value) is good enough to choose one:
    /// far more than what roots and roundings are off.
    pub(super) fn close(self) -> f64 {
        match self {
            Self::None => 1.0 / 137_438_953_472.0,
            Self::Srgb => 1.0 / 1_048_576.0,
        }
    }

    /// Whether an intensity between 0 and 1 has a value of at least `halves / (2 largest)`, exactly.
    ///
    /// For sRGB: the intensity *x* of a value *v* is *v*/12.92 up to *v* = 0.04045, and beyond that
    /// *x*⁵ is the twelfth power of (*v* + 0.055)/1.055, all of which are fractions of whole numbers.
    /// The two ways of the standard, to values and from them, do not quite agree where the parts meet,
    /// but there is no threshold of 8 or 16 bits between them.
    pub(super) fn reaches(self, intensity: f64, halves: u32, largest: u16) -> bool {
        let (halves, largest) = (f64::from(halves), f64::from(largest));
        match self {
            // That is `2 l i ≥ h`, or `(2 l + 2) i − h ≥ 2 i`. As `2 l + 2` is a power of two, both
            // products are exact, and so is the difference wherever the sides are close
            // (Sterbenz 1974).
            Self::None => intensity * (2.0 * largest + 2.0) - halves >= 2.0 * intensity,
            Self::Srgb => {
                let intensity = Exact::from(intensity);
                let [reached, threshold] = if 10_000.0 * halves <= 809.0 * largest {
                    let scale = Exact::from(646.0 * largest);
                    [&scale * &intensity, Exact::from(25.0 * halves)]
                } else {
                    let [above, below] = [100.0 * halves + 11.0 * largest, 211.0 * largest];
                    let [above, below] = [above, below].map(|it| twelfth_power(&Exact::from(it)));
                    let fifth_power = &intensity.squared().squared() * &intensity;
                    [&fifth_power * &below, above]
                };
                (&reached - &threshold).sign() != Sign::Negative
            }
        }
    }
}

fn twelfth_power(base: &Exact) -> Exact {
    let cube = &base.squared() * base;
    cube.squared().squared()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Many intensities from 0 to 1, closer together where they are dark.
    fn intensities() -> impl Iterator<Item = f64> {
        (0..=4000).map(|step| (f64::from(step) / 4000.0).powi(3))
    }

    #[test]
    fn the_ends_of_the_curve_stay_where_they_are() {
        for transfer in Transfer::ALL {
            assert_eq!(transfer.value(0.0), 0.0);
            assert!((transfer.value(1.0) - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn an_intensity_comes_back_from_its_value() {
        for intensity in intensities() {
            for transfer in Transfer::ALL {
                let back = transfer.intensity(transfer.value(intensity));
                // Where the parts of the curve meet, the constants of the standard leave a step.
                assert!((back - intensity).abs() <= 1e-8, "{transfer:?} {intensity}");
            }
        }
    }

    #[test]
    fn nowhere_is_the_curve_steeper_than_it_says() {
        let transfer = Transfer::Srgb;
        let pairs = intensities().zip(intensities().skip(1));
        for (low, high) in pairs {
            let rise = transfer.value(high) - transfer.value(low);
            // Where its parts meet, the constants of the standard leave a step.
            assert!(rise <= transfer.steepest() * (high - low) + 1e-7, "{low}");
            assert!(rise >= 0.0, "{low}");
        }
    }

    #[test]
    fn what_is_shown_is_no_further_off_than_is_said() {
        let transfer = Transfer::Srgb;
        for intensity in intensities() {
            for error in [1e-6, 0.001, 0.03, 0.4] {
                let most = transfer.error(intensity, error) + 1e-7;
                for step in -8..=8 {
                    let other = intensity + error * f64::from(step) / 8.0;
                    let [shown, truth] =
                        [intensity, other].map(|it| transfer.value(it.clamp(0.0, 1.0)));
                    assert!((shown - truth).abs() <= most, "{intensity} and {other}");
                }
            }
        }
        assert_eq!(transfer.error(1.5, 0.4), 0.0);
        assert_eq!(Transfer::None.error(0.2, 0.4), 0.4);
    }
}
