//! The two sides of a surface.

use super::exact::Sign;

/// The side of a surface that a point is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The side that the normal points to, which is lit.
    Front,
    /// Exactly on the surface.
    On,
    /// Behind, or inside of a closed surface.
    Back,
}

impl Side {
    /// The side for the sign of a height above a surface.
    #[must_use]
    pub fn of(height: Sign) -> Self {
        match height {
            Sign::Negative => Self::Back,
            Sign::Zero => Self::On,
            Sign::Positive => Self::Front,
        }
    }

    /// The other side; `None` on the surface.
    #[must_use]
    pub fn opposite(self) -> Option<Self> {
        match self {
            Self::Front => Some(Self::Back),
            Self::On => None,
            Self::Back => Some(Self::Front),
        }
    }
}
