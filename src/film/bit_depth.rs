//! What the numbers of a picture are kept in.

use super::{Encoding, pfm};
use crate::language::words;

/// What each channel of a pixel is kept in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BitDepth {
    /// A code value of 8 bits, as in the chapter.
    #[default]
    Eight,
    /// A code value of 16 bits.
    Sixteen,
    /// The intensity itself as a 32-bit float.
    Float,
}

words!(BitDepth {
    Eight: "8",
    Sixteen: "16",
    Float: "float",
});

impl BitDepth {
    /// The largest code value; floats are none.
    #[must_use]
    pub fn largest(self) -> Option<u16> {
        match self {
            Self::Eight => Some(255),
            Self::Sixteen => Some(65_535),
            Self::Float => None,
        }
    }

    /// The number that is kept of an intensity: its code value, or what a float can say of it.
    #[must_use]
    pub fn kept(self, intensity: f64, encoding: Encoding) -> f64 {
        match self.largest() {
            Some(largest) => f64::from(encoding.code(intensity, largest)),
            None => f64::from(pfm::float(intensity)),
        }
    }

    /// The value that is shown of an intensity that was kept; white is 1.
    #[must_use]
    pub fn shown(self, intensity: f64, encoding: Encoding) -> f64 {
        let kept = self.kept(intensity, encoding);
        match self.largest() {
            Some(largest) => kept / f64::from(largest),
            None => encoding.transfer.value(kept),
        }
    }
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
                    (depth.shown(intensity, encoding) - transfer.value(intensity)).abs()
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
        let kept = BitDepth::ALL.map(|depth| depth.kept(2.5, Encoding::default()));
        assert_eq!(kept, [255.0, 65_535.0, 2.5]);
    }
}
