//! Vectors without rounding.

use std::ops::{Add, Sub};

use glam::DVec3;

use super::{Exact, RationalVector};

/// A vector of exact components.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExactVector([Exact; 3]);

impl ExactVector {
    /// The eight corners of the box around a centre with these half sizes.
    #[must_use]
    pub fn box_around(center: DVec3, reach: DVec3) -> Vec<Self> {
        let sign = |bit: u8, corner: u8| if corner & bit == 0 { -1.0 } else { 1.0 };
        let center = Self::from(center);
        let to = |corner| DVec3::new(sign(1, corner), sign(2, corner), sign(4, corner)) * reach;
        (0..8)
            .map(|corner| &center + &Self::from(to(corner)))
            .collect()
    }

    /// The components rounded.
    #[must_use]
    pub fn rounded(&self) -> DVec3 {
        DVec3::from_array(std::array::from_fn(|axis| self.0[axis].to_f64()))
    }

    /// The scalar product.
    #[must_use]
    pub fn dot(&self, other: &Self) -> Exact {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        &(&(a * x) + &(b * y)) + &(c * z)
    }

    /// The vector product.
    #[must_use]
    pub fn cross(&self, other: &Self) -> Self {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        Self([
            &(b * z) - &(c * y),
            &(c * x) - &(a * z),
            &(a * y) - &(b * x),
        ])
    }

    /// The parallel unit vector, each component rounded once; zero if this is zero.
    #[must_use]
    pub fn unit(&self) -> DVec3 {
        RationalVector(std::array::from_fn(|axis| self.0[axis].to_rational())).unit()
    }

    /// The vector times a number.
    #[must_use]
    pub fn times(&self, factor: &Exact) -> Self {
        Self(std::array::from_fn(|axis| &self.0[axis] * factor))
    }

    /// The components multiplied one by one.
    #[must_use]
    pub fn scaled(&self, factors: &Self) -> Self {
        Self(std::array::from_fn(|axis| &self.0[axis] * &factors.0[axis]))
    }

    /// The components, each as the product of the two others.
    #[must_use]
    pub fn products_of_others(&self) -> Self {
        let [x, y, z] = &self.0;
        Self([y * z, z * x, x * y])
    }
}

impl From<DVec3> for ExactVector {
    fn from(vector: DVec3) -> Self {
        Self(vector.to_array().map(Exact::from))
    }
}

impl Add for &ExactVector {
    type Output = ExactVector;

    fn add(self, other: Self) -> ExactVector {
        ExactVector(std::array::from_fn(|axis| &self.0[axis] + &other.0[axis]))
    }
}

impl Sub for &ExactVector {
    type Output = ExactVector;

    fn sub(self, other: Self) -> ExactVector {
        ExactVector(std::array::from_fn(|axis| &self.0[axis] - &other.0[axis]))
    }
}
