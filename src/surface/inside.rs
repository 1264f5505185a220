//! The inside of round things that rays go into: where such rays come out.

use glam::DVec3;

use super::chord::{Chord, Quadratic, Roundings, side_of_ball};
use super::{Hit, Surface};
use crate::math::exact::{Distance, Sign};
use crate::math::{Ray, Segment, Side};

/// A round thing, which in a space of its own is a ball around the origin.
///
/// An opaque one, and one that bends nothing, is seen from outside only. Of one that light is bent
/// by, a ray that is inside meets the far side.
pub(super) trait Round: Surface {
    /// How far rounding puts off what is computed in the space of the ball.
    const ROUNDINGS: Roundings;

    /// The centre and the half axes.
    fn center_and_axes(&self) -> [DVec3; 2];

    /// The radius of the ball.
    fn ball_radius(&self) -> f64;

    /// A vector from the centre in the space of the ball.
    fn in_ball(&self, vector: DVec3) -> DVec3;

    /// By how much that makes a vector longer at most.
    fn most_stretch(&self) -> f64;

    /// The equation of the distances at which a ray meets the surface.
    fn equation(&self, ray: &Ray) -> Quadratic;

    /// The distance at which a ray from outside enters, and its error.
    fn entry(&self, ray: &Ray) -> Option<(f64, f64)>;

    /// The distance at which a ray meets the surface, and its error.
    #[inline(always)]
    fn meeting(&self, ray: &Ray) -> Option<(f64, f64)> {
        if self.common().material.is_entered() {
            self.meeting_from_either_side(ray)
        } else {
            self.entry(ray)
        }
    }

    /// [`meeting`](Self::meeting) if rays can be inside.
    fn meeting_from_either_side(&self, ray: &Ray) -> Option<(f64, f64)> {
        match self.start(ray) {
            Start::Inside => Some(self.chord(ray).exit()),
            Start::InsideOfIt => Some(self.chord(ray).whole()),
            Start::Outside => self.entry(ray),
            Start::OutsideOfIt => None,
        }
    }

    /// The error of a hit's distance, by the way from the centre to the ray's origin.
    fn own_error(&self, ray: &Ray, hit: &Hit) -> f64 {
        let is_entry = !self.common().material.is_entered() || self.start(ray) == Start::Outside;
        // Where a ray comes out, the hit's own bound knows no more than that way, either.
        let own = || self.chord(ray).error_of_end();
        if is_entry {
            hit.error.min(own())
        } else {
            hit.error
        }
    }

    /// The same, exactly; of use only where the ray meets the surface.
    fn exact_meeting(&self, ray: &Ray) -> Option<Distance> {
        let equation = self.equation(ray);
        if !self.common().material.is_entered() {
            return equation.entry();
        }
        match self.start(ray) {
            Start::Inside => equation.exit(),
            Start::InsideOfIt => equation.whole(),
            Start::Outside => equation.entry(),
            Start::OutsideOfIt => None,
        }
    }

    /// Whether a segment that starts inside passes through the surface; `None` if it does not start
    /// there, or nothing ever does. `end` is the side that the segment's end is on.
    fn lets_out(&self, segment: &Segment, end: Side) -> Option<bool> {
        if !self.common().material.is_entered() {
            return None;
        }
        match self.start(&segment.ray) {
            Start::Outside => None,
            Start::OutsideOfIt => Some(false),
            Start::Inside | Start::InsideOfIt => {
                let leaves = || self.meeting_from_either_side(&segment.ray);
                let within =
                    |(t, error): (f64, f64)| segment.admits(t.min(segment.length), || error, None);
                Some(end == Side::Front && leaves().is_some_and(within))
            }
        }
    }

    /// Where a ray starts.
    ///
    /// A ray that leaves this very surface is on the side to which it went. Of others the start is
    /// rounded, so close to the surface its own side means nothing; but the ray that arrived there
    /// did not cross the surface, so the side is the one on which that ray started.
    fn start(&self, ray: &Ray) -> Start {
        let [center, axes] = self.center_and_axes();
        match ray.goes_inside([center, axes]) {
            Some(true) => return Start::InsideOfIt,
            Some(false) => return Start::OutsideOfIt,
            None => {}
        }
        let mut ray = *ray;
        loop {
            let (way, size) = ray.origin.seen_from(center);
            let stretch = self.most_stretch();
            let (size, rounding) = (size * stretch, ray.rounding() * stretch);
            let (way, radius) = (self.in_ball(way), self.ball_radius());
            let side = side_of_ball(way, size, rounding, radius, Self::ROUNDINGS);
            let inside = match (side, ray.ray_origin) {
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

    /// Whether a ray in free space starts inside; of those that start on the surface, the ones that
    /// go inside do.
    fn exactly_inside(&self, ray: &Ray) -> bool {
        match self.side(&ray.origin) {
            Side::Back => true,
            Side::On => self.equation(ray).b.sign() == Sign::Positive,
            Side::Front => false,
        }
    }

    /// The chord of the ray's line.
    fn chord(&self, ray: &Ray) -> Chord {
        let (way, size) = ray.origin.seen_from(self.center_and_axes()[0]);
        let size = size * self.most_stretch();
        let dir = self.in_ball(ray.dir);
        let (way, radius) = (self.in_ball(way), self.ball_radius());
        let speed_squared = dir.length_squared();
        Chord::of_line(way, size, dir, speed_squared, radius, Self::ROUNDINGS)
    }
}

/// Where a ray starts, seen from a round thing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Start {
    /// Outside.
    Outside,
    /// On the surface, from which it leads away.
    OutsideOfIt,
    /// Inside.
    Inside,
    /// On the surface, through which it leads inside.
    InsideOfIt,
}
