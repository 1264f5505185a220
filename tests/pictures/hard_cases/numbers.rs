//! Exact numbers: decimals and fractions as they are written, and the doubles next to them.

use std::str::FromStr;

use dashu::integer::IBig;
use dashu::rational::RBig;

/// The number that a decimal (`-1.5e-7`) or a fraction of two of them (`2/3`) stands for.
pub(crate) fn exact(text: &str) -> RBig {
    match text.split_once('/') {
        Some((above, below)) => decimal(above) / decimal(below),
        None => decimal(text),
    }
}

/// A decimal, digit for digit.
fn decimal(text: &str) -> RBig {
    let (digits, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let digits = IBig::from_str(&format!("{whole}{fraction}"));
    let digits = digits.unwrap_or_else(|_| panic!("{text:?} is not a decimal"));
    let exponent: Option<i64> = exponent.parse().ok();
    let exponent = exponent.unwrap_or_else(|| panic!("{text:?} is not a decimal"));
    let places = exponent - i64::try_from(fraction.len()).unwrap();
    let scale = RBig::from(IBig::from(10).pow(usize::try_from(places.abs()).unwrap()));
    if places < 0 {
        RBig::from(digits) / scale
    } else {
        RBig::from(digits) * scale
    }
}

/// The number that a double is.
pub(crate) fn of(double: f64) -> RBig {
    RBig::try_from(double).unwrap_or_else(|_| panic!("{double} is not finite"))
}

/// The shortest decimal that reads as this double: what a scene means by it.
pub(crate) fn meant(double: f64) -> RBig {
    decimal(&format!("{double:?}"))
}

/// The double nearest to a number.
pub(crate) fn nearest(number: &RBig) -> f64 {
    number.to_f64().value()
}

/// The double nearest to a decimal or fraction; zeros keep their sign.
pub(crate) fn double(text: &str) -> f64 {
    text.parse().unwrap_or_else(|_| nearest(&exact(text)))
}

/// The words of a text.
pub(crate) fn words<const N: usize>(text: &str) -> [&str; N] {
    let words: Vec<_> = text.split_whitespace().collect();
    let count = words.len();
    words
        .try_into()
        .unwrap_or_else(|_| panic!("{text:?} has {count} words, expected {N}"))
}

/// Three doubles.
pub(crate) fn triple(text: &str) -> [f64; 3] {
    words(text).map(double)
}

/// The double so many steps above (or below) this one; from zero, multiples of 2^-200.
///
/// Products of four of these are still above all denormals, which have cases of their own.
pub(crate) fn stepped(double: f64, steps: i32) -> f64 {
    if double == 0.0 {
        return f64::from(steps) * 2f64.powi(-200);
    }
    let next = if steps < 0 {
        f64::next_down
    } else {
        f64::next_up
    };
    (0..steps.abs()).fold(double, |double, _| next(double))
}

/// How far a double may be from the truth: `2 ulp` of the double nearest to it, or a number.
pub(crate) fn allowed(within: &str, truth: &RBig) -> RBig {
    match within.split_once(' ') {
        Some((count, "ulp")) => {
            let size = nearest(truth).abs();
            exact(count) * (of(size.next_up()) - of(size))
        }
        _ => exact(within),
    }
}

/// Whether a double is the truth, but for what is allowed.
pub(crate) fn is_close(found: f64, truth: &RBig, within: &str) -> bool {
    if !found.is_finite() {
        return false;
    }
    let off = of(found) - truth;
    let off = if off < RBig::ZERO { -off } else { off };
    off <= allowed(within, truth)
}
