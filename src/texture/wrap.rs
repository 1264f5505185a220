//! From a place in an image to the index of a texel.

use crate::language::words;

/// What happens outside of the image: the chapter's CLAMP and REPEAT.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wrap {
    /// The border texels go on for ever.
    Clamp,
    /// The image is repeated.
    Repeat,
}

words!(Wrap {
    Clamp: "clamp",
    Repeat: "repeat",
});

impl Wrap {
    /// The index from 0 to `count − 1` for a place counted in texels from the image's edge.
    ///
    /// Texel `k` owns `k ≤ place < k + 1`, so every row and column has the same share.
    /// Not-a-number gives 0.
    #[must_use]
    #[expect(
        clippy::cast_possible_truncation,
        reason = "casts from float saturate; NaN is 0"
    )]
    #[expect(
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "as said above"
    )]
    pub fn index(self, place: f64, count: usize) -> usize {
        const SMALL: std::ops::Range<f64> = 0.0..4_294_967_296.0; // 2^32
        let last = count - 1;
        match self {
            // Below zero the cast saturates, above it drops the fraction.
            Self::Clamp => (place as usize).min(last),
            Self::Repeat if SMALL.contains(&place) => (place as u32 % count as u32) as usize,
            // The remainder of two whole numbers is exact, however far away the place is.
            Self::Repeat => (place.floor().rem_euclid(count as f64) as usize).min(last),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Wrap::{Clamp, Repeat};

    #[test]
    fn clamp_keeps_the_border() {
        let indices = [-0.5, 0.0, 0.999, 1.0, 3.5, 4.0, 1e300].map(|place| Clamp.index(place, 4));
        assert_eq!(indices, [0, 0, 0, 1, 3, 3, 3]);
    }

    #[test]
    fn repeat_goes_on_evenly_on_both_sides() {
        let indices = [-4.0, -0.3, -1e-17, 0.0, 3.9, 4.0, 4e17].map(|place| Repeat.index(place, 4));
        assert_eq!(indices, [0, 3, 3, 0, 3, 0, 0]);
        assert_eq!(Repeat.index(-1e-17, 1), 0);
    }
}
