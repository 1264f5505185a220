//! Round shapes: rays that enter them, and rays that leave them from inside.

use glam::DVec3;

use super::Hit;
use super::chord::{Chord, Quadratic, Roundings, is_beyond, side_of_ball};
use crate::math::exact::{Distance, Exact, Sign};
use crate::math::{Point, Ray, Segment, Side, Span, direction};

/// A round shape: a sphere around the origin in a space of its own.
///
/// Rays hit the outside. Rays that start inside hit the far side if
/// [`is_entered`](Self::is_entered).
pub(super) trait Round {
    /// The rounding errors in the space of the sphere.
    const ROUNDINGS: Roundings;

    /// Centre and half axes.
    fn extent(&self) -> [DVec3; 2];

    /// Returns whether rays can be inside: the surface refracts.
    fn is_entered(&self) -> bool;

    /// The radius of the sphere.
    fn ball_radius(&self) -> f64;

    /// A vector from the centre, in the space of the sphere.
    fn in_ball(&self, vector: DVec3) -> DVec3;

    /// The unit normal where a unit vector of that space points.
    fn normal(&self, on_ball: DVec3) -> DVec3;

    /// The largest factor by which [`in_ball`](Self::in_ball) makes a vector longer.
    fn most_stretch(&self) -> f64;

    /// The exact equation of the distances at which a ray hits the surface.
    fn equation(&self, ray: &Ray) -> Quadratic;

    /// The exact scalar product in the space of the sphere, times a positive factor.
    fn exact_dot(&self, from_center: &Point, dir: DVec3) -> Exact;

    /// The distance at which a ray from outside enters, and its error bound.
    fn entry(&self, ray: &Ray) -> Option<(f64, f64)>;

    /// The exact side of a point.
    fn side(&self, point: &Point) -> Side;

    #[inline(always)]
    fn intersect(&self, ray: &Ray, span: Span) -> Option<Hit> {
        let distance = if self.is_entered() {
            self.distance_from_either_side(ray)
        } else {
            self.entry(ray)
        };
        let (t, error) = distance.filter(|(t, error)| span.admits(*t, *error))?;
        let [center, axes] = self.extent();
        let on_ball = direction(self.in_ball(ray.origin.from(center) + ray.dir * t));
        // Pushed out radially onto the surface, which the rounded point is not on.
        let point = Point {
            anchor: center,
            offset: on_ball * axes,
        };
        Some(Hit::new(t, error, point, self.normal(on_ball)))
    }

    /// Returns whether the surface stands between the ends of a segment.
    fn occludes(&self, segment: &Segment, end: Side) -> bool {
        if let Some(passes) = self.lets_out(segment, end) {
            return passes;
        }
        let Some((t, error)) = self.entry(&segment.ray) else {
            return false;
        };
        // Inside, the line passes the point nearest to the centre. An end outside is before or
        // beyond both that point and the whole sphere.
        let dir = segment.ray.dir;
        let parts = segment.end.parts_from(self.extent()[0]);
        let beyond = || {
            let parts = parts.map(|part| self.in_ball(part));
            is_beyond(parts, self.in_ball(dir), || {
                self.exact_dot(&segment.end, dir)
            })
        };
        (end == Side::Back || beyond()) && segment.admits(t, || error, None)
    }

    /// The exact distance at which a ray hits the surface.
    fn exact_distance(&self, ray: &Ray) -> Option<Distance> {
        let equation = self.equation(ray);
        if !self.is_entered() {
            return equation.entry();
        }
        match self.start(ray) {
            Start::Inside => equation.exit(),
            Start::Entering => equation.whole(),
            Start::Outside => equation.entry(),
            Start::Leaving => None,
        }
    }

    /// An error bound of a hit's distance, from the centre-to-origin vector.
    fn distance_error(&self, ray: &Ray, hit: &Hit) -> f64 {
        let is_entry = !self.is_entered() || self.start(ray) == Start::Outside;
        // For a ray that leaves, the hit's own bound depends on that vector only, too.
        if is_entry {
            self.chord(ray).error_of_end()
        } else {
            hit.error
        }
    }

    /// The distance of a ray's hit if rays can be inside, and its error bound.
    fn distance_from_either_side(&self, ray: &Ray) -> Option<(f64, f64)> {
        match self.start(ray) {
            Start::Inside => Some(self.chord(ray).exit()),
            Start::Entering => Some(self.chord(ray).whole()),
            Start::Outside => self.entry(ray),
            Start::Leaving => None,
        }
    }

    /// Returns whether a segment that starts inside passes through the surface.
    ///
    /// `None` if it does not start there, or if rays cannot. `end` is the side of the segment's
    /// end.
    fn lets_out(&self, segment: &Segment, end: Side) -> Option<bool> {
        if !self.is_entered() {
            return None;
        }
        match self.start(&segment.ray) {
            Start::Outside => None,
            Start::Leaving => Some(false),
            Start::Inside | Start::Entering => {
                let leaves = || self.distance_from_either_side(&segment.ray);
                let within =
                    |(t, error): (f64, f64)| segment.admits(t.min(segment.length), || error, None);
                Some(end == Side::Front && leaves().is_some_and(within))
            }
        }
    }

    /// The start of a ray relative to the shape.
    fn start(&self, ray: &Ray) -> Start {
        let [center, axes] = self.extent();
        // A ray that leaves this very surface is on the side to which it went.
        match ray.goes_inside([center, axes]) {
            Some(true) => return Start::Entering,
            Some(false) => return Start::Leaving,
            None => {}
        }
        // Other starts are rounded, so within rounding of the surface their side means nothing. The
        // arriving ray did not cross the surface, so the side is that of its own start.
        let mut ray = *ray;
        loop {
            let (way, size) = ray.origin.seen_from(center);
            let stretch = self.most_stretch();
            let (size, rounding) = (size * stretch, ray.rounding() * stretch);
            let (way, radius) = (self.in_ball(way), self.ball_radius());
            let side = side_of_ball(way, size, rounding, radius, Self::ROUNDINGS);
            let inside = match (side, ray.spawned_from) {
                (Some(side), _) => side == Sign::Negative,
                (None, None) => self.exactly_inside(&ray),
                (None, Some(ray_origin)) => {
                    ray = *ray_origin.arriving;
                    match ray.goes_inside([center, axes]) {
                        Some(inside) => inside,
                        None => continue,
                    }
                }
            };
            return if inside {
                Start::Inside
            } else {
                Start::Outside
            };
        }
    }

    /// Returns whether a free ray starts inside, or on the surface and goes inside.
    fn exactly_inside(&self, ray: &Ray) -> bool {
        match self.side(&ray.origin) {
            Side::Back => true,
            Side::On => self.equation(ray).b.sign() == Sign::Positive,
            Side::Front => false,
        }
    }

    /// The chord of the ray's line.
    fn chord(&self, ray: &Ray) -> Chord {
        let (way, size) = ray.origin.seen_from(self.extent()[0]);
        let size = size * self.most_stretch();
        let dir = self.in_ball(ray.dir);
        let (way, radius) = (self.in_ball(way), self.ball_radius());
        let speed_squared = dir.length_squared();
        Chord::of_line(way, size, dir, speed_squared, radius, Self::ROUNDINGS)
    }
}

/// The start of a ray relative to a round shape.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Start {
    /// Outside.
    Outside,
    /// On the surface, away from which it goes.
    Leaving,
    /// Inside.
    Inside,
    /// On the surface, through which it goes inside.
    Entering,
}
