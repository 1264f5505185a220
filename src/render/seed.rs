//! From what is chosen along a path.

use crate::math::scramble;

/// What tells the choices of one path from those of others; a function of the pixel and the ray
/// alone.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seed {
    /// A sequence of choices.
    pub(super) stream: u64,
    /// Which part of it is this path's.
    pub(super) number: u32,
}

impl Seed {
    /// A sequence for the ray through this place of the picture alone.
    pub(super) fn of_place(x: f64, y: f64) -> Self {
        Self::shared(x.to_bits() ^ y.to_bits().rotate_left(32), 0)
    }

    /// The part with this number of a sequence that all rays of a pixel share.
    pub(super) fn shared(stream: u64, number: u32) -> Self {
        Self { stream, number }
    }

    /// The seed behind a mirror or a pane.
    pub(super) fn next(self) -> Self {
        Self {
            stream: self.stream.wrapping_add(1),
            ..self
        }
    }

    /// The seed for the lamp with this number: another sequence, scrambled on its own, pads those
    /// that are in use already.
    pub(super) fn of_lamp(self, number: usize) -> Self {
        Self {
            stream: scramble(self.stream).wrapping_add(number as u64),
            ..self
        }
    }
}
