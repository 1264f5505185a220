//! Vectors of fractions: the oracle's own arithmetic, which shares nothing with the production's.

use dashu_ratio::RBig;
use glam::DVec3;
use heliodon::math::Point;

/// A vector without rounding.
#[derive(Debug, Clone)]
pub(crate) struct Vector([RBig; 3]);

/// The number that a finite double stands for.
pub(crate) fn number(double: f64) -> RBig {
    RBig::try_from(double).expect("a finite double")
}

/// −1, 0 or 1.
pub(crate) fn sign(number: &RBig) -> i8 {
    match number.cmp(&RBig::ZERO) {
        std::cmp::Ordering::Less => -1,
        std::cmp::Ordering::Equal => 0,
        std::cmp::Ordering::Greater => 1,
    }
}

/// The nearest double.
pub(crate) fn rounded(number: &RBig) -> f64 {
    number.to_f64().value()
}

impl Vector {
    pub(crate) fn of(vector: DVec3) -> Self {
        Self(vector.to_array().map(number))
    }

    /// The place of a point in the world.
    pub(crate) fn to(point: &Point) -> Self {
        Self::of(point.anchor).plus(&Self::of(point.offset))
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self(std::array::from_fn(|axis| &self.0[axis] + &other.0[axis]))
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        Self(std::array::from_fn(|axis| &self.0[axis] - &other.0[axis]))
    }

    pub(crate) fn times(&self, factor: &RBig) -> Self {
        Self(std::array::from_fn(|axis| &self.0[axis] * factor))
    }

    /// The components divided one by one.
    pub(crate) fn over(&self, divisors: DVec3) -> Self {
        let divisors = divisors.to_array();
        Self(std::array::from_fn(|axis| {
            &self.0[axis] / number(divisors[axis])
        }))
    }

    pub(crate) fn dot(&self, other: &Self) -> RBig {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        a * x + b * y + c * z
    }

    pub(crate) fn cross(&self, other: &Self) -> Self {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    pub(crate) fn rounded(&self) -> DVec3 {
        let [x, y, z] = &self.0;
        DVec3::new(rounded(x), rounded(y), rounded(z))
    }
}
