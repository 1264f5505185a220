//! Unit vectors along directions of any length, without overflow or underflow.

use glam::DVec3;

/// The unit vector along `vector`; `None` if it is zero or not finite.
///
/// All lengths from 1e-300 to 1e300 are valid. Very long and very short vectors are first scaled by
/// a power of two, which is exact.
#[must_use]
pub fn unit(vector: DVec3) -> Option<DVec3> {
    let largest = vector.abs().max_element();
    if !(vector.is_finite() && largest > 0.0) {
        return None;
    }
    let middle = 2f64.powi(-400)..2f64.powi(400);
    let scaled = if middle.contains(&largest) {
        vector
    } else if largest < 1.0 {
        vector * 2f64.powi(600)
    } else {
        vector * 2f64.powi(-600)
    };
    Some(direction(scaled))
}

/// The unit vector along a vector that is neither zero nor extreme.
///
/// A division has one rounding less than a product with the reciprocal.
#[must_use]
pub fn direction(vector: DVec3) -> DVec3 {
    vector / vector.length()
}

/// The reflected direction of a unit direction at a surface with this unit normal.
///
/// It leads to the side that the direction came from, or along the surface.
// Rounding can turn a grazing direction through the mirror. Then the part along the normal is
// replaced by that of the reflected direction.
#[must_use]
pub(super) fn reflected(dir: DVec3, normal: DVec3) -> DVec3 {
    let falls = dir.dot(normal);
    let mirrored = direction(dir - normal * (2.0 * falls));
    let rises = mirrored.dot(normal);
    if rises * falls <= 0.0 {
        return mirrored;
    }
    direction(mirrored - normal * (rises + falls))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_length_gives_a_unit_vector() {
        for exponent in -300..=300 {
            let length = 10f64.powi(exponent);
            let vector = unit(DVec3::new(3.0, -4.0, 12.0) * length).expect("not zero");
            assert!(
                (vector.length_squared() - 1.0).abs() <= 4.0 * f64::EPSILON,
                "{exponent}"
            );
        }
        assert_eq!(unit(DVec3::new(0.0, 5e-324, 0.0)), Some(DVec3::Y));
    }

    #[test]
    fn zero_and_the_infinite_have_no_direction() {
        assert_eq!(unit(DVec3::ZERO), None);
        assert_eq!(unit(DVec3::new(f64::INFINITY, 0.0, 0.0)), None);
        assert_eq!(unit(DVec3::new(f64::NAN, 1.0, 0.0)), None);
    }
}
