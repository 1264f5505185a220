//! Linear colours.

use std::ops::{Add, AddAssign, Div, Mul};

/// Linear red, green and blue intensity or reflectivity; 1 is full, not a limit.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rgb {
    /// Red.
    pub r: f64,
    /// Green.
    pub g: f64,
    /// Blue.
    pub b: f64,
}

impl Rgb {
    /// No light.
    pub const BLACK: Self = Self::new(0.0, 0.0, 0.0);
    /// Full intensity in every channel; the neutral element of multiplication.
    pub const WHITE: Self = Self::new(1.0, 1.0, 1.0);

    /// A colour from its three channels.
    #[must_use]
    pub const fn new(r: f64, g: f64, b: f64) -> Self {
        Self { r, g, b }
    }

    /// The largest of the three channels.
    #[must_use]
    pub fn max_channel(self) -> f64 {
        self.r.max(self.g).max(self.b)
    }

    /// The largest absolute value of the three channels.
    #[must_use]
    pub fn largest(self) -> f64 {
        self.r.abs().max(self.g.abs()).max(self.b.abs())
    }

    /// Returns whether every channel is zero.
    #[must_use]
    pub fn is_black(self) -> bool {
        self == Self::BLACK
    }

    /// Returns whether no channel is infinite or not-a-number.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.r.is_finite() && self.g.is_finite() && self.b.is_finite()
    }

    /// The same colour with infinite channels replaced by the largest finite numbers.
    ///
    /// Later products with zero are then zero, and not not-a-number.
    #[must_use]
    pub fn saturated(self) -> Self {
        let saturate = |channel: f64| channel.clamp(f64::MIN, f64::MAX);
        Self::new(saturate(self.r), saturate(self.g), saturate(self.b))
    }

    /// The channels in the order red, green, blue.
    #[must_use]
    pub const fn channels(self) -> [f64; 3] {
        [self.r, self.g, self.b]
    }
}

impl From<glam::DVec3> for Rgb {
    fn from(vector: glam::DVec3) -> Self {
        Self::new(vector.x, vector.y, vector.z)
    }
}

impl From<Rgb> for glam::DVec3 {
    fn from(color: Rgb) -> Self {
        Self::new(color.r, color.g, color.b)
    }
}

impl Add for Rgb {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.r + other.r, self.g + other.g, self.b + other.b)
    }
}

impl AddAssign for Rgb {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Mul for Rgb {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.r * other.r, self.g * other.g, self.b * other.b)
    }
}

impl Mul<f64> for Rgb {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self::new(self.r * factor, self.g * factor, self.b * factor)
    }
}

impl Div<f64> for Rgb {
    type Output = Self;
    fn div(self, divisor: f64) -> Self {
        Self::new(self.r / divisor, self.g / divisor, self.b / divisor)
    }
}
