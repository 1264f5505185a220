//! Computes sines, cosines and angles by polynomials, equal on every platform.
//!
//! The standard library's versions differ between platforms in the last bits.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

/// The sine of an angle in radians, to about 1e-9.
pub(crate) fn sine(angle: f64) -> f64 {
    let turn = angle / TAU;
    let mut x = (turn - (turn + 0.5).floor()) * TAU;
    // Fold into the quarter around zero, where the series is short.
    if x > FRAC_PI_2 {
        x = PI - x;
    } else if x < -FRAC_PI_2 {
        x = -PI - x;
    }
    let s = x * x;
    let tail = 1.0 - s / 110.0 * (1.0 - s / 156.0);
    x * (1.0 - s / 6.0 * (1.0 - s / 20.0 * (1.0 - s / 42.0 * (1.0 - s / 72.0 * tail))))
}

/// The cosine of an angle in radians.
pub(crate) fn cosine(angle: f64) -> f64 {
    sine(angle + FRAC_PI_2)
}

/// The angle of the vector (x, y) against the x axis, from -pi to pi.
pub(crate) fn direction(x: f64, y: f64) -> f64 {
    let (low, high) = (x.abs().min(y.abs()), x.abs().max(y.abs()));
    if high == 0.0 {
        return 0.0;
    }
    let slope = low / high;
    // One halving of the angle around pi/8 keeps the series short.
    let (base, t) = if slope > 0.414 {
        (FRAC_PI_4, (slope - 1.0) / (slope + 1.0))
    } else {
        (0.0, slope)
    };
    let s = t * t;
    let series = 1.0 / 9.0 - s * (1.0 / 11.0 - s * (1.0 / 13.0 - s / 15.0));
    let mut angle =
        base + t * (1.0 - s * (1.0 / 3.0 - s * (1.0 / 5.0 - s * (1.0 / 7.0 - s * series))));
    if y.abs() > x.abs() {
        angle = FRAC_PI_2 - angle;
    }
    if x < 0.0 {
        angle = PI - angle;
    }
    if y < 0.0 { -angle } else { angle }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_the_standard_library() {
        for step in -500..=500 {
            let angle = f64::from(step) * 0.02;
            assert!((sine(angle) - angle.sin()).abs() < 1e-7);
            assert!((cosine(angle) - angle.cos()).abs() < 1e-7);
            let (y, x) = angle.sin_cos();
            assert!((direction(x, y) - y.atan2(x)).abs() < 1e-6);
        }
    }
}
