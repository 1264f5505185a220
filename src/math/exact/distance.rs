//! How far along a ray a surface is, exactly.

use std::cmp::Ordering;

use super::{Exact, Sign};

/// A distance along a ray: `(whole − √square) / divisor`, the form of the nearer root of a
/// quadratic equation and, without the root, of a quotient.
#[derive(Debug, Clone)]
pub struct Distance {
    whole: Exact,
    square: Exact,
    divisor: Exact,
}

impl Distance {
    /// `height / slope`: the distance of a plane; the slope is not zero.
    #[must_use]
    pub fn quotient(height: Exact, slope: Exact) -> Self {
        let (whole, divisor) = match slope.sign() {
            Sign::Negative => (-&height, -&slope),
            Sign::Zero | Sign::Positive => (height, slope),
        };
        Self {
            whole,
            square: Exact::ZERO,
            divisor,
        }
    }

    /// The smaller root of `a t² − 2 b t + c = 0`, for `a > 0` and `b² ≥ a c`.
    #[must_use]
    pub fn smaller_root(a: Exact, b: Exact, c: &Exact) -> Self {
        Self {
            square: &b.squared() - &(&a * c),
            whole: b,
            divisor: a,
        }
    }

    /// The order of two distances.
    #[must_use]
    pub fn compare(&self, other: &Self) -> Ordering {
        // Of p₁/a₁ − √x₁/a₁ and p₂/a₂ − √x₂/a₂, multiplied by both divisors, which are positive.
        let rational = &(&self.whole * &other.divisor) - &(&other.whole * &self.divisor);
        let ours = &self.square * &other.divisor.squared();
        let theirs = &other.square * &self.divisor.squared();
        match sign_of_sum(&rational, &theirs, &ours) {
            Sign::Negative => Ordering::Less,
            Sign::Zero => Ordering::Equal,
            Sign::Positive => Ordering::Greater,
        }
    }
}

/// The sign of `rational + √plus − √minus`, by squaring away one root after the other.
fn sign_of_sum(rational: &Exact, plus: &Exact, minus: &Exact) -> Sign {
    let roots = (plus - minus).sign();
    let sign = rational.sign();
    if sign == roots || roots == Sign::Zero {
        return sign;
    }
    if sign == Sign::Zero {
        return roots;
    }
    // The two parts pull in opposite directions: compare rational² with (√plus − √minus)², which
    // is plus + minus − 2 √(plus·minus). With `rest` = rational² − plus − minus, the larger part
    // is the rational one exactly if rest > −2 √(plus·minus).
    let rest = &(&rational.squared() - plus) - minus;
    let product = &(plus * minus) * &Exact::from(4.0);
    let larger = match rest.sign() {
        Sign::Positive => Sign::Positive,
        Sign::Zero => product.sign(),
        Sign::Negative => (&product - &rest.squared()).sign(),
    };
    larger * sign
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root(a: f64, b: f64, c: f64) -> Distance {
        Distance::smaller_root(a.into(), b.into(), &c.into())
    }

    fn quotient(height: f64, slope: f64) -> Distance {
        Distance::quotient(height.into(), slope.into())
    }

    #[test]
    fn quotients_and_roots_are_ordered() {
        // t² − 6 t + 8 = 0 has the roots 2 and 4; t² − 4 t + 1 = 0 has 2 − √3 = 0.268 as smaller.
        let (two, little) = (root(1.0, 3.0, 8.0), root(1.0, 2.0, 1.0));
        assert_eq!(two.compare(&quotient(2.0, 1.0)), Ordering::Equal);
        assert_eq!(two.compare(&quotient(-4.0, -2.0)), Ordering::Equal);
        assert_eq!(two.compare(&quotient(2.0f64.next_up(), 1.0)), Ordering::Less);
        assert_eq!(quotient(2.0f64.next_down(), 1.0).compare(&two), Ordering::Less);
        assert_eq!(little.compare(&two), Ordering::Less);
        assert_eq!(two.compare(&little), Ordering::Greater);
        assert_eq!(little.compare(&quotient(0.267_949_192_431_122_7, 1.0)), Ordering::Greater);
        assert_eq!(little.compare(&quotient(0.267_949_192_431_122_75, 1.0)), Ordering::Less);
        // The same root in another scale.
        assert_eq!(little.compare(&root(3.0, 6.0, 3.0)), Ordering::Equal);
    }
}
