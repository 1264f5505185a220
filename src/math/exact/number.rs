//! Numbers without rounding.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use dashu_int::ops::BitTest;
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

/// A whole number times a power of two: finite doubles, their sums and products.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Exact {
    significand: IBig,
    exponent: i64,
}

/// The certain sign of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Sign {
    /// Below zero.
    Negative,
    /// Zero.
    Zero,
    /// Above zero.
    Positive,
}

impl Exact {
    /// Zero.
    pub const ZERO: Self = Self {
        significand: IBig::ZERO,
        exponent: 0,
    };

    /// The sign.
    #[must_use]
    pub fn sign(&self) -> Sign {
        match self.significand.cmp(&IBig::ZERO) {
            Ordering::Less => Sign::Negative,
            Ordering::Equal => Sign::Zero,
            Ordering::Greater => Sign::Positive,
        }
    }

    /// The number times itself.
    #[must_use]
    pub fn squared(&self) -> Self {
        self * self
    }

    /// A double near the number: right to about 60 bits before its last rounding.
    ///
    /// Infinite beyond the range of doubles.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        const KEPT: i64 = 60;
        let length = i64::try_from(self.significand.bit_len()).unwrap_or(i64::MAX);
        let dropped = (length - KEPT).max(0);
        let shift = usize::try_from(dropped).unwrap_or(usize::MAX);
        let leading = i64::try_from(&self.significand >> shift).unwrap_or_default();
        let exponent = (self.exponent + dropped).clamp(-4000, 4000);
        #[expect(clippy::cast_precision_loss, reason = "this is the one rounding")]
        #[expect(clippy::cast_possible_truncation, reason = "clamped")]
        libm::scalbn(leading as f64, exponent as i32)
    }

    /// The number as a fraction.
    #[must_use]
    pub fn to_rational(&self) -> RBig {
        let power = usize::try_from(self.exponent.unsigned_abs()).unwrap_or(usize::MAX);
        if self.exponent < 0 {
            RBig::from_parts(self.significand.clone(), UBig::ONE << power)
        } else {
            RBig::from(&self.significand << power)
        }
    }

    /// Both significands for the same, smaller exponent.
    fn aligned(&self, other: &Self) -> (IBig, IBig, i64) {
        let shift = |exponent: i64| usize::try_from(exponent).unwrap_or(usize::MAX);
        let gap = self.exponent - other.exponent;
        if gap <= 0 {
            let raised = &other.significand << shift(-gap);
            (self.significand.clone(), raised, self.exponent)
        } else {
            let raised = &self.significand << shift(gap);
            (raised, other.significand.clone(), other.exponent)
        }
    }
}

impl From<f64> for Exact {
    /// The exact value of a finite double; zero for others, which no scene holds.
    fn from(number: f64) -> Self {
        const FRACTION: u64 = (1 << 52) - 1;
        const SMALLEST_EXPONENT: i64 = -1074;
        let bits = number.to_bits();
        let biased = (bits >> 52 & 0x7ff).cast_signed();
        let fraction = (bits & FRACTION).cast_signed();
        let (significand, exponent) = match biased {
            0 => (fraction, SMALLEST_EXPONENT),
            0x7ff => (0, 0),
            _ => (fraction | 1 << 52, biased - 1 + SMALLEST_EXPONENT),
        };
        if significand == 0 {
            return Self::ZERO;
        }
        let twos = significand.trailing_zeros();
        let significand = significand >> twos;
        let signed = if number < 0.0 {
            -significand
        } else {
            significand
        };
        Self {
            significand: IBig::from(signed),
            exponent: exponent + i64::from(twos),
        }
    }
}

impl Add for &Exact {
    type Output = Exact;

    fn add(self, other: Self) -> Exact {
        if other.significand.is_zero() {
            return self.clone();
        }
        if self.significand.is_zero() {
            return other.clone();
        }
        let (left, right, exponent) = self.aligned(other);
        Exact {
            significand: left + right,
            exponent,
        }
    }
}

impl Neg for &Exact {
    type Output = Exact;

    fn neg(self) -> Exact {
        Exact {
            significand: -&self.significand,
            exponent: self.exponent,
        }
    }
}

impl Sub for &Exact {
    type Output = Exact;

    fn sub(self, other: Self) -> Exact {
        self + &-other
    }
}

impl Mul for &Exact {
    type Output = Exact;

    fn mul(self, other: Self) -> Exact {
        if self.significand.is_zero() || other.significand.is_zero() {
            return Exact::ZERO;
        }
        Exact {
            significand: &self.significand * &other.significand,
            exponent: self.exponent + other.exponent,
        }
    }
}

impl Sign {
    /// The sign of a double that is certain.
    #[must_use]
    pub fn of(number: f64) -> Self {
        if number > 0.0 {
            Self::Positive
        } else if number < 0.0 {
            Self::Negative
        } else {
            Self::Zero
        }
    }
}

impl Neg for Sign {
    type Output = Self;

    fn neg(self) -> Self {
        match self {
            Self::Negative => Self::Positive,
            Self::Zero => Self::Zero,
            Self::Positive => Self::Negative,
        }
    }
}

impl Mul for Sign {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        match self {
            Self::Negative => -other,
            Self::Zero => Self::Zero,
            Self::Positive => other,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_lost() {
        let tenth = Exact::from(0.1);
        let sum = &(&tenth + &tenth) + &tenth;
        // In doubles 0.1 + 0.1 + 0.1 is 0.30000000000000004; exactly it is above the double 0.3
        // too, but by less than one rounding.
        assert_eq!((&sum - &Exact::from(0.3)).sign(), Sign::Positive);
        assert_eq!(
            (&sum - &Exact::from(0.1 + 0.1 + 0.1)).sign(),
            Sign::Negative
        );
        let tiny = Exact::from(5e-324);
        let huge = Exact::from(f64::MAX);
        assert_eq!((&(&huge + &tiny) - &huge), tiny);
        assert_eq!((&tiny * &tiny).sign(), Sign::Positive);
    }

    #[test]
    fn doubles_come_back() {
        for number in [
            0.0,
            1.0,
            -0.1,
            5e-324,
            f64::MAX,
            -2f64.powi(-1000),
            1.0 / 3.0,
        ] {
            assert_eq!(Exact::from(number).to_f64(), number);
        }
    }
}
