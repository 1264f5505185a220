//! Vectors of fractions: the oracle's own arithmetic, which shares nothing with the production's.

use dashu_ratio::RBig;
use glam::DVec3;
use heliodon::math::Point;

/// A vector without rounding.
#[derive(Debug, Clone)]
pub struct Vector([RBig; 3]);

/// The number that a finite double stands for.
pub fn number(double: f64) -> RBig {
    RBig::try_from(double).expect("a finite double")
}

/// −1, 0 or 1.
pub fn sign(number: &RBig) -> i8 {
    match number.cmp(&RBig::ZERO) {
        std::cmp::Ordering::Less => -1,
        std::cmp::Ordering::Equal => 0,
        std::cmp::Ordering::Greater => 1,
    }
}

/// The nearest double.
pub fn rounded(number: &RBig) -> f64 {
    number.to_f64().value()
}

impl Vector {
    /// The vector of three finite doubles.
    pub fn of(vector: DVec3) -> Self {
        Self(vector.to_array().map(number))
    }

    /// The place of a point in the world.
    pub fn to(point: &Point) -> Self {
        Self::of(point.anchor).plus(&Self::of(point.offset))
    }

    /// The sum.
    pub fn plus(&self, other: &Self) -> Self {
        Self(std::array::from_fn(|axis| &self.0[axis] + &other.0[axis]))
    }

    /// The difference.
    pub fn minus(&self, other: &Self) -> Self {
        Self(std::array::from_fn(|axis| &self.0[axis] - &other.0[axis]))
    }

    /// The vector times a number.
    pub fn times(&self, factor: &RBig) -> Self {
        Self(std::array::from_fn(|axis| &self.0[axis] * factor))
    }

    /// The components divided one by one.
    pub fn over(&self, divisors: DVec3) -> Self {
        let divisors = divisors.to_array();
        Self(std::array::from_fn(|axis| {
            &self.0[axis] / number(divisors[axis])
        }))
    }

    /// The scalar product.
    pub fn dot(&self, other: &Self) -> RBig {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        a * x + b * y + c * z
    }

    /// The vector product.
    pub fn cross(&self, other: &Self) -> Self {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    /// The nearest doubles of the components.
    pub fn rounded(&self) -> DVec3 {
        let [x, y, z] = &self.0;
        DVec3::new(rounded(x), rounded(y), rounded(z))
    }
}
