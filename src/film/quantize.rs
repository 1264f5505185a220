//! From intensities to code values.

/// How an intensity between two code values becomes one of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rounding {
    /// To the nearest code value, halves upward.
    #[default]
    Nearest,
    /// To the next lower one, as the course's programs did.
    Truncate,
}

impl Rounding {
    /// All of them, the default first.
    pub const ALL: [Self; 2] = [Self::Nearest, Self::Truncate];
    /// Their words in a scene and on the command line, in the same order.
    pub const WORDS: [&'static str; 2] = ["round", "truncate"];

    /// The word for it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Nearest => Self::WORDS[0],
            Self::Truncate => Self::WORDS[1],
        }
    }

    /// The rounding with this word.
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        let mut all = Self::ALL.into_iter();
        all.find(|rounding| rounding.word() == word)
    }

    /// The code value from 0 to `largest` for an intensity; clamped, and 0 for not-a-number.
    ///
    /// `largest` is one less than a power of two: all bits of the format set.
    #[must_use]
    pub fn code(self, intensity: f64, largest: u16) -> u16 {
        let scaled = intensity * f64::from(largest);
        let raised = match self {
            Self::Nearest => scaled + 0.5,
            Self::Truncate => scaled,
        };
        #[expect(
            clippy::cast_possible_truncation,
            reason = "casts from float saturate; NaN is 0"
        )]
        let code = (raised as u16).min(largest);
        // Two roundings of at most a code's 2⁻³⁷th: only next to a threshold is there any doubt.
        const CLOSE: f64 = 1.0 / 137_438_953_472.0;
        let into = raised - f64::from(code);
        if self == Self::Truncate || into > CLOSE && into < 1.0 - CLOSE || intensity <= 0.0 {
            return code;
        }
        if code > 0 && !reaches(intensity, code, largest) {
            code - 1
        } else if code < largest && reaches(intensity, code + 1, largest) {
            code + 1
        } else {
            code
        }
    }
}

/// Whether an intensity is at least half a code below a code above zero, exactly.
///
/// That is `2 l i ≥ 2 c − 1`, or `(2 l + 2) i − (2 c − 1) ≥ 2 i`. As `2 l + 2` is a power of two, both
/// products are exact, and so is the difference wherever the sides are close (Sterbenz 1974).
fn reaches(intensity: f64, code: u16, largest: u16) -> bool {
    let (code, largest) = (f64::from(code), f64::from(largest));
    intensity * (2.0 * largest + 2.0) - (2.0 * code - 1.0) >= 2.0 * intensity
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_code_is_chosen_at_every_threshold() {
        for code in 0..255u16 {
            let threshold = (f64::from(code) + 0.5) / 255.0;
            assert_eq!(Rounding::Nearest.code(threshold.next_up(), 255), code + 1);
            assert_eq!(
                Rounding::Nearest.code(threshold.next_down().next_down(), 255),
                code
            );
            assert_eq!(Rounding::Nearest.code(f64::from(code) / 255.0, 255), code);
        }
    }

    #[test]
    fn nothing_leaves_the_range() {
        for rounding in [Rounding::Nearest, Rounding::Truncate] {
            assert_eq!(rounding.code(-3.0, 255), 0);
            assert_eq!(rounding.code(7.0, 255), 255);
            assert_eq!(rounding.code(f64::INFINITY, 65_535), 65_535);
            assert_eq!(rounding.code(f64::NAN, 255), 0);
        }
        assert_eq!(Rounding::Truncate.code(0.999, 255), 254);
    }
}
