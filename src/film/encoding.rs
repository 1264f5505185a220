//! Code values of intensities.

use super::Transfer;
use crate::language::words;

/// The rounding of a value between two code values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rounding {
    /// To the nearest code value, halves upward.
    #[default]
    Nearest,
    /// To the next lower code value, as in the course's programs.
    Truncate,
}

words!(Rounding {
    Nearest: "round",
    Truncate: "truncate",
});

impl Rounding {
    /// The smallest value that becomes a code value, in halves of a code value.
    fn threshold(self, code: u16) -> u32 {
        match self {
            Self::Nearest => (2 * u32::from(code)).saturating_sub(1),
            Self::Truncate => 2 * u32::from(code),
        }
    }
}

/// The map from intensities to code values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Encoding {
    /// The curve from intensities to display values.
    pub transfer: Transfer,
    /// The rounding of a value between two code values.
    pub rounding: Rounding,
}

impl From<Rounding> for Encoding {
    /// The encoding without a curve.
    fn from(rounding: Rounding) -> Self {
        Self {
            transfer: Transfer::None,
            rounding,
        }
    }
}

impl Encoding {
    /// The code value from 0 to `largest` of an intensity, clamped; 0 for NaN.
    ///
    /// `largest` is one less than a power of two. The code value is exact, so it is the same on
    /// every machine. One case rounds the scaled intensity first, as the course's programs did:
    /// truncation without a curve.
    #[must_use]
    #[inline(always)]
    pub fn code(self, intensity: f64, largest: u16) -> u16 {
        let Self { transfer, rounding } = self;
        if intensity >= 1.0 {
            return largest;
        }
        let scaled = transfer.value(intensity) * f64::from(largest);
        let raised = match rounding {
            Rounding::Nearest => scaled + 0.5,
            Rounding::Truncate => scaled,
        };
        #[expect(
            clippy::cast_possible_truncation,
            reason = "casts from float saturate; NaN is 0"
        )]
        let code = (raised as u16).min(largest);
        let fraction = raised - f64::from(code);
        let is_certain = fraction > transfer.margin() && fraction < 1.0 - transfer.margin();
        if is_certain {
            code
        } else {
            self.exact_code(intensity, code, largest)
        }
    }

    /// The code value of an intensity for which rounded values found `code`, or one beside it.
    #[cold]
    fn exact_code(self, intensity: f64, code: u16, largest: u16) -> u16 {
        let Self { transfer, rounding } = self;
        if self == Rounding::Truncate.into() || intensity <= 0.0 {
            return code;
        }
        let reaches = |code: u16| transfer.reaches(intensity, rounding.threshold(code), largest);
        if code > 0 && !reaches(code) {
            code - 1
        } else if code < largest && reaches(code + 1) {
            code + 1
        } else {
            code
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NEAREST: Encoding = Encoding {
        transfer: Transfer::None,
        rounding: Rounding::Nearest,
    };
    const TRUNCATE: Encoding = Encoding {
        transfer: Transfer::None,
        rounding: Rounding::Truncate,
    };

    #[test]
    fn the_nearest_code_is_chosen_at_every_threshold() {
        for code in 0..255u16 {
            let threshold = (f64::from(code) + 0.5) / 255.0;
            assert_eq!(NEAREST.code(threshold.next_up(), 255), code + 1);
            assert_eq!(NEAREST.code(threshold.next_down().next_down(), 255), code);
            assert_eq!(NEAREST.code(f64::from(code) / 255.0, 255), code);
        }
    }

    #[test]
    fn nothing_leaves_the_range() {
        for encoding in [NEAREST, TRUNCATE] {
            assert_eq!(encoding.code(-3.0, 255), 0);
            assert_eq!(encoding.code(7.0, 255), 255);
            assert_eq!(encoding.code(f64::INFINITY, 65_535), 65_535);
            assert_eq!(encoding.code(f64::NAN, 255), 0);
        }
        assert_eq!(TRUNCATE.code(0.999, 255), 254);
    }
}
