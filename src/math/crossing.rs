//! Where a line crosses a plane.

use glam::DVec3;

use super::Span;
use super::band::{QUOTIENT, SLOPE};

/// Where a line crosses a plane ahead, not yet divided: `t = height / slope`.
#[derive(Debug, Clone, Copy)]
pub struct Crossing {
    /// From the plane's point to the ray's origin.
    pub origin: DVec3,
    /// How far the origin lies behind the plane, along the normal: `N = −n·c`.
    pub height: f64,
    /// How much the ray rises along the normal per unit of `t`: `D = n·d`.
    pub slope: f64,
    /// Whether the ray rises along the normal; the sign of the slope, for certain.
    pub rises: bool,
    /// How far at most the height is from the true one.
    pub doubt: f64,
    /// How far the origin may be from where it ought to, if it is no further from the plane than
    /// that: the ray crosses the plane at its very start, and there its line says little.
    pub at_start: Option<f64>,
    /// How a ray crosses that is nearly parallel to the plane; `None` for all others.
    pub grazing: Option<Grazing>,
}

/// A crossing so nearly along the plane that only the exact place says what lies there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grazing {
    /// The ray meets the plane ahead.
    Ahead,
    /// Rounding has put the start of the ray beyond the plane, which it has yet to cross.
    Behind,
}

impl Crossing {
    /// Whether borders have to be asked exactly, however far from them the rounded place is.
    #[must_use]
    #[inline(always)]
    pub fn is_delicate(&self) -> bool {
        self.at_start.is_some() || self.grazing.is_some()
    }

    /// The distance of the crossing: above zero, as it lies ahead.
    #[must_use]
    pub fn distance(&self) -> f64 {
        const SMALLEST: f64 = f64::from_bits(1);
        // Within rounding of the plane, the height can have the wrong sign.
        (self.height / self.slope).max(SMALLEST)
    }

    /// Whether the crossing lies beyond a span for certain, before any division.
    #[must_use]
    #[inline(always)]
    pub fn is_beyond(&self, span: Span) -> bool {
        self.height.abs() - self.doubt > span.max() * (self.slope.abs() + SLOPE)
    }

    /// How far at most a distance is from the exact one.
    #[must_use]
    pub fn error(&self, t: f64) -> f64 {
        (self.doubt + SLOPE * t) / self.slope.abs() + QUOTIENT * t
    }
}
