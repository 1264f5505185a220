//! Transfer curves from intensities to display values.

use crate::language::words;
use crate::math::exact::{Exact, Sign};

/// The curve from an intensity to a display value.
///
/// A code value is the display value times the largest code value, rounded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Transfer {
    /// No curve: the value is the intensity, as in the chapter.
    #[default]
    None,
    /// The sRGB curve of screens (IEC 61966-2-1:1999).
    Srgb,
}

words!(Transfer {
    None: "none",
    Srgb: "srgb",
});

impl Transfer {
    /// The display value of an intensity within a few roundings; exact for 0 and 1.
    #[must_use]
    pub fn value(self, intensity: f64) -> f64 {
        match self {
            Self::None => intensity,
            Self::Srgb if intensity <= 0.003_130_8 => 12.92 * intensity,
            Self::Srgb => {
                // The power 1/2.4 = 1/3 + 1/12. Two roots take half the time of a power.
                let root = libm::cbrt(intensity);
                1.055 * (root * root.sqrt().sqrt()) - 0.055
            }
        }
    }

    /// The intensity of a display value from 0 to 1, within a few roundings.
    #[must_use]
    pub fn intensity(self, value: f64) -> f64 {
        match self {
            Self::None => value,
            Self::Srgb if value <= 0.040_45 => value / 12.92,
            Self::Srgb => libm::pow((value + 0.055) / 1.055, 2.4),
        }
    }

    /// The largest slope of the curve.
    #[must_use]
    pub fn max_slope(self) -> f64 {
        match self {
            Self::None => 1.0,
            // The slope of the linear part. Beyond it the slope is at most
            // 1.055/2.4 · 0.0031308^(−1.4/2.4) = 12.71.
            Self::Srgb => 12.92,
        }
    }

    /// Error bound of a display value, from that of its intensity.
    ///
    /// Intensities above white are displayed as white.
    #[must_use]
    pub fn error(self, intensity: f64, error: f64) -> f64 {
        let darkest = intensity - error;
        match self {
            _ if darkest >= 1.0 => 0.0,
            Self::None => error,
            // The curve is concave, so the value changes most towards black.
            Self::Srgb => self.value(intensity.min(1.0).max(error)) - self.value(darkest.max(0.0)),
        }
    }

    /// Distance from a threshold, in code values, at which `value` is precise enough.
    ///
    /// It is much larger than the error of the roots and roundings.
    pub(super) fn margin(self) -> f64 {
        match self {
            Self::None => 1.0 / 137_438_953_472.0,
            Self::Srgb => 1.0 / 1_048_576.0,
        }
    }

    /// True if an intensity has a value of at least `halves / (2 largest)`, exactly.
    ///
    /// The intensity lies between 0 and 1.
    pub(super) fn reaches(self, intensity: f64, halves: u32, largest: u16) -> bool {
        let (halves, largest) = (f64::from(halves), f64::from(largest));
        match self {
            // `2 l i ≥ h` is `(2 l + 2) i − h ≥ 2 i`. Both products are exact, because `2 l + 2` is a
            // power of two. The difference is exact where the sides are close (Sterbenz 1974).
            Self::None => intensity * (2.0 * largest + 2.0) - halves >= 2.0 * intensity,
            // The intensity x of a value v is v/12.92 up to v = 0.04045. Beyond that, x⁵ is the
            // twelfth power of (v + 0.055)/1.055. All are fractions of whole numbers. The
            // standard's curve and its inverse differ where the parts join, but no threshold of 8
            // or 16 bits lies between them.
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
    fn black_and_white_keep_their_values() {
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
                // The constants of the standard leave a step where the parts of the curve join.
                assert!((back - intensity).abs() <= 1e-8, "{transfer:?} {intensity}");
            }
        }
    }

    #[test]
    fn no_slope_exceeds_the_largest() {
        let transfer = Transfer::Srgb;
        let pairs = intensities().zip(intensities().skip(1));
        for (low, high) in pairs {
            let rise = transfer.value(high) - transfer.value(low);
            // The constants of the standard leave a step where the parts join.
            assert!(rise <= transfer.max_slope() * (high - low) + 1e-7, "{low}");
            assert!(rise >= 0.0, "{low}");
        }
    }

    #[test]
    fn no_display_value_exceeds_its_error_bound() {
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
