//! Form factors: a shape's share of the light of a full sky as bright.
//!
//! Shapes are given as seen from a small piece of surface at the origin, with the unit `normal`.
//! Parts below its horizon do not count. Form factors are continuous, so no sign needs to be exact:
//! a part within rounding of the horizon gives as little as rounding.

use std::f64::consts::PI;

use glam::DVec3;

/// The form factor of a flat convex polygon, from 0 to 1.
///
/// The corners run counter-clockwise as seen from the emitting side. The sum runs over the borders
/// of the part above the horizon, including the cut along it (Lambert 1760, "Photometria"; in
/// vectors: Baum, Rushmeier and Winget 1989, "Improving Radiosity Solutions Through the Use of
/// Analytically Determined Form-Factors").
#[must_use]
pub fn of_polygon(corners: &[DVec3], normal: DVec3) -> f64 {
    let next = corners.iter().cycle().skip(1);
    let (mut sum, mut setting, mut rising) = (0.0, None, None);
    for (from, to) in corners.iter().zip(next) {
        let (at_from, at_to) = (normal.dot(*from), normal.dot(*to));
        let horizon = || *from + (*to - *from) * (at_from / (at_from - at_to));
        match (at_from >= 0.0, at_to >= 0.0) {
            (true, true) => sum += of_border(*from, *to, normal),
            (true, false) => sum += of_border(*from, *setting.insert(horizon()), normal),
            (false, true) => sum += of_border(*rising.insert(horizon()), *to, normal),
            (false, false) => {}
        }
    }
    if let (Some(setting), Some(rising)) = (setting, rising) {
        sum += of_border(setting, rising, normal);
    }
    // Counter-clockwise around the polygon is clockwise around the direction to it.
    (-sum / (2.0 * PI)).clamp(0.0, 1.0)
}

/// A border's term: its angle, times the sine between its plane and `normal`.
fn of_border(from: DVec3, to: DVec3, normal: DVec3) -> f64 {
    // Far away the border is short and both ends are far; their own product would be rounding.
    let across = from.cross(to - from);
    let sine = across.length();
    if sine == 0.0 {
        // A border in line with the piece of surface spans nothing.
        return 0.0;
    }
    libm::atan2(sine, from.dot(to)) * (normal.dot(across) / sine)
}

/// The form factor of a sphere seen from outside, from 0 to 1.
///
/// It is `(r/d)² cos θ` where the horizon does not cut the sphere, and the integral over the part
/// above it otherwise (Hamilton and Morgan 1952, "Radiant-Interchange Configuration Factors", NACA
/// TN 2836).
#[must_use]
pub fn of_ball(center: DVec3, radius: f64, normal: DVec3) -> f64 {
    let distance = center.length();
    // With c = cos θ, s = r/d, q² = 1 − s², x = c/s and k² = 1 − x², the integral is
    // (c s² acos(−c q / (s √(1 − c²))) − k q s + atan(k s / q)) / π.
    let sine = (radius / distance).min(1.0);
    let cosine = normal.dot(center) / distance;
    let height = cosine / sine;
    if height <= -1.0 {
        return 0.0;
    }
    if height >= 1.0 {
        return (sine * sine * cosine).min(1.0);
    }
    let edge = ((distance - radius).max(0.0) * (distance + radius)).sqrt() / distance;
    let cut = ((1.0 - height) * (1.0 + height)).sqrt();
    let below = (-height * edge / ((1.0 - cosine) * (1.0 + cosine)).sqrt()).clamp(-1.0, 1.0);
    let cap = cosine * sine * sine * libm::acos(below);
    let rim = libm::atan2(cut * sine, edge) - cut * edge * sine;
    ((cap + rim) / PI).clamp(0.0, 1.0)
}

/// The form factor of a far shape with this apparent area, in this direction.
#[must_use]
pub fn of_speck(center: DVec3, area: f64, normal: DVec3) -> f64 {
    let distance = center.length();
    let cosine = normal.dot(center) / distance;
    (cosine.max(0.0) * (area / distance / distance / PI)).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Directions and points that fill space evenly enough.
    fn vector(index: u32) -> DVec3 {
        let part = |step: f64| (f64::from(index) * step).fract() * 2.0 - 1.0;
        DVec3::new(part(0.618_033), part(0.754_877), part(0.569_840))
    }

    /// The mean over a grid of 400 × 400 points in the unit square.
    fn integral(value: impl Fn(f64, f64) -> f64) -> f64 {
        const SIDE: u32 = 400;
        let middle = |index: u32| (f64::from(index) + 0.5) / f64::from(SIDE);
        let row = |y: u32| (0..SIDE).map(|x| value(middle(x), middle(y))).sum::<f64>();
        (0..SIDE).map(row).sum::<f64>() / f64::from(SIDE * SIDE)
    }

    #[test]
    fn a_polygon_gives_what_its_pieces_give() {
        let mut cut = 0;
        for index in 1..60 {
            let (normal, front) = (vector(index).normalize(), vector(index + 99).normalize());
            let x = front.cross(vector(index + 199)).normalize();
            let y = front.cross(x);
            let corner = -front * (0.5 + f64::from(index % 7)) + (x - y * 1.5) * vector(index).x;
            let (width, height) = (x * 1.5, y * 0.7);
            let corners = [
                corner,
                corner + width,
                corner + width + height,
                corner + height,
            ];
            let above = corners.iter().filter(|c| normal.dot(**c) > 0.0).count();
            cut += usize::from(above % 4 != 0);
            let pieces = integral(|u, v| {
                let place = corner + width * u + height * v;
                let dir = place.normalize();
                normal.dot(dir).max(0.0) * -front.dot(dir) / place.length_squared()
            });
            let expected = pieces * 1.5 * 0.7 / PI;
            let found = of_polygon(&corners, normal);
            assert!(
                (found - expected).abs() < 2e-5,
                "{index}: {found} {expected}"
            );
        }
        assert!(cut > 10, "only {cut} lie in the horizon");
    }

    /// Closed forms of a rectangle over one of its corners (Hamilton and Morgan 1952).
    #[test]
    fn rectangles_over_their_corners() {
        for [a, b, c] in [
            [1.0, 1.0, 1.0],
            [0.2, 3.0, 0.7],
            [1e3, 2e3, 1.0],
            [1.0, 2.0, 1e3],
        ] {
            let corners = |x: DVec3, y: DVec3, z: DVec3| [z, z + y, z + x + y, z + x];
            let (x, y, z) = (DVec3::X * a, DVec3::Y * b, DVec3::Z * c);
            let (s, t) = (a / c, b / c);
            let half =
                |s: f64, t: f64| s / (1.0 + s * s).sqrt() * (t / (1.0 + s * s).sqrt()).atan();
            let parallel = (half(s, t) + half(t, s)) / (2.0 * PI);
            let found = of_polygon(&corners(x, y, z), DVec3::Z);
            assert!((found - parallel).abs() < 1e-15, "{found} {parallel}");
            // Half of it is above the horizon of a piece that faces along x.
            let far = 1.0 / (s * s + 1.0).sqrt();
            let upright = ((t.atan()) - far * (t * far).atan()) / (2.0 * PI);
            let found = of_polygon(&corners(x, y, z), DVec3::X);
            assert!((found - upright).abs() < 1e-15, "{found} {upright}");
        }
    }

    #[test]
    fn a_ball_gives_what_its_pieces_give() {
        for index in 1..60 {
            let center = vector(index).normalize() * 2.0;
            let radius = [0.1, 0.7, 1.5, 1.99][index as usize % 4];
            // The horizon cuts most of them.
            let tilt = (radius / 2.0) * vector(index + 7).x * 1.5;
            let across = center.cross(vector(index + 50)).normalize();
            let normal = (center.normalize() * tilt + across).normalize();
            let axis = center.normalize();
            let edge = (1.0 - radius * radius / 4.0f64).sqrt();
            let expected = 2.0
                * (1.0 - edge)
                * integral(|u, v| {
                    let along = 1.0 - u * (1.0 - edge);
                    let side =
                        across * (2.0 * PI * v).cos() + axis.cross(across) * (2.0 * PI * v).sin();
                    normal
                        .dot(axis * along + side * (1.0 - along * along).sqrt())
                        .max(0.0)
                });
            let found = of_ball(center, radius, normal);
            assert!(
                (found - expected).abs() < 2e-5,
                "{index}: {found} {expected}"
            );
        }
    }

    #[test]
    fn balls_above_and_below() {
        assert_eq!(of_ball(DVec3::Z * 4.0, 1.0, DVec3::Z), 0.0625);
        assert_eq!(of_ball(DVec3::Z * -4.0, 1.0, DVec3::Z), 0.0);
        assert_eq!(of_ball(DVec3::Z * 2.0, 2.0, DVec3::Z), 1.0);
        // A sphere that touches the point from the side fills half of the sky.
        assert!((of_ball(DVec3::X, 1.0, DVec3::Z) - 0.5).abs() < 1e-15);
        // Both formulas, where one takes over from the other.
        let normal = DVec3::new(0.8, 0.0, 0.6);
        let [whole, cut] =
            [1.0, -1.0].map(|step| of_ball(DVec3::Z * (5.0 / 3.0 + step * 1e-9), 1.0, normal));
        assert!((whole - cut).abs() < 1e-9, "{whole} {cut}");
    }

    #[test]
    fn a_speck_is_what_a_far_shape_comes_to() {
        let normal = DVec3::new(0.6, 0.0, 0.8);
        for power in 6..20 {
            let far = 2f64.powi(power);
            let center = DVec3::new(0.3, -0.2, 1.0) * far;
            let square = [[-0.5, -0.5], [-0.5, 0.5], [0.5, 0.5], [0.5, -0.5]];
            let corners = square.map(|[x, y]| center + DVec3::new(x, y, 0.0));
            let speck = of_speck(center, center.z / center.length(), normal);
            let exact = of_polygon(&corners, normal);
            let off = (speck / exact - 1.0).abs();
            assert!(off < 0.5 / far.powi(2) + 4e-16 * far, "{power}: {off}");
            let speck = of_speck(center, PI / 4.0, normal);
            let exact = of_ball(center, 0.5, normal);
            assert!((speck / exact - 1.0).abs() < 1e-15, "{power}");
        }
    }

    #[test]
    fn nothing_makes_it_other_than_a_share() {
        let odd = [
            DVec3::ZERO,
            DVec3::X,
            DVec3::new(1.0, 1.0, 0.0),
            DVec3::Y * 1e-75,
        ];
        let hard = [0.0, -0.0, 1.0, -1.0, 1e-75, 1e75, 1e-16, -1e-16];
        for x in hard {
            for z in hard {
                let move_by = DVec3::new(x, 0.5, z);
                for normal in [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::Z] {
                    let corners = odd.map(|corner| corner + move_by);
                    let mut all = vec![of_polygon(&corners, normal)];
                    all.extend([1e-9, 0.5, 1.0].map(|radius| of_ball(move_by, radius, normal)));
                    all.push(of_speck(move_by, 1.0, normal));
                    let shares = all.iter().all(|share| (0.0..=1.0).contains(share));
                    assert!(shares, "{move_by} {normal} {all:?}");
                }
            }
        }
    }
}
