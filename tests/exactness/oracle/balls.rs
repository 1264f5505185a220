//! Bounds of distances and points of round things: never exceeded, and used.

use glam::DVec3;
use heliodon::geometry::{Ellipsoid, Sphere};
use heliodon::math::{Span, unit};
use heliodon::surface::Surface;

use super::place::Place;
use super::search::is_used;
use super::values::share_of_rounding;
use oracle::cases::{Boxed, boxed};
use oracle::truth;

#[test]
fn distances_of_balls_are_within_their_bound_which_is_used() {
    is_used("t of balls", |place| distance(&*ball(place)?, place));
}

#[test]
fn distances_of_ellipsoids_are_within_their_bound_which_is_used() {
    is_used("t of ellipsoids", |place| {
        distance(&*ellipsoid(place)?, place)
    });
}

#[test]
fn points_of_balls_are_within_their_bound_which_is_used() {
    is_used("hit points of balls", |place| point(&*ball(place)?, place));
}

#[test]
fn points_of_ellipsoids_are_within_their_bound_which_is_used() {
    is_used("hit points of ellipsoids", |place| {
        point(&*ellipsoid(place)?, place)
    });
}

/// A ball that the ray meets, more or less near its rim.
fn ball(place: &Place) -> Option<Boxed> {
    let radius = nearest(place) * (1.0 + place.normal.x.powi(12));
    Sphere::new(place.point, radius).ok().map(boxed)
}

/// The same, stretched up to a hundred times.
fn ellipsoid(place: &Place) -> Option<Boxed> {
    let scale = DVec3::new(1.0, 1.0 / (1.0 + 100.0 * place.normal.y.powi(4)), 1.0);
    let nearest = nearest(&Place {
        point: place.point / scale,
        anchor: place.anchor / scale,
        offset: place.offset / scale,
        dir: unit(place.dir / scale)?,
        ..*place
    });
    let radius = nearest * (1.0 + place.normal.x.powi(12));
    Ellipsoid::new(place.point, radius, scale).ok().map(boxed)
}

/// How near the line of the ray passes the point.
fn nearest(place: &Place) -> f64 {
    let way = (place.point - place.anchor) - place.offset;
    (way - place.dir * way.dot(place.dir)).length()
}

/// The share of the error of a distance.
fn distance(surface: &dyn Surface, place: &Place) -> Option<f64> {
    let ray = place.ray();
    let hit = surface.hits(&ray, Span::AHEAD)?;
    let exact = truth::meets(surface, &ray)?;
    let close = exact.share_of_error(hit.t, surface.shape().distance_error(&ray, &hit));
    assert!(close <= 1.0, "{close} times the closer bound: {place:?}");
    Some(exact.share_of_error(hit.t, hit.error))
}

/// The share of what a hit point is off by.
fn point(surface: &dyn Surface, place: &Place) -> Option<f64> {
    let ray = place.ray();
    let hit = surface.hits(&ray, Span::AHEAD)?;
    let exact = truth::meets(surface, &ray)?.near(hit.t, hit.error);
    share_of_rounding(
        &exact,
        &ray,
        hit.point,
        surface.shape().point_error() * hit.error,
    )
}
