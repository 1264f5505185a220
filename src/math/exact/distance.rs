//! Exact distances along a ray.

use std::cmp::Ordering;

use super::{Exact, Sign};

/// A distance along a ray: `(whole ± √square) / divisor`.
///
/// This is the form of a root of a quadratic equation and, without the root, of a quotient.
#[derive(Debug, Clone)]
pub struct Distance {
    whole: Exact,
    /// The sign of the square root.
    root: Sign,
    square: Exact,
    divisor: Exact,
}

impl Distance {
    /// `height / slope`: the distance of a plane. The slope is not zero.
    #[must_use]
    pub fn quotient(height: Exact, slope: Exact) -> Self {
        let (whole, divisor) = match slope.sign() {
            Sign::Negative => (-&height, -&slope),
            Sign::Zero | Sign::Positive => (height, slope),
        };
        Self {
            whole,
            root: Sign::Zero,
            square: Exact::ZERO,
            divisor,
        }
    }

    /// The smaller root of `a t² − 2 b t + c = 0`, for `a > 0` and `b² ≥ a c`.
    #[must_use]
    pub fn smaller_root(a: Exact, b: Exact, c: &Exact) -> Self {
        Self {
            root: Sign::Negative,
            square: &b.squared() - &(&a * c),
            whole: b,
            divisor: a,
        }
    }

    /// The larger root of the same equation.
    #[must_use]
    pub fn larger_root(a: Exact, b: Exact, c: &Exact) -> Self {
        Self {
            root: Sign::Positive,
            ..Self::smaller_root(a, b, c)
        }
    }

    /// The order of two distances.
    #[must_use]
    pub fn compare(&self, other: &Self) -> Ordering {
        // Compares p₁/a₁ ± √x₁/a₁ with p₂/a₂ ± √x₂/a₂ after multiplication by both divisors, which
        // are positive.
        let rational = &(&self.whole * &other.divisor) - &(&other.whole * &self.divisor);
        let ours = &self.square * &other.divisor.squared();
        let theirs = &other.square * &self.divisor.squared();
        match sign_of_sum(&rational, (self.root, &ours), (-other.root, &theirs)) {
            Sign::Negative => Ordering::Less,
            Sign::Zero => Ordering::Equal,
            Sign::Positive => Ordering::Greater,
        }
    }
}

/// The sign of `rational ± √first ± √second`, found by squaring.
fn sign_of_sum(
    rational: &Exact,
    (of_first, first): (Sign, &Exact),
    (of_second, second): (Sign, &Exact),
) -> Sign {
    let sign = rational.sign();
    let roots = sign_of_roots((of_first, first), (of_second, second));
    if sign == roots || roots == Sign::Zero {
        return sign;
    }
    if sign == Sign::Zero {
        return roots;
    }
    // The two parts have opposite signs: compare rational² with (√first ± √second)², which is
    // first + second ± 2 √(first·second). With `rest` = rational² − first − second, the rational
    // part is larger exactly if rest > ±2 √(first·second).
    let rest = &(&rational.squared() - first) - second;
    let product = &(first * second) * &Exact::from(4.0);
    let mixed = of_first * of_second * product.sign();
    let larger = match rest.sign().cmp(&mixed) {
        Ordering::Less => Sign::Negative,
        Ordering::Equal => (&rest.squared() - &product).sign() * mixed,
        Ordering::Greater => Sign::Positive,
    };
    larger * sign
}

/// The sign of `±√first ± √second`.
fn sign_of_roots((of_first, first): (Sign, &Exact), (of_second, second): (Sign, &Exact)) -> Sign {
    let (one, other) = (of_first * first.sign(), of_second * second.sign());
    if one == -other {
        return one * (first - second).sign();
    }
    if one == Sign::Zero { other } else { one }
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
        assert_eq!(
            two.compare(&quotient(2.0f64.next_up(), 1.0)),
            Ordering::Less
        );
        assert_eq!(
            quotient(2.0f64.next_down(), 1.0).compare(&two),
            Ordering::Less
        );
        assert_eq!(little.compare(&two), Ordering::Less);
        assert_eq!(two.compare(&little), Ordering::Greater);
        assert_eq!(
            little.compare(&quotient(0.267_949_192_431_122_7, 1.0)),
            Ordering::Greater
        );
        assert_eq!(
            little.compare(&quotient(0.267_949_192_431_122_75, 1.0)),
            Ordering::Less
        );
        // The same root in another scale.
        assert_eq!(little.compare(&root(3.0, 6.0, 3.0)), Ordering::Equal);
    }
    #[test]
    fn larger_roots_are_ordered_too() {
        let larger = |a: f64, b: f64, c: f64| Distance::larger_root(a.into(), b.into(), &c.into());
        // 2 and 4; 2 ± √3; 3 ± √5; and 2 ± √3 doubled, which is 4 ± √12.
        let equations = [
            (1.0, 3.0, 8.0),
            (1.0, 2.0, 1.0),
            (1.0, 3.0, 4.0),
            (1.0, 4.0, 4.0),
        ];
        let mut all: Vec<(f64, Distance)> =
            vec![(1.0, quotient(1.0, 1.0)), (4.0, quotient(8.0, 2.0))];
        for (a, b, c) in equations {
            let half = f64::sqrt(b * b - a * c);
            all.push((b - half, root(a, b, c)));
            all.push((b + half, larger(a, b, c)));
            all.push((-b - half, root(a, -b, c)));
            all.push((-b + half, larger(a, -b, c)));
        }
        for (value, distance) in &all {
            for (other_value, other) in &all {
                let expected = value.partial_cmp(other_value).expect("numbers");
                assert_eq!(distance.compare(other), expected, "{value} {other_value}");
            }
        }
        // 2 + √3 = 3.732050807568877293…
        let (below, above) = (3.732_050_807_568_877, 3.732_050_807_568_877_7);
        assert_eq!(
            larger(3.0, 6.0, 3.0).compare(&quotient(below, 1.0)),
            Ordering::Greater
        );
        assert_eq!(
            larger(3.0, 6.0, 3.0).compare(&quotient(above, 1.0)),
            Ordering::Less
        );
        // A touch: both roots are 3.
        assert_eq!(
            larger(1.0, 3.0, 9.0).compare(&root(1.0, 3.0, 9.0)),
            Ordering::Equal
        );
    }
}
