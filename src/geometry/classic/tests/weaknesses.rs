//! Cases in which the classic algorithm fails, each pinned by a test.

use super::*;
use crate::math::Flat;

/// A10: the point is rounded to the steps of its world coordinates, 1.2e-7 here.
#[test]
fn far_from_the_origin_places_are_rounded() {
    let corner = DVec3::splat(1e9);
    let square = rectangle(corner, DVec3::Z, DVec3::X, 1.0);
    let eye = Point {
        anchor: corner + DVec3::new(0.0, 0.0, 5.0),
        offset: DVec3::new(0.3, 0.3, 0.0),
    };
    let ray = Ray::new(eye, DVec3::NEG_Z);
    let uv = |hit: Option<Hit>| hit.expect("a hit").uv;
    assert_eq!(uv(square.intersect(&ray, Span::AHEAD)), DVec2::splat(0.3));
    assert_eq!(
        uv(intersect::<f64>(&square, &ray, Span::AHEAD)),
        DVec2::splat(0.299_999_952_316_284_2)
    );
    // In 32 bits there are 64 units from one number to the next: the eye is on the square.
    assert_eq!(distance::<f32>(&square, &ray), None);
}

/// B4: a fifth of the rays at a shared slanted edge miss both sides; some hit both.
#[test]
fn shared_edges_overlap_and_gape() {
    let u = DVec3::new(2.0, 1.0, 2.0) / 3.0;
    let v = DVec3::new(-2.0, 2.0, 1.0) / 3.0;
    let corner = DVec3::new(7.3, -4.1, 2.9);
    let next = corner + DVec3::new(2.0, 1.0, 2.0);
    let pair = [corner, next].map(|corner| rectangle(corner, u.cross(v), u, 3.0));
    let mut met = [0; 3];
    for index in 0..10_000 {
        let [along, x, y] = scatter(index);
        let edge = next + v * (1.5 + along);
        let eye = edge + u.cross(v) * 5.0 + u * x + v * y;
        let ray = ray(eye, edge - eye);
        let hits = pair
            .iter()
            .filter(|square| distance::<f64>(square, &ray).is_some());
        met[hits.count()] += 1;
    }
    assert!(met[0] > 100 && met[2] > 10, "{met:?}");
}

/// G1: far away the discriminant is noise.
#[test]
fn far_spheres_are_met_at_random() {
    let wrong = |far: f64, classic: fn(&Shape, &Ray) -> Option<f64>| {
        let sphere = Shape::from(Sphere::new(DVec3::ZERO, 1.0).expect("a sphere"));
        let rays = (0..2000).map(|index| {
            let [x, y, _] = scatter(index).map(|place| place * 1.5);
            ray(DVec3::new(x, y, far), DVec3::NEG_Z)
        });
        let wrong = rays.filter(|ray| {
            let robust = sphere.intersect(ray, Span::AHEAD);
            classic(&sphere, ray).is_some() != robust.is_some()
        });
        wrong.count()
    };
    assert_eq!(wrong(10.0, distance::<f64>), 0);
    assert!(wrong(1e9, distance::<f64>) > 500);
    assert!(wrong(10.0, distance::<f32>) < 5);
    assert!(wrong(1e5, distance::<f32>) > 500);
}

/// Measures the largest distance at which a mirrored ray hits its own plane again.
///
/// The scene has some ten units and an angle of one degree. The offset cannot be much smaller.
#[test]
fn the_offset_is_above_the_rounding_of_ordinary_scenes() {
    fn furthest<T: Scalar>() -> f64 {
        let (sine, cosine) = (0.017_452, 0.999_848);
        let again = (0..20_000).filter_map(|index| {
            let normal = direction(scatter(index).into());
            let along = direction(normal.cross(DVec3::new(0.3, 0.5, 0.7)));
            let point = DVec3::from(scatter(index + 1)) * 10.0;
            let plane = Flat::with_unit_normal(point, normal);
            let dir = direction(along * cosine - normal * sine);
            let arriving = ClassicRay::<T>::of(&ray(point - dir * 3.0, dir));
            let there = flat::plane(&plane, &arriving, |_| true)?;
            let mirrored = ray(there.point.wide(), along * cosine + normal * sine);
            Some(
                flat::plane(&plane, &ClassicRay::<T>::of(&mirrored), |_| true)?
                    .t
                    .wide(),
            )
        });
        again.fold(0.0, f64::max)
    }
    let (wide, narrow) = (furthest::<f64>(), furthest::<f32>());
    assert!(wide > 5e-14 && wide < <f64 as Scalar>::OFFSET, "{wide:e}");
    assert!(
        narrow > 1e-5 && narrow < <f32 as Scalar>::OFFSET.wide(),
        "{narrow:e}"
    );
}

/// A5, B19: a ray misses the surface that it leaves, and all within the offset.
#[test]
fn what_is_nearer_than_the_offset_is_not_seen() {
    let square = rectangle(DVec3::ZERO, DVec3::Z, DVec3::X, 1.0);
    let from = |height: f64| ray(DVec3::new(0.5, 0.5, height), DVec3::NEG_Z);
    assert_eq!(distance::<f64>(&square, &from(0.0)), None);
    assert_eq!(distance::<f64>(&square, &from(5e-10)), None);
    assert_eq!(distance::<f64>(&square, &from(2e-9)), Some(2e-9));
    assert_eq!(distance::<f32>(&square, &from(5e-5)), None);
    assert!(distance::<f32>(&square, &from(2e-4)).is_some());
    assert_eq!(
        square.intersect(&from(5e-10), Span::AHEAD).map(|hit| hit.t),
        Some(5e-10)
    );
}

/// The determinant of a triangle is an area: small triangles are never hit.
#[test]
fn small_triangles_vanish() {
    let triangle = |size: f64| {
        let corners = [DVec3::ZERO, DVec3::X * size, DVec3::Y * size];
        Shape::from(Triangle::new(corners).expect("a triangle"))
    };
    let at = |size: f64| ray(DVec3::new(size / 4.0, size / 4.0, 1.0), DVec3::NEG_Z);
    for (size, seen) in [(1e-7, true), (1e-9, false)] {
        assert_eq!(distance::<f64>(&triangle(size), &at(size)).is_some(), seen);
        assert!(triangle(size).intersect(&at(size), Span::AHEAD).is_some());
    }
    assert_eq!(distance::<f32>(&triangle(1e-4), &at(1e-4)), None);
}
