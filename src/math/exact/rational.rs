//! Vectors of fractions, for frames and shared borders at load.

use std::ops::{Add, Sub};

use dashu_int::ops::{BitTest, Gcd, SquareRoot, UnsignedAbs};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;
use glam::DVec3;

use super::decimal;

/// A vector of fractions.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct RationalVector(pub [RBig; 3]);

impl RationalVector {
    /// The vector of the decimals of a scene.
    #[must_use]
    pub fn of_decimals(vector: DVec3) -> Self {
        Self(vector.to_array().map(decimal))
    }

    /// The scalar product.
    #[must_use]
    pub fn dot(&self, other: &Self) -> RBig {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        a * x + b * y + c * z
    }

    /// The vector product.
    #[must_use]
    pub fn cross(&self, other: &Self) -> Self {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    /// The vector times a number.
    #[must_use]
    pub fn times(&self, factor: &RBig) -> Self {
        Self(std::array::from_fn(|axis| &self.0[axis] * factor))
    }

    /// The largest absolute value of a component, rounded.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.rounded().abs().max_element()
    }

    /// Returns whether all components but one are zero.
    #[must_use]
    pub fn is_along_an_axis(&self) -> bool {
        self.0
            .iter()
            .filter(|component| !component.is_zero())
            .count()
            == 1
    }

    /// Returns whether all components are zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.0.iter().all(RBig::is_zero)
    }

    /// The length, and whether it is exact; if it is no fraction, it has 256 bits.
    #[must_use]
    pub fn length(&self) -> (RBig, bool) {
        square_root(&self.dot(self))
    }

    /// The parallel vector whose first component other than zero is 1.
    ///
    /// The second value is true if it points the opposite way. The zero vector stays.
    #[must_use]
    pub fn canonical(&self) -> (Self, bool) {
        match self.0.iter().find(|component| !component.is_zero()) {
            Some(first) => {
                let turned = first < &RBig::ZERO;
                (
                    Self(std::array::from_fn(|axis| &self.0[axis] / first)),
                    turned,
                )
            }
            None => (self.clone(), false),
        }
    }

    /// The parallel unit vector, each component rounded once; zero if this is zero.
    #[must_use]
    pub fn unit(&self) -> DVec3 {
        let [x, y, z] = &self.0;
        // Most vectors of scenes are along an axis and need no computation.
        match (x.is_zero(), y.is_zero(), z.is_zero()) {
            (false, true, true) => return DVec3::X * signum(x),
            (true, false, true) => return DVec3::Y * signum(y),
            (true, true, false) => return DVec3::Z * signum(z),
            _ => {}
        }
        let (length, _) = self.length();
        if length.is_zero() {
            return DVec3::ZERO;
        }
        self.times(&(RBig::ONE / length)).rounded()
    }

    /// The shortest parallel vector of whole numbers; `None` if doubles cannot hold it.
    #[must_use]
    pub fn whole(&self) -> Option<DVec3> {
        const LARGEST: f64 = 9_007_199_254_740_992.0; // 2^53
        let denominators = self.0.iter().map(|component| component.denominator());
        let multiple = denominators.fold(UBig::ONE, |multiple, other| {
            &multiple * other / (&multiple).gcd(other)
        });
        let whole = self.times(&RBig::from(multiple));
        let parts = whole
            .0
            .iter()
            .map(|component| component.numerator().clone().unsigned_abs());
        let divisor = parts.fold(UBig::ZERO, |divisor, part| {
            if part.is_zero() {
                divisor
            } else if divisor.is_zero() {
                part
            } else {
                divisor.gcd(part)
            }
        });
        if divisor.is_zero() {
            return None;
        }
        let shortest = whole.times(&RBig::from_parts(1.into(), divisor)).rounded();
        (shortest.abs().max_element() <= LARGEST).then_some(shortest)
    }

    /// The nearest vector of doubles.
    #[must_use]
    pub fn rounded(&self) -> DVec3 {
        let [x, y, z] = &self.0;
        DVec3::new(rounded(x), rounded(y), rounded(z))
    }
}

fn signum(number: &RBig) -> f64 {
    if number < &RBig::ZERO { -1.0 } else { 1.0 }
}

fn rounded(number: &RBig) -> f64 {
    number.to_f64().value()
}

/// The square root, and whether it is exact; if it is no fraction, it has 256 bits.
///
/// Zero for a number that is not positive.
fn square_root(number: &RBig) -> (RBig, bool) {
    const BITS: usize = 256;
    if number <= &RBig::ZERO {
        return (RBig::ZERO, true);
    }
    let (numerator, denominator) = number.clone().into_parts();
    let numerator: UBig = numerator.try_into().unwrap_or_default();
    let (root_of_numerator, root_of_denominator) = (numerator.sqrt(), denominator.sqrt());
    let is_root = |root: &UBig, of: &UBig| &(root * root) == of;
    if is_root(&root_of_numerator, &numerator) && is_root(&root_of_denominator, &denominator) {
        let root = RBig::from_parts(root_of_numerator.into(), root_of_denominator);
        return (root, true);
    }
    // √(n/d) = √(n·d)/d, with enough zeros behind n·d that its root has the bits.
    let product = numerator * &denominator;
    let lacking = (2 * BITS).saturating_sub(product.bit_len()).div_ceil(2);
    let root = (product << (2 * lacking)).sqrt();
    (
        RBig::from_parts(IBig::from(root), denominator << lacking),
        false,
    )
}

impl Add for &RationalVector {
    type Output = RationalVector;

    fn add(self, other: Self) -> RationalVector {
        RationalVector(std::array::from_fn(|axis| &self.0[axis] + &other.0[axis]))
    }
}

impl Sub for &RationalVector {
    type Output = RationalVector;

    fn sub(self, other: Self) -> RationalVector {
        RationalVector(std::array::from_fn(|axis| &self.0[axis] - &other.0[axis]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_of_any_length_become_unit() {
        for exponent in -300..=300 {
            let given = ["3", "-4", "12"].map(|digits| format!("{digits}e{exponent}").parse());
            let given = given.map(|number| number.expect("a number"));
            let unit = RationalVector::of_decimals(DVec3::from_array(given)).unit();
            assert_eq!(
                unit,
                DVec3::new(3.0 / 13.0, -4.0 / 13.0, 12.0 / 13.0),
                "{exponent}"
            );
        }
        let tiny = RationalVector::of_decimals(DVec3::splat(5e-324)).unit();
        assert_eq!(tiny, DVec3::splat(0.577_350_269_189_625_7));
    }

    #[test]
    fn roots_are_exact_where_they_can_be() {
        assert_eq!(square_root(&decimal(2.25)), (decimal(1.5), true));
        let (root, exact) = square_root(&RBig::from(2));
        assert!(!exact);
        let error = &root * &root - RBig::from(2);
        assert!(error.to_f64_fast().abs() < 1e-76, "{error}");
    }
}
