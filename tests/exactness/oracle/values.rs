//! Bounds of values of flat things: never exceeded, and not so wide that they would hide anything.

use dashu_ratio::RBig;
use glam::DVec3;
use heliodon::geometry::{Plane, Shape};
use heliodon::math::{Point, Ray, RayOrigin, Span, unit};

use super::equality::{SEED, cases as count};
use super::proofs::{moment_bound, slope_bound};
use super::search::is_used;
use oracle::cases;
use oracle::rational::{Vector, number, rounded};
use oracle::truth::{self, Distance};
use support::random::{Random, Style};

#[test]
fn distances_are_within_their_bound_which_is_used() {
    is_used("t", |place| {
        let (flat, ray) = (place.flat(), place.ray());
        let (t, error) = flat.hits(&ray, Span::AHEAD)?;
        let exact = truth::crosses(&flat, &ray)?;
        Some(Distance::Quotient(exact).share_of_error(t, error))
    });
}

#[test]
fn heights_are_within_their_bound_which_is_used() {
    is_used("N", |place| {
        let (flat, ray) = (place.flat(), place.ray());
        let crossing = flat.crossing(&ray)?;
        let way = Vector::to(&ray.origin).minus(&Vector::of(flat.point));
        let apart = number(crossing.height) + Vector::of(flat.decisive_normal()).dot(&way);
        Some(rounded(&apart).abs() / crossing.doubt)
    });
}

#[test]
fn slopes_are_within_their_bound_which_is_used() {
    let bound = slope_bound();
    is_used("D", |place| {
        let flat = place.flat();
        let crossing = flat.crossing(&place.ray())?;
        let exact = Vector::of(flat.decisive_normal()).dot(&Vector::of(place.dir));
        Some(rounded(&(number(crossing.slope) - exact)).abs() / bound)
    });
}

#[test]
fn moments_are_within_their_bound_which_is_used() {
    let bound = moment_bound();
    is_used("v·(d × c)", |place| {
        let (c, size) = place.ray().origin.seen_from(place.point);
        let moment = place.normal.dot(place.dir.cross(c));
        let way = Vector::to(&place.ray().origin).minus(&Vector::of(place.point));
        let exact = Vector::of(place.normal).dot(&Vector::of(place.dir).cross(&way));
        Some(rounded(&(number(moment) - exact)).abs() / (bound * size))
    });
}

/// Those of rectangles, which are quotients of moments, have the most roundings. The formula is that
/// of `Rectangle`, whose axes would be rounded anew for each change.
#[test]
fn points_are_within_their_bound_which_is_used() {
    let plane = Plane::new(DVec3::ZERO, DVec3::Y).expect("a plane");
    let slip = Shape::from(plane).point_error();
    is_used("hit points of rectangles", |place| {
        let (flat, ray) = (place.flat(), place.ray());
        let crossing = flat.crossing(&ray)?;
        let x = unit(place.normal.any_orthonormal_vector())?;
        let y = unit(place.normal.cross(x))?;
        let moment = ray.dir.cross(crossing.origin) / crossing.slope;
        let point = Point {
            anchor: flat.point,
            offset: x * y.dot(moment) - y * x.dot(moment),
        };
        let error = crossing.error(crossing.distance());
        let exact = truth::crosses(&flat, &ray)?;
        share_of_rounding(&exact, &ray, point, slip * error)
    });
    is_used("hit points of planes", |place| {
        let (flat, ray) = (place.flat(), place.ray());
        let (t, error) = flat.hits(&ray, Span::AHEAD)?;
        let exact = truth::crosses(&flat, &ray)?;
        let point = flat.foot(&ray, t);
        share_of_rounding(&exact, &ray, point, slip * error)
    });
}

/// And as they are met, of every kind of flat surface.
#[test]
fn points_of_rectangles_and_triangles_are_within_their_bound() {
    let (mut worst, mut met) = (0f64, 0);
    for case in 0..count() {
        let mut random = Random::of(SEED, case);
        let surface = cases::surface(&mut random, Style::Uniform, 1.0);
        let Some(flat) = surface.shape().carrier() else {
            continue;
        };
        for _ in 0..8 {
            let dir = unit(random.cube()).unwrap_or(DVec3::X);
            let ray = Ray::new(Point::exact(random.cube() * 2.0), dir);
            let Some(hit) = surface.hits(&ray, Span::AHEAD) else {
                continue;
            };
            met += 1;
            let exact = truth::crosses(flat, &ray).expect("it was met");
            let close = surface.shape().distance_error(&ray, &hit);
            let share = Distance::Quotient(exact.clone()).share_of_error(hit.t, close);
            assert!(
                share <= 1.0,
                "{share} times the closer bound: {surface:?} {ray:?}"
            );
            let slip = surface.shape().point_error() * hit.error;
            let Some(share) = share_of_rounding(&exact, &ray, hit.point, slip) else {
                continue;
            };
            assert!(share <= 1.0, "{share} times the bound: {surface:?} {ray:?}");
            worst = worst.max(share);
        }
    }
    println!("largest share of the error of {met} hit points of all kinds: {worst}");
    assert!(met > count() / 10, "{met}");
}

/// How far a hit point lies from where it ought to, in units of what is said of that; `None` if it may
/// slide so far along its ray that no more than a part of that is counted.
pub(super) fn share_of_rounding(exact: &RBig, ray: &Ray, point: Point, slip: f64) -> Option<f64> {
    let said = |slip| RayOrigin::new((None, None), ray, point, slip).rounding();
    if said(2.0 * slip) <= said(slip) {
        return None;
    }
    let met = Vector::to(&ray.origin).plus(&Vector::of(ray.dir).times(exact));
    let apart = Vector::to(&point).minus(&met).rounded().length();
    Some(apart / said(slip))
}
