//! Bounds that are as wide as their proofs say, whatever a search finds.

use glam::{DVec2, DVec3};
use heliodon::geometry::Rectangle;
use heliodon::math::{Crossing, Decisions, Flat, Point, Ray, RayOrigin, Span, UNIT};

/// Each bound is at least what the longest path of its expression can round, in the worst case of
/// all roundings at once, which no search finds.
#[test]
fn no_bound_is_smaller_than_its_proof() {
    let quotient = crossing(2f64.powi(100)).error(1.0);
    let flat = Flat::with_unit_normal(DVec3::ZERO, DVec3::Z);
    let down = |point: DVec3| Ray::new(Point::exact(point), DVec3::NEG_Z);
    let height = flat.crossing(&down(DVec3::Z)).expect("a plane below").doubt;
    let foot = RayOrigin::new(
        (None, None),
        &down(DVec3::Z),
        Point::exact(DVec3::ZERO),
        0.0,
    )
    .rounding();
    let least = [
        (
            "D: a product, two sums, and the neighbour's normal",
            slope_bound(),
            6.4,
        ),
        (
            "N: two roundings of c, a product, two sums, and that normal",
            height,
            7.0,
        ),
        (
            "v·(d × c): two more products and a difference",
            moment_bound(),
            7.0,
        ),
        (
            "w D − x: a product, a difference and those of D",
            extent_bound(),
            5.0,
        ),
        ("t: more than the quotient's", quotient, 1.0),
        ("the foot of a hit: see Flat::foot", foot, 6.0),
    ];
    for (what, bound, roundings) in least {
        let bound = bound / UNIT;
        assert!(
            bound > roundings,
            "{what}: {roundings} u, and the bound is {bound} u"
        );
    }
}

/// The bound of a moment's error in units of `size`.
pub(super) fn moment_bound() -> f64 {
    first_certain(2f64.powi(-20), 1.0)
}

/// What the size of a rectangle adds to that, in units of its size.
fn extent_bound() -> f64 {
    first_certain(1.0, 2f64.powi(-40))
}

/// Where the filter of a square begins to be certain of a ray that comes down from a height beside
/// its lower left corner.
fn first_certain(side: f64, height: f64) -> f64 {
    let square = Rectangle::new(DVec3::ZERO, DVec3::Z, DVec3::X, DVec2::splat(side));
    let square = square.expect("a square");
    let is_certain = |place: f64| {
        let from = DVec3::new(place, place, height);
        let before = Decisions::of_this_thread();
        let down = Ray::new(Point::exact(from), DVec3::NEG_Z);
        let hit = square.intersect(&down, Span::AHEAD);
        assert!(hit.is_some(), "{place}");
        Decisions::of_this_thread() == before
    };
    let (mut low, mut high) = (0.0, side * 2f64.powi(-20));
    assert!(
        is_certain(high) && !is_certain(low),
        "all or none is certain"
    );
    while high - low > 0.01 * UNIT {
        let middle = 0.5 * (low + high);
        if is_certain(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

/// A crossing at the origin where only the slope adds to the error of the distance.
fn crossing(slope: f64) -> Crossing {
    Crossing {
        origin: DVec3::ZERO,
        height: 0.0,
        slope,
        rises: true,
        doubt: 0.0,
        at_start: None,
        grazing: None,
    }
}

/// The bound of the slope's error, read off the error of a distance where nothing else counts.
pub(super) fn slope_bound() -> f64 {
    let slope = 2f64.powi(-100);
    crossing(slope).error(1.0) * slope
}
