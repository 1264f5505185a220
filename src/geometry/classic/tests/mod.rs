//! Tests of the classic algorithm.

mod weaknesses;

use glam::{DVec2, DVec3};

use super::*;
use crate::geometry::{Ellipsoid, Plane, Rectangle, Sphere, Triangle};
use crate::math::{Point, Segment, Side, direction, unit};

fn rectangle(corner: DVec3, normal: DVec3, xdir: DVec3, size: f64) -> Shape {
    let rectangle = Rectangle::new(corner, normal, xdir, DVec2::splat(size));
    rectangle.expect("a rectangle").into()
}

fn ray(origin: DVec3, dir: DVec3) -> Ray<'static> {
    Ray::new(Point::exact(origin), unit(dir).expect("a direction"))
}

fn distance<T: Scalar>(shape: &Shape, ray: &Ray) -> Option<f64> {
    intersect::<T>(shape, ray, Span::AHEAD).map(|hit| hit.t)
}

/// Quasirandom numbers from −1 to 1, the same on every run (Weyl 1916).
fn scatter(index: u32) -> [f64; 3] {
    [2f64.sqrt(), 3f64.sqrt(), 5f64.sqrt()]
        .map(|root| (f64::from(index) * root).fract() * 2.0 - 1.0)
}

#[test]
fn every_shape_is_met_where_the_robust_one_is() {
    let plane = Plane::new(DVec3::new(0.0, -4.0, 0.0), DVec3::new(1.0, 5.0, 2.0));
    let corners = [[-1.0, -3.0, 1.0], [3.0, 2.0, 0.0], [-2.0, 3.0, 3.0]].map(DVec3::from);
    let scale = DVec3::new(2.0, 0.3, 1.1);
    let all: [Shape; 5] = [
        plane.expect("a plane").into(),
        rectangle(DVec3::splat(-2.0), DVec3::new(1.0, 2.0, 3.0), DVec3::Y, 4.0),
        Triangle::new(corners).expect("a triangle").into(),
        Sphere::new(DVec3::X, 1.5).expect("a sphere").into(),
        Ellipsoid::new(DVec3::Y, 1.2, scale)
            .expect("an ellipsoid")
            .into(),
    ];
    for robust in &all {
        let mut met = 0;
        for index in 1..2000 {
            let ray = ray(
                DVec3::from(scatter(index)) * 6.0,
                scatter(index + 7000).into(),
            );
            let Some(hit) = robust.intersect(&ray, Span::AHEAD.until(50.0)) else {
                continue;
            };
            met += 1;
            let wide = intersect::<f64>(robust, &ray, Span::AHEAD);
            let narrow = intersect::<f32>(robust, &ray, Span::AHEAD);
            for (found, rounding) in [(wide, 1e-9), (narrow, 1e-2)] {
                let found = found.expect("the same hit");
                assert!((found.t - hit.t).abs() < rounding, "{robust:?}");
                assert!((found.point.world() - hit.point.world()).length() < rounding);
                assert!((found.normal - hit.normal).length() < rounding);
                assert!((found.uv - hit.uv).length() < rounding);
            }
        }
        assert!(met > 40, "{robust:?} was met {met} times");
    }
}

#[test]
fn a_ray_along_a_plane_misses_it() {
    let square = rectangle(DVec3::ZERO, DVec3::Z, DVec3::X, 1.0);
    for height in [0.0, -1.0] {
        let along = ray(DVec3::new(-5.0, 0.5, height), DVec3::X);
        assert_eq!(distance::<f64>(&square, &along), None);
        assert_eq!(distance::<f32>(&square, &along), None);
    }
}

/// E5, E6: surfaces behind or at a light cast no shadow; those before it do.
#[test]
fn a_shadow_lies_between_the_ends() {
    let square = rectangle(DVec3::ZERO, DVec3::Z, DVec3::X, 1.0);
    let segment = |from: f64, to: f64| {
        let at = |height: f64| DVec3::new(0.5, 0.5, height);
        Segment::free(Point::exact(at(from)), at(to)).expect("a segment")
    };
    let classic = |from: f64, to: f64| occludes::<f64>(&square, &segment(from, to));
    assert!(classic(1.0, -1.0) && classic(-1.0, 1.0));
    assert!(!classic(1.0, 0.5) && !classic(1.0, 0.0));
    assert!(!classic(0.0, 1.0));
    // A light behind the square by less than the offset.
    assert!(square.occludes(&segment(1.0, -5e-10), Side::Back) && !classic(1.0, -5e-10));
}
