//! Perceptual colours.

use glam::{DMat3, DVec3};

use crate::film::Transfer;

/// CIE L\*a\*b\* (1976), with a\* and b\* reduced in the dark (Hunt 1952).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lab([f64; 3]);

impl Lab {
    /// Colour of CIE X, Y and Z, each 1 for white.
    pub(super) fn of_xyz(xyz: DVec3) -> Self {
        /// Cube root below which the curve is a straight line.
        const DARK: f64 = 6.0 / 29.0;
        let [x, y, z] = xyz.to_array().map(|it| {
            if it > DARK * DARK * DARK {
                libm::cbrt(it)
            } else {
                it / (3.0 * DARK * DARK) + 4.0 / 29.0
            }
        });
        let lightness = 116.0 * y - 16.0;
        let hunt = lightness / 100.0;
        Self([lightness, 500.0 * (x - y) * hunt, 200.0 * (y - z) * hunt])
    }

    /// Difference of two colours, also large ones (`HyAB`; Abasi, Amani Tehran and Fairchild 2020).
    pub(super) fn difference(self, other: Self) -> f64 {
        let [lightness, a, b] = [0, 1, 2].map(|axis| self.0[axis] - other.0[axis]);
        lightness.abs() + (a * a + b * b).sqrt()
    }

    /// Largest difference of sRGB colours: that of green and blue.
    pub(super) fn largest_difference() -> f64 {
        let [green, blue] = [DVec3::Y, DVec3::Z].map(|rgb| Self::of_xyz(xyz_of_rgb() * rgb));
        green.difference(blue)
    }
}

/// Matrix from linear sRGB to CIE X, Y and Z, each 1 for white (IEC 61966-2-1:1999).
pub(super) fn xyz_of_rgb() -> DMat3 {
    let primaries =
        DMat3::from_cols_array_2d(&[[0.64, 0.33, 0.03], [0.30, 0.60, 0.10], [0.15, 0.06, 0.79]]);
    let white = DVec3::new(0.3127, 0.3290, 0.3583);
    let scaled = primaries * DMat3::from_diagonal(primaries.inverse() * white);
    DMat3::from_diagonal(white.recip()) * scaled
}

/// Intensity of an sRGB value, limited to 0 to 1, within 3e-8 by linear interpolation.
///
/// Twenty times as fast as a power.
pub(super) fn intensity_of_value() -> impl Fn(f64) -> f64 + Sync {
    const STEPS: u16 = 16 * 255;
    let steps = (0..=STEPS).map(|step| f64::from(step) / f64::from(STEPS));
    let curve: Vec<_> = steps.map(|value| Transfer::Srgb.intensity(value)).collect();
    move |value| {
        let place = value.clamp(0.0, 1.0) * f64::from(STEPS);
        #[expect(clippy::cast_possible_truncation, reason = "limited")]
        #[expect(clippy::cast_sign_loss, reason = "not negative")]
        let step = (place as u16).min(STEPS - 1);
        let [low, high] = [0, 1].map(|next| curve[usize::from(step + next)]);
        low + (place - f64::from(step)) * (high - low)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn straight_lines_are_close_to_the_curve() {
        let intensity = intensity_of_value();
        for step in 0..=9999 {
            let value = f64::from(step) / 9999.0;
            let off = intensity(value) - Transfer::Srgb.intensity(value);
            assert!(off.abs() <= 3e-8, "{value}: {off}");
        }
        assert_eq!([-1.0, 2.0].map(intensity), [0.0, 1.0]);
    }

    fn lab(rgb: [f64; 3]) -> Lab {
        Lab::of_xyz(xyz_of_rgb() * DVec3::from(rgb))
    }

    #[test]
    fn red_and_white_are_where_tables_have_them() {
        // Of red, tables have L* = 53.24, a* = 80.09 and b* = 67.20.
        for (rgb, expected) in [
            ([1.0; 3], [100.0, 0.0, 0.0]),
            ([0.0; 3], [0.0; 3]),
            ([1.0, 0.0, 0.0], [53.24, 0.5324 * 80.09, 0.5324 * 67.20]),
        ] {
            for (found, expected) in lab(rgb).0.iter().zip(expected) {
                assert!((found - expected).abs() < 0.01, "{rgb:?}: {found}");
            }
        }
    }

    #[test]
    fn no_colors_are_more_different_than_green_and_blue() {
        let steps = [0.0, 0.01, 0.1, 0.4, 1.0];
        let colors = steps.iter().flat_map(|r| steps.map(|g| (*r, g)));
        let colors = colors.flat_map(|(r, g)| steps.map(|b| lab([r, g, b])));
        let colors: Vec<_> = colors.collect();
        let pairs = colors
            .iter()
            .flat_map(|one| colors.iter().map(move |other| (one, other)));
        let most = pairs
            .map(|(one, other)| one.difference(*other))
            .fold(0.0, f64::max);
        assert_eq!(most, Lab::largest_difference());
    }
}
