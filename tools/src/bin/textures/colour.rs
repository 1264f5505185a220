//! Mixes colours: red, green and blue shares in the display's own (non-linear) scale.

use crate::shape::smooth;
use std::ops::{Add, Mul};

/// A colour whose three shares go from 0 to 1; values beyond are clipped when it is stored.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Colour(pub [f64; 3]);

impl Colour {
    /// No light at all.
    pub(crate) const BLACK: Self = Self([0.0; 3]);
    /// Full light.
    pub(crate) const WHITE: Self = Self([1.0; 3]);

    /// The colour of a code such as `0xff_80_00`.
    pub(crate) fn hex(code: u32) -> Self {
        let [_, red, green, blue] = code.to_be_bytes();
        Self::from_bytes([red, green, blue])
    }

    /// The colour of a stored pixel.
    pub(crate) fn from_bytes(bytes: [u8; 3]) -> Self {
        Self(bytes.map(|byte| f64::from(byte) / 255.0))
    }

    /// The nearest pixel to store.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "Clamped to 0..=255"
    )]
    pub(crate) fn to_bytes(self) -> [u8; 3] {
        self.0
            .map(|share| (share.clamp(0.0, 1.0) * 255.0 + 0.5) as u8)
    }

    /// The blend that is `self` at 0 and `other` at 1; `share` is clipped to that range.
    pub(crate) fn mix(self, other: Self, share: f64) -> Self {
        let share = share.clamp(0.0, 1.0);
        self * (1.0 - share) + other * share
    }

    /// The product of the shares, as a pane of glass filters light.
    pub(crate) fn filter(self, other: Self) -> Self {
        self.pair(other, |ours, theirs| ours * theirs)
    }

    /// The sum of the absolute differences of the shares.
    pub(crate) fn difference(self, other: Self) -> f64 {
        self.pair(other, |ours, theirs| (ours - theirs).abs())
            .0
            .iter()
            .sum()
    }

    /// This colour covered by `top` inside a shape, given the signed distance to it in pixels.
    pub(crate) fn cover(self, top: Self, distance: f64) -> Self {
        self.mix(top, smooth(0.5, -0.5, distance))
    }

    /// The colour whose shares `combine` makes of the shares of two colours.
    fn pair(self, other: Self, combine: impl Fn(f64, f64) -> f64) -> Self {
        Self([0, 1, 2].map(|share| combine(self.0[share], other.0[share])))
    }
}

impl Add for Colour {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.pair(other, |ours, theirs| ours + theirs)
    }
}

impl Mul<f64> for Colour {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self(self.0.map(|share| share * factor))
    }
}
