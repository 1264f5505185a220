//! Computes with vectors in space.

use std::ops::{Add, Mul, Sub};

/// A point or a direction: x to the right, y up, z towards the viewer.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vector {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) z: f64,
}

/// A short way to write a vector.
pub(crate) const fn vector(x: f64, y: f64, z: f64) -> Vector {
    Vector { x, y, z }
}

impl Vector {
    /// The inner product.
    pub(crate) fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The length.
    pub(crate) fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    /// The direction alone, of length 1.
    pub(crate) fn unit(self) -> Self {
        self * (1.0 / self.length())
    }

    /// The product, axis by axis.
    pub(crate) fn scale(self, other: Self) -> Self {
        vector(self.x * other.x, self.y * other.y, self.z * other.z)
    }

    /// The mirror image on the positive side of the x axis.
    pub(crate) fn folded(self) -> Self {
        vector(self.x.abs(), self.y, self.z)
    }
}

impl Add for Vector {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        vector(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl Sub for Vector {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        vector(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl Mul<f64> for Vector {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        vector(self.x * factor, self.y * factor, self.z * factor)
    }
}
