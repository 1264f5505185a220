//! Texel indices inside and outside of an image.

use crate::language::words;

/// The continuation of an image beyond its borders: the chapter's CLAMP and REPEAT.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wrap {
    /// The border texels continue.
    Clamp,
    /// The image repeats.
    Repeat,
}

words!(Wrap {
    Clamp: "clamp",
    Repeat: "repeat",
});

impl Wrap {
    /// The index, from 0 to `count − 1`, of the texel at a coordinate in texels.
    ///
    /// Texel `k` covers `k ≤ coordinate < k + 1`, so all rows and columns have equal sizes. NaN has
    /// the index 0.
    #[must_use]
    #[expect(
        clippy::cast_possible_truncation,
        reason = "casts from float saturate; NaN is 0"
    )]
    #[expect(
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "negative numbers saturate; counts are small"
    )]
    pub fn index(self, coordinate: f64, count: usize) -> usize {
        const SMALL: std::ops::Range<f64> = 0.0..4_294_967_296.0; // 2^32
        let last = count - 1;
        match self {
            // Below zero the cast saturates, above it drops the fraction.
            Self::Clamp => (coordinate as usize).min(last),
            Self::Repeat if SMALL.contains(&coordinate) => {
                (coordinate as u32 % count as u32) as usize
            }
            // The remainder of two whole numbers is exact at any distance.
            Self::Repeat => (coordinate.floor().rem_euclid(count as f64) as usize).min(last),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Wrap::{Clamp, Repeat};

    #[test]
    fn clamp_continues_the_border() {
        let indices = [-0.5, 0.0, 0.999, 1.0, 3.5, 4.0, 1e300].map(|x| Clamp.index(x, 4));
        assert_eq!(indices, [0, 0, 0, 1, 3, 3, 3]);
    }

    #[test]
    fn repeat_is_even_on_both_sides() {
        let indices = [-4.0, -0.3, -1e-17, 0.0, 3.9, 4.0, 4e17].map(|x| Repeat.index(x, 4));
        assert_eq!(indices, [0, 3, 3, 0, 3, 0, 0]);
        assert_eq!(Repeat.index(-1e-17, 1), 0);
    }
}
