//! The number format of a channel.

use super::Encoding;
use crate::language::words;

/// The number format of a channel: 8 bits, 16 bits or float.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BitDepth {
    /// A code value of 8 bits, as in the chapter.
    #[default]
    Eight,
    /// A code value of 16 bits.
    Sixteen,
    /// The intensity as a 32-bit float.
    Float,
}

words!(BitDepth {
    Eight: "8",
    Sixteen: "16",
    Float: "float",
});

impl BitDepth {
    /// The largest code value; `None` for floats.
    #[must_use]
    pub fn largest(self) -> Option<u16> {
        match self {
            Self::Eight => Some(255),
            Self::Sixteen => Some(65_535),
            Self::Float => None,
        }
    }

    /// The stored number of an intensity: its code value, or the nearest float.
    #[must_use]
    pub fn stored(self, intensity: f64, encoding: Encoding) -> f64 {
        match self.largest() {
            Some(largest) => f64::from(encoding.code(intensity, largest)),
            None => f64::from(float(intensity)),
        }
    }

    /// The display value of a stored intensity; white is 1.
    #[must_use]
    pub fn displayed(self, intensity: f64, encoding: Encoding) -> f64 {
        let stored = self.stored(intensity, encoding);
        match self.largest() {
            Some(largest) => stored / f64::from(largest),
            None => encoding.transfer.value(stored),
        }
    }
}

/// The nearest finite float of an intensity.
#[expect(
    clippy::cast_possible_truncation,
    reason = "the format has 32-bit floats"
)]
pub(super) fn float(intensity: f64) -> f32 {
    (intensity as f32).clamp(f32::MIN, f32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::{Rounding, Transfer};

    #[test]
    fn a_share_of_the_largest_code_is_shown_and_floats_by_the_curve() {
        let encoding = |transfer| Encoding {
            transfer,
            rounding: Rounding::Nearest,
        };
        for transfer in Transfer::ALL {
            for (depth, most) in [
                (BitDepth::Eight, 0.5 / 255.0),
                (BitDepth::Sixteen, 0.5 / 65_535.0),
                (BitDepth::Float, 1e-7),
            ] {
                let encoding = encoding(transfer);
                let off = (0..=1000).map(|step| {
                    let intensity = f64::from(step) / 1000.0;
                    (depth.displayed(intensity, encoding) - transfer.value(intensity)).abs()
                });
                let largest = off.fold(0.0, f64::max);
                // As large as it can be, nearly: a finer depth would be off by less.
                assert!(
                    (0.1 * most..=most).contains(&largest),
                    "{depth:?}: {largest}"
                );
            }
        }
    }

    #[test]
    fn only_floats_keep_what_is_brighter_than_white() {
        let stored = BitDepth::ALL.map(|depth| depth.stored(2.5, Encoding::default()));
        assert_eq!(stored, [255.0, 65_535.0, 2.5]);
    }
}
