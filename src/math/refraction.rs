//! Reflection and refraction at the smooth boundary of two clear media.

use glam::DVec3;

use super::direction;

/// The reflected share of a ray at a boundary, and the refracted direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Refraction {
    /// The reflected share of the light, from 0 to 1, the mean of both polarisations.
    pub reflectance: f64,
    /// The refracted unit direction, on the other side; `None` at total reflection.
    pub bent: Option<DVec3>,
}

impl Refraction {
    /// The refraction of a ray along the unit `dir` at a boundary with a unit normal.
    ///
    /// `from` and `into` are the indices of refraction; the ray may come from either side of the
    /// normal. Between equal media there is no boundary: the direction stays the same, bit for bit.
    #[must_use]
    pub fn new(dir: DVec3, normal: DVec3, from: f64, into: f64) -> Self {
        let falls = dir.dot(normal);
        if from.to_bits() == into.to_bits() {
            return Self {
                reflectance: 0.0,
                bent: Some(dir),
            };
        }
        let ratio = from / into;
        let cosine = falls.abs().min(1.0);
        // The law of refraction: from · sin α = into · sin β (Snell 1621, Descartes 1637).
        let bent_sine_squared = ratio * ratio * (1.0 - cosine * cosine);
        if bent_sine_squared >= 1.0 {
            return Self {
                reflectance: 1.0,
                bent: None,
            };
        }
        let bent_cosine = (1.0 - bent_sine_squared).sqrt();
        // The part along the boundary shrinks by the ratio; the rest of a unit vector goes along
        // the normal (de Greve 2006, "Reflections and refractions in ray tracing"). A square root
        // of a number above zero is above 1e-8, so rounding does not send the ray back.
        let ahead = normal * (ratio * falls.abs() - bent_cosine);
        let ahead = if falls > 0.0 { -ahead } else { ahead };
        Self {
            reflectance: reflectance(from, cosine, into, bent_cosine),
            bent: Some(direction(dir * ratio + ahead)),
        }
    }
}

/// The reflected share of unpolarised light (Fresnel 1823).
///
/// The cosines are those of the angles of incidence and of refraction.
fn reflectance(from: f64, cosine: f64, into: f64, bent_cosine: f64) -> f64 {
    let share = |near: f64, far: f64| {
        let amplitude = (near - far) / (near + far);
        amplitude * amplitude
    };
    let across = share(from * cosine, into * bent_cosine);
    let along = share(from * bent_cosine, into * cosine);
    f64::midpoint(across, along)
}

#[cfg(test)]
mod tests {
    use super::*;

    const GLASS: f64 = 1.5;

    /// The refraction at the plane y = 0 of a ray from above at an angle.
    fn down(angle: f64, from: f64, into: f64) -> Refraction {
        let dir = DVec3::new(libm::sin(angle), -libm::cos(angle), 0.0);
        Refraction::new(dir, DVec3::Y, from, into)
    }

    fn angles() -> impl Iterator<Item = f64> {
        (0..1571).map(|thousandth| f64::from(thousandth) / 1000.0)
    }

    #[track_caller]
    fn assert_near(value: f64, expected: f64) {
        assert!((value - expected).abs() < 1e-14, "{value} for {expected}");
    }

    #[test]
    fn straight_on_the_square_of_difference_by_sum_is_mirrored() {
        for (into, percent) in [(1.333, 2.037), (1.5, 4.0), (2.417, 17.197), (4.0, 36.0)] {
            let met = down(0.0, 1.0, into);
            let amplitude: f64 = (into - 1.0) / (into + 1.0);
            assert_near(met.reflectance, amplitude * amplitude);
            assert!((met.reflectance * 100.0 - percent).abs() < 0.001);
            assert_eq!(met.bent, Some(DVec3::NEG_Y));
            assert_near(down(0.0, into, 1.0).reflectance, met.reflectance);
        }
    }

    /// Checks glass of index 1.5, plotted in Hecht, "Optics".
    ///
    /// Computed from the sines and tangents of Fresnel's own form.
    #[test]
    fn oblique_light_is_mirrored_as_fresnel_says() {
        for (from, into) in [(1.0, GLASS), (GLASS, 1.0), (1.0, 1.333), (1.333, 2.417)] {
            for angle in angles().skip(1) {
                let sine = from / into * libm::sin(angle);
                if sine >= 0.999_999 {
                    continue;
                }
                let bent = libm::asin(sine);
                let [plus, minus] = [angle + bent, angle - bent];
                let across = libm::sin(minus) / libm::sin(plus);
                let along = libm::tan(minus) / libm::tan(plus);
                let expected = f64::midpoint(across * across, along * along);
                let found = down(angle, from, into).reflectance;
                assert!((found - expected).abs() < 1e-9, "{found} for {expected}");
            }
        }
    }

    /// At the angle whose tangent is the ratio, all reflected light is polarised.
    ///
    /// Half of ((n² − 1) / (n² + 1))² is reflected (Brewster 1815).
    #[test]
    fn at_brewsters_angle_one_polarisation_passes_whole() {
        for into in [1.333, GLASS, 2.417] {
            let across: f64 = (into * into - 1.0) / (into * into + 1.0);
            let met = down(libm::atan(into), 1.0, into);
            assert_near(met.reflectance, across * across / 2.0);
        }
    }

    #[test]
    fn beyond_the_critical_angle_nothing_passes() {
        let critical = libm::asin(1.0 / GLASS);
        assert!((critical.to_degrees() - 41.810_314_895_778_6).abs() < 1e-12);
        assert!(down(critical - 1e-12, GLASS, 1.0).bent.is_some());
        assert!(down(critical - 1e-12, GLASS, 1.0).reflectance > 0.999);
        for beyond in [1e-12, 0.1, 0.7] {
            let met = down(critical + beyond, GLASS, 1.0);
            assert_eq!((met.reflectance, met.bent), (1.0, None));
        }
        assert!(angles().all(|angle| down(angle, 1.0, GLASS).bent.is_some()));
    }

    #[test]
    fn what_is_mirrored_and_what_passes_are_all() {
        for (from, into) in [(1.0, GLASS), (GLASS, 1.0), (1.333, 1.0), (1.0, 10.0)] {
            for angle in angles() {
                let met = down(angle, from, into);
                let Some(bent) = met.bent else { continue };
                let [near, far] = [libm::cos(angle), -bent.y];
                let across = 2.0 * from * near / (from * near + into * far);
                let along = 2.0 * from * near / (into * near + from * far);
                let beam = into * far / (from * near);
                let passes = beam * f64::midpoint(across * across, along * along);
                assert!((met.reflectance + passes - 1.0).abs() < 1e-13, "{angle}");
            }
        }
    }

    #[test]
    fn light_that_turns_round_takes_the_same_way_back() {
        let normal = direction(DVec3::new(0.3, -0.8, 0.4));
        for angle in angles() {
            let along = direction(normal.cross(DVec3::X));
            let dir = direction(along * libm::sin(angle) - normal * libm::cos(angle));
            let there = Refraction::new(dir, normal, 1.333, 2.417);
            let bent = there.bent.expect("into the denser medium all passes");
            assert!(bent.dot(normal) < 0.0 && (bent.length_squared() - 1.0).abs() < 1e-15);
            let back = Refraction::new(-bent, normal, 2.417, 1.333);
            assert!((back.bent.expect("as it came") + dir).length() < 1e-12);
            assert!((back.reflectance - there.reflectance).abs() < 1e-12);
            // The result does not depend on the side of the normal.
            assert_eq!(Refraction::new(dir, -normal, 1.333, 2.417), there);
        }
    }

    #[test]
    fn equal_media_are_no_boundary() {
        let dir = direction(DVec3::new(0.1, -0.7, 0.2));
        for index in [1.0, GLASS, 1.1] {
            let met = Refraction::new(dir, DVec3::Y, index, index);
            assert_eq!((met.reflectance, met.bent), (0.0, Some(dir)));
        }
    }

    #[test]
    fn rays_along_the_boundary_are_mirrored() {
        for (from, into) in [(1.0, GLASS), (GLASS, 1.0)] {
            assert_near(
                Refraction::new(DVec3::X, DVec3::Y, from, into).reflectance,
                1.0,
            );
        }
        // A rounding above the critical angle, the refracted ray runs along the boundary.
        let dir = direction(DVec3::new(
            1.0 / GLASS,
            -(1.0 - 1.0 / (GLASS * GLASS)).sqrt(),
            0.0,
        ));
        for nudge in 0..64 {
            let dir = direction(dir - DVec3::Y * (f64::EPSILON * f64::from(nudge)));
            if let Some(bent) = Refraction::new(dir, DVec3::Y, GLASS, 1.0).bent {
                assert!(bent.y < 0.0 && bent.y > -1e-6, "{bent}");
            }
        }
    }
}
