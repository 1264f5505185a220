//! The decimal number from which a double was read.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

/// The shortest decimal that reads as this double, as a fraction; 0 if not finite.
///
/// A scene file says 0.1, 0.2 and 0.3, of which none is a double, and means 0.1 + 0.2 = 0.3. A
/// decimal of up to 15 digits is the shortest that reads as its double, so it keeps its value.
/// Longer ones lose the digits beyond the double's precision.
#[must_use]
pub fn decimal(number: f64) -> RBig {
    const LARGEST_WHOLE: f64 = 9_007_199_254_740_992.0; // 2^53
    if !number.is_finite() {
        return RBig::ZERO;
    }
    #[expect(clippy::cast_possible_truncation, reason = "whole and small")]
    if number.fract() == 0.0 && number.abs() <= LARGEST_WHOLE {
        return RBig::from(IBig::from(number as i64));
    }
    let text = format!("{number:e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    // At most 17 digits, so this fits.
    let significand: i64 = format!("{whole}{fraction}").parse().unwrap_or_default();
    let exponent: i32 = exponent.parse().unwrap_or_default();
    let power = exponent - i32::try_from(fraction.len()).unwrap_or_default();
    let ten = UBig::from(10u8).pow(power.unsigned_abs() as usize);
    if power < 0 {
        RBig::from_parts(significand.into(), ten)
    } else {
        RBig::from(IBig::from(significand) * ten)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_mean_what_is_written() {
        let tenths = |tenths: i64| RBig::from_parts(tenths.into(), 10u8.into());
        assert_eq!(decimal(0.1) + decimal(0.2), decimal(0.3));
        assert_eq!(decimal(-0.7), tenths(-7));
        assert_eq!(decimal(1e300), RBig::from(UBig::from(10u8).pow(300)));
        assert_eq!(decimal(-5e-324).numerator(), &IBig::from(-1));
        assert_eq!(
            decimal(6e15) / RBig::from(2),
            RBig::from(3_000_000_000_000_000i64)
        );
        assert_eq!(decimal(-0.0), RBig::ZERO);
    }
}
