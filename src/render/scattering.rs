//! Scattering of rays at surfaces, and the growth of their errors.

use crate::math::error_bounds::{INCIDENCE, REFLECTION, refraction};

/// The type of scattering of a ray at a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scattering {
    /// Transmitted in the same direction, bit for bit.
    Straight,
    /// Reflected.
    Reflected,
    /// Refracted, with this ratio of the indices of refraction: before to behind.
    Refracted(f64),
}

impl Scattering {
    /// The lateral and the direction error behind a surface, from those before it.
    ///
    /// `tilt` is the error of the normal in radians, `cosine` that of the angle between normal and
    /// ray.
    pub(super) fn behind(self, [lateral, direction]: [f64; 2], tilt: f64, cosine: f64) -> [f64; 2] {
        let [lateral, direction] = match self {
            Self::Straight => [lateral, direction],
            Self::Reflected => [lateral, mirrored(direction, tilt)],
            Self::Refracted(ratio) => refracted([lateral, direction], tilt, ratio, cosine),
        };
        // First-order estimates do not hold for large angles.
        let is_small = direction < 1.0;
        [lateral, if is_small { direction } else { f64::INFINITY }]
    }
}

/// The direction error behind a mirror whose normal is off by `tilt`.
fn mirrored(direction: f64, tilt: f64) -> f64 {
    // An error of the normal counts twice.
    direction + 2.0 * tilt + REFLECTION
}

/// The lateral error and the direction error of a refracted ray.
///
/// Infinite if total reflection is within the errors.
fn refracted([lateral, direction]: [f64; 2], tilt: f64, ratio: f64, cosine: f64) -> [f64; 2] {
    // With μ for the ratio, the law of refraction is sin β = μ sin α. An error of the arriving
    // direction in the plane of both rays grows by μ cos α / cos β. A rotation about the normal
    // rotates the parts along the surface by the same angle, and grows by μ. If the normal is off
    // by an angle, so is α, but β is measured from that normal. In the plane the ray is off by
    // |μ cos α / cos β − 1| times the angle, and across it by |μ cos α − cos β| times, which is
    // less.
    //
    // Toward the critical angle cos β goes to zero, and these factors grow without bound. So they
    // are evaluated for the largest possible α. If that one is reflected totally, there is no
    // bound.
    let angle = direction + tilt + INCIDENCE;
    let sine = (1.0 - cosine * cosine).sqrt();
    let most = ratio * (sine + angle);
    if most.is_nan() || most >= 1.0 {
        return [f64::INFINITY; 2];
    }
    let [cosine_at_least, cosine_at_most] = [ratio * (sine - angle).max(0.0), most]
        .map(|bent_sine| (1.0 - bent_sine * bent_sine).sqrt());
    let in_plane = ratio * (cosine + angle) / cosine_at_most;
    let of_tilt = if ratio > 1.0 {
        in_plane - 1.0
    } else {
        1.0 - ratio * (cosine - angle) / cosine_at_least
    };
    let rounding = refraction(ratio, cosine_at_most);
    let direction = direction * ratio.max(in_plane) + tilt * of_tilt + rounding;
    // A hit that moves along the surface by 1 / cos α moves the ray behind it by cos β / cos α.
    let widening = (cosine_at_least / cosine).max(1.0);
    [times(lateral, widening), direction]
}

/// A product of errors, in which zero times infinity is zero.
pub(super) fn times(error: f64, factor: f64) -> f64 {
    if error == 0.0 || factor == 0.0 {
        0.0
    } else {
        error * factor
    }
}

#[cfg(test)]
mod tests {
    use dashu::float::FBig;
    use glam::DVec3;

    use super::*;
    use crate::math::{Point, Ray, Refraction, direction};

    const RATIOS: [f64; 6] = [0.4, 1.0 / 1.5, 0.99, 1.333, 1.5, 2.4];

    fn falling(angle: f64) -> DVec3 {
        DVec3::new(libm::sin(angle), -libm::cos(angle), 0.0)
    }

    fn angles() -> impl Iterator<Item = f64> {
        (0..157).map(|hundredth| f64::from(hundredth) / 100.0)
    }

    fn scattered(dir: DVec3, normal: DVec3, scattering: Scattering) -> Option<DVec3> {
        match scattering {
            Scattering::Straight => Some(dir),
            Scattering::Reflected => {
                Some(Ray::new(Point::exact(DVec3::ZERO), dir).mirrored(normal))
            }
            Scattering::Refracted(ratio) => Refraction::new(dir, normal, ratio, 1.0).bent,
        }
    }

    /// The largest error of a scattered ray's direction, for errors of these sizes.
    ///
    /// The arriving direction is off by `off`, the normal by `tilt`. `None` for total reflection.
    fn largest(angle: f64, scattering: Scattering, off: f64, tilt: f64) -> Option<f64> {
        let dir = falling(angle);
        let across = [direction(dir.cross(DVec3::Z)), DVec3::Z];
        let expected = scattered(dir, DVec3::Y, scattering)?;
        let mut largest = 0f64;
        for step in 0..256 {
            let (first, second) = (f64::from(step % 16) / 8.0, f64::from(step / 16) / 8.0);
            let vector = |angle: f64, [x, y]: [DVec3; 2]| {
                let angle = angle * std::f64::consts::PI;
                x * libm::cos(angle) + y * libm::sin(angle)
            };
            let dir = direction(dir + vector(first, across) * off);
            let normal = direction(DVec3::Y + vector(second, [DVec3::X, DVec3::Z]) * tilt);
            largest = largest.max((scattered(dir, normal, scattering)? - expected).length());
        }
        Some(largest)
    }

    #[test]
    fn what_is_off_before_a_surface_is_off_behind_it_by_no_more_than_said() {
        let mut compared = 0;
        let scatterings = RATIOS
            .map(Scattering::Refracted)
            .into_iter()
            .chain([Scattering::Reflected, Scattering::Straight]);
        for scattering in scatterings {
            for angle in angles() {
                for (off, tilt) in [(1e-6, 0.0), (0.0, 1e-6), (1e-6, 1e-6), (1e-6, 1e-9)] {
                    let [_, said] = scattering.behind([0.0, off], tilt, libm::cos(angle));
                    let Some(found) = largest(angle, scattering, off, tilt) else {
                        assert!(said.is_infinite(), "{scattering:?} {angle}");
                        continue;
                    };
                    assert!(
                        found <= said * (1.0 + 1e-5) + 1e-15,
                        "{found} {said} {scattering:?} {angle}"
                    );
                    if let Scattering::Refracted(ratio) = scattering
                        && ratio * libm::sin(angle) > 0.999
                    {
                        continue;
                    }
                    assert!(
                        said <= 2.0 * found + 1e-13,
                        "{found} {said} {scattering:?} {angle} {off} {tilt}"
                    );
                    compared += 1;
                }
            }
        }
        assert!(compared > 3000, "{compared}");
    }

    #[test]
    fn near_total_reflection_nothing_is_known_and_never_not_a_number() {
        let critical = libm::asin(1.0 / 1.5);
        let near = |below: f64, lateral: f64, tilt: f64, direction: f64| {
            let cosine = libm::cos(critical - below);
            Scattering::Refracted(1.5).behind([lateral, direction], tilt, cosine)
        };
        assert!(near(1e-9, 0.0, 0.0, 0.0)[1] < 1e-9);
        assert!(near(1e-9, 0.0, 0.0, 1e-8)[1].is_infinite());
        let scatterings = [
            Scattering::Reflected,
            Scattering::Refracted(1.5),
            Scattering::Refracted(0.5),
            Scattering::Straight,
        ];
        for off in [0.0, 1e-300, 1e-9, 1.0, 1e300, f64::INFINITY] {
            for below in [0.0, 1e-16, 1e-12, 0.1, critical] {
                for direction in [0.0, 1e-9, f64::INFINITY] {
                    let mut errors = near(below, off, off, direction);
                    for scattering in scatterings {
                        for cosine in [0.0, 1.0, libm::cos(0.7)] {
                            errors = scattering.behind(errors, off, cosine);
                            assert!(errors.iter().all(|it| !it.is_nan()), "{errors:?}");
                        }
                    }
                }
            }
        }
    }

    type Big = FBig;

    fn big(number: f64) -> Big {
        Big::try_from(number)
            .expect("finite")
            .with_precision(300)
            .value()
    }

    /// The direction of a refracted ray, computed with hundreds of digits.
    fn bent_precisely(dir: DVec3, normal: DVec3, ratio: f64) -> [Big; 3] {
        let dot = |a: &[Big; 3], b: &[Big; 3]| &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2];
        let unit = |vector: DVec3| {
            let vector = vector.to_array().map(big);
            let length = dot(&vector, &vector).sqrt();
            vector.map(|it| it / &length)
        };
        let (dir, normal, ratio) = (unit(dir), unit(normal), big(ratio));
        let falls = -dot(&dir, &normal);
        let squared = &ratio * &ratio * (big(1.0) - &falls * &falls);
        let ahead = &ratio * falls - (big(1.0) - squared).sqrt();
        [0, 1, 2].map(|axis| &dir[axis] * &ratio + &normal[axis] * &ahead)
    }

    #[test]
    fn the_rounding_of_a_bend_is_within_what_is_said_and_not_far_below() {
        for ratio in RATIOS {
            for angle in angles().skip(1) {
                let (mut most, mut least_said) = (0f64, f64::INFINITY);
                for step in 0..24 {
                    let angle = angle + f64::from(step) * 1e-5;
                    let sideways = f64::from(step) * 0.3;
                    let normal = direction(DVec3::new(0.3, 0.9, sideways));
                    let along = direction(normal.cross(DVec3::new(1.0, sideways, 0.2)));
                    let dir = direction(along * libm::sin(angle) - normal * libm::cos(angle));
                    let Some(bent) = Refraction::new(dir, normal, ratio, 1.0).bent else {
                        continue;
                    };
                    let exact = bent_precisely(dir, normal, ratio);
                    let apart =
                        [0, 1, 2].map(|axis| (big(bent[axis]) - &exact[axis]).to_f64().value());
                    let apart = DVec3::from(apart).length();
                    let cosine = dir.dot(normal).abs().min(1.0);
                    let [_, said] = Scattering::Refracted(ratio).behind([0.0; 2], 0.0, cosine);
                    assert!(apart <= said, "{apart} {said}");
                    most = most.max(apart);
                    least_said = least_said.min(said);
                }
                let passes = least_said.is_finite();
                assert!(
                    !passes || least_said < 60.0 * most,
                    "{least_said} {most} {ratio} {angle}"
                );
            }
        }
    }

    #[test]
    fn what_slides_along_a_surface_leaves_beside_its_way() {
        for (angle, scattering) in
            angles().zip(RATIOS.map(Scattering::Refracted).into_iter().cycle())
        {
            let (dir, lateral) = (falling(angle), 1e-3);
            let Some(bent) = scattered(dir, DVec3::Y, scattering) else {
                continue;
            };
            let apart = DVec3::X * (lateral / libm::cos(angle));
            let leaves = (apart - bent * bent.dot(apart)).length();
            let [said, _] = scattering.behind([lateral, 0.0], 0.0, libm::cos(angle));
            assert!(
                leaves <= said * (1.0 + 1e-12) && said <= leaves.max(lateral) * 1.001,
                "{leaves} {said}"
            );
        }
    }
}
