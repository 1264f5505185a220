//! Rays into round glass: in once, out once, and nothing between.

use glam::DVec3;
use heliodon::math::{Point, Ray, Refraction, Span, direction};
use heliodon::visibility::SurfaceList;

use super::tools::scene;

const GLASS: f64 = 1.5;

/// A number from −1 to 1 that is a function of two others (Steele, Lea and Flood 2014).
fn scatter(case: u64, axis: u64) -> f64 {
    let mut bits = (case * 8 + axis).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ bits >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ bits >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((bits ^ bits >> 31) >> 11) as f64 / 4_503_599_627_370_496.0 - 1.0
}

fn vector(case: u64, axis: u64) -> DVec3 {
    DVec3::new(
        scatter(case, axis),
        scatter(case, axis + 1),
        scatter(case, axis + 2),
    )
}

/// A round thing of glass, at which rays are aimed from outside.
struct Ball {
    center: DVec3,
    axes: DVec3,
    /// The shortest way that a ray can have inside.
    shortest: f64,
}

impl Ball {
    fn round(center: DVec3, radius: f64) -> Self {
        // A ray along the surface goes on at the critical angle, whose sine is 1/n.
        let cosine = f64::sqrt(1.0 - 1.0 / (GLASS * GLASS));
        Self {
            center,
            axes: DVec3::splat(radius),
            shortest: 2.0 * radius * cosine * 0.999_999,
        }
    }

    /// Follows rays into the ball, mirrors them so many times inside, and lets them out.
    fn follow(&self, rays: u64, mirrors: u32) {
        let number = |v: DVec3| format!("{:e} {:e} {:e}", v.x, v.y, v.z);
        let (center, axes) = (number(self.center), number(self.axes));
        let scene = scene(&format!(
            "image 1 1; camera {{ viewpoint {}; look-at {center} }}
            ellipsoid {{ material \"glass\"; center {center}; radius 1; scale {axes} }}
            sphere {{ material \"glass\"; center {center}; radius {:e} }}",
            number(self.center + self.axes * 4.0),
            self.axes.x,
        ));
        let ball = usize::from(self.axes == DVec3::splat(self.axes.x));
        let list = SurfaceList::new(&scene.surfaces[ball..=ball]);
        let entered = (0..rays)
            .filter(|case| self.enters(&list, *case, mirrors))
            .count();
        assert!(entered as u64 > rays / 2, "{entered} of {rays} entered");
    }

    /// A ray from around the ball at it, one in four at its rim or a few roundings beside.
    fn aimed(&self, case: u64) -> Ray<'static> {
        let outward = vector(case, 0);
        let eye = Point {
            anchor: self.center,
            offset: (outward + outward.signum()) * self.axes * 2.0,
        };
        let mut aim = vector(case, 3) * self.axes;
        if case.is_multiple_of(4) {
            let across = direction(outward.cross(vector(case, 3)));
            aim = across * self.axes * (1.0 + scatter(case, 7) * 4e-16);
        }
        Ray::new(eye, direction(aim - eye.offset))
    }

    fn enters(&self, list: &SurfaceList<'_>, case: u64, mirrors: u32) -> bool {
        let ray = self.aimed(case);
        let Some((entry, hit)) = list.nearest(&ray, Span::AHEAD, &mut 0) else {
            return false;
        };
        let ray_origin = entry.ray_origin(&ray, &hit);
        let mirrored = Ray::spawn(&ray_origin, ray.mirrored(hit.normal));
        let inward = ray.dir.dot(hit.normal) < 0.0;
        // A rounding beside the rim a ray may seem to come from inside; then it is mirrored there.
        let met = list.nearest(&mirrored, Span::AHEAD, &mut 0);
        assert_eq!(met.is_none(), inward, "case {case}: mirrored");
        let bent = Refraction::new(ray.dir, hit.normal, 1.0, GLASS)
            .bent
            .unwrap();
        if inward {
            self.inside(list, &Ray::spawn(&ray_origin, bent), case, mirrors);
        }
        inward
    }

    fn inside(&self, list: &SurfaceList<'_>, ray: &Ray, case: u64, mirrors: u32) {
        let Some((entry, hit)) = list.nearest(ray, Span::AHEAD, &mut 0) else {
            panic!("case {case}: from inside nothing is met");
        };
        assert!(
            ray.dir.dot(hit.normal) > 0.0,
            "case {case}: entered from inside"
        );
        assert!(
            hit.t > self.shortest,
            "case {case}: met again at {:e}",
            hit.t
        );
        let off = ((hit.point.from(self.center) / self.axes).length() - 1.0).abs();
        assert!(
            off < 4.0 * f64::EPSILON,
            "case {case}: {off:e} off the surface"
        );
        let ray_origin = entry.ray_origin(ray, &hit);
        if mirrors > 0 {
            let next = Ray::spawn(&ray_origin, ray.mirrored(hit.normal));
            return self.inside(list, &next, case, mirrors - 1);
        }
        if let Some(bent) = Refraction::new(ray.dir, hit.normal, GLASS, 1.0).bent {
            let out = Ray::spawn(&ray_origin, bent);
            let met = list.nearest(&out, Span::AHEAD, &mut 0);
            assert!(met.is_none(), "case {case}: left, and met again");
        }
    }
}

#[test]
fn a_ball_is_entered_once_and_left_once() {
    Ball::round(DVec3::ZERO, 1.0).follow(100_000, 0);
    Ball::round(DVec3::new(0.1, -7.3, 2.2), 0.7).follow(5_000, 50);
}

#[test]
fn a_ball_of_any_size_anywhere_is_too() {
    for power in [-150, -40, 40, 150] {
        Ball::round(
            DVec3::new(0.3, -1.0, 2.0) * 2f64.powi(power),
            2f64.powi(power),
        )
        .follow(5_000, 3);
    }
    Ball::round(DVec3::new(1e9, -1e9, 1e9), 1.0).follow(5_000, 3);
    Ball::round(DVec3::new(0.1, 0.2, 0.3), 1e9).follow(5_000, 3);
}

#[test]
fn an_ellipsoid_is_too() {
    for axes in [
        DVec3::new(1.0, 0.3, 2.0),
        DVec3::new(1e-3, 1.0, 1e3),
        DVec3::new(5.0, 5.0, 0.01),
    ] {
        let center = DVec3::new(0.4, 0.0, -3.0);
        // What enters at the sharp end of a flat one may leave close by.
        let shortest = 0.0;
        Ball {
            center,
            axes,
            shortest,
        }
        .follow(20_000, 5);
    }
}
