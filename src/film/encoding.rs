//! From intensities to code values.

use super::{Rounding, Transfer};

/// How an intensity becomes a code value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Encoding {
    /// The curve from intensities to values.
    pub transfer: Transfer,
    /// How a value between two code values becomes one of them.
    pub rounding: Rounding,
}

impl From<Rounding> for Encoding {
    /// Without a curve.
    fn from(rounding: Rounding) -> Self {
        Self {
            transfer: Transfer::None,
            rounding,
        }
    }
}

impl Encoding {
    /// The code value from 0 to `largest` for an intensity; clamped, and 0 for not-a-number.
    ///
    /// `largest` is one less than a power of two: all bits of the format set. It is exact, so it is the
    /// same on every machine; only truncated intensities without a curve are rounded once before, as
    /// the course's programs did.
    #[must_use]
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
        let into = raised - f64::from(code);
        let is_sure = into > transfer.close() && into < 1.0 - transfer.close();
        if self == Rounding::Truncate.into() || is_sure || intensity <= 0.0 {
            return code;
        }
        let reaches = |code: u16| transfer.reaches(intensity, rounding.halves(code), largest);
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
