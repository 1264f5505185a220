//! Vectors of 64-bit or 32-bit numbers.

use std::ops::{Add, Mul, Sub};

use glam::DVec3;

use super::Scalar;

/// A point or a direction in world coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vector<T> {
    /// The x coordinate.
    pub x: T,
    /// The y coordinate.
    pub y: T,
    /// The z coordinate.
    pub z: T,
}

impl<T: Scalar> Vector<T> {
    /// The nearest vector of such numbers.
    #[must_use]
    pub fn of(vector: DVec3) -> Self {
        Self {
            x: T::of(vector.x),
            y: T::of(vector.y),
            z: T::of(vector.z),
        }
    }

    /// The same vector in 64 bits.
    #[must_use]
    pub fn wide(self) -> DVec3 {
        DVec3::new(self.x.wide(), self.y.wide(), self.z.wide())
    }

    /// The scalar product.
    #[must_use]
    pub fn dot(self, other: Self) -> T {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The cross product.
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }

    /// The quotient, component by component.
    #[must_use]
    pub fn over(self, other: Self) -> Self {
        Self {
            x: self.x / other.x,
            y: self.y / other.y,
            z: self.z / other.z,
        }
    }

    /// The unit vector along it; zero if it is zero.
    #[must_use]
    pub fn unit(self) -> Self {
        let length = self.dot(self).sqrt();
        if length == T::zero() {
            return self;
        }
        Self {
            x: self.x / length,
            y: self.y / length,
            z: self.z / length,
        }
    }
}

impl<T: Scalar> Add for Vector<T> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            x: self.x + other.x,
            y: self.y + other.y,
            z: self.z + other.z,
        }
    }
}

impl<T: Scalar> Sub for Vector<T> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self {
            x: self.x - other.x,
            y: self.y - other.y,
            z: self.z - other.z,
        }
    }
}

impl<T: Scalar> Mul<T> for Vector<T> {
    type Output = Self;

    fn mul(self, factor: T) -> Self {
        Self {
            x: self.x * factor,
            y: self.y * factor,
            z: self.z * factor,
        }
    }
}
