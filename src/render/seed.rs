//! Seeds of the random choices along a path.

use crate::math::scramble;

/// The seed of the random choices along a path.
///
/// It depends on the pixel and the ray only.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seed {
    /// The sequence of choices.
    pub(super) stream: u64,
    /// The index of this path's part of the sequence.
    pub(super) number: u32,
}

impl Seed {
    /// A sequence for the only ray through a raster position.
    pub(super) fn of_place(x: f64, y: f64) -> Self {
        Self::shared(x.to_bits() ^ y.to_bits().rotate_left(32), 0)
    }

    /// A part of a sequence that all rays of a pixel share.
    pub(super) fn shared(stream: u64, number: u32) -> Self {
        Self { stream, number }
    }

    /// The seed of the next reflected or transmitted ray.
    pub(super) fn next(self) -> Self {
        Self {
            stream: self.stream.wrapping_add(1),
            ..self
        }
    }

    /// The seed for a lamp.
    ///
    /// Its sequence is scrambled independently of those already in use.
    pub(super) fn of_lamp(self, number: usize) -> Self {
        Self {
            stream: scramble(self.stream).wrapping_add(number as u64),
            ..self
        }
    }
}
