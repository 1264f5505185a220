//! Vectors of either kind of number.

use std::ops::{Add, Mul, Sub};

use glam::DVec3;

use super::Scalar;
use crate::math::Ray;

/// A point or a direction in world coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Vector<T> {
    pub(super) x: T,
    pub(super) y: T,
    pub(super) z: T,
}

impl<T: Scalar> Vector<T> {
    /// The nearest vector of such numbers.
    pub(super) fn of(vector: DVec3) -> Self {
        Self {
            x: T::of(vector.x),
            y: T::of(vector.y),
            z: T::of(vector.z),
        }
    }

    /// The same vector in 64 bits.
    pub(super) fn wide(self) -> DVec3 {
        DVec3::new(self.x.wide(), self.y.wide(), self.z.wide())
    }

    pub(super) fn dot(self, other: Self) -> T {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    pub(super) fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }

    /// Divided component by component.
    pub(super) fn over(self, other: Self) -> Self {
        Self {
            x: self.x / other.x,
            y: self.y / other.y,
            z: self.z / other.z,
        }
    }

    /// The unit vector along it; zero if it is zero.
    pub(super) fn unit(self) -> Self {
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

/// A ray in world coordinates: `P = o + t d`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line<T> {
    pub(super) origin: Vector<T>,
    pub(super) dir: Vector<T>,
}

impl<T: Scalar> Line<T> {
    pub(super) fn of(ray: &Ray) -> Self {
        Self {
            origin: Vector::of(ray.origin.world()),
            dir: Vector::of(ray.dir),
        }
    }

    pub(super) fn at(&self, t: T) -> Vector<T> {
        self.origin + self.dir * t
    }
}
