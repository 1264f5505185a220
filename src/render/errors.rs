//! How far off a hit may be.

use glam::DVec3;

use super::scattering::{Scattering, times};
use crate::geometry::{Hit, Shape};
use crate::math::Ray;
use crate::math::error_bounds::FOOT;

/// What rounding may have done to a path by the time it meets a surface.
///
/// For a ray from the eye, and one that has gone straight through panes, this is a bound. Behind a mirror
/// or a bend it is an estimate: to first order, for the strongest curvature that a surface has
/// anywhere. It is infinite where rounding may have led the ray anywhere.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Errors {
    /// How far the hit may lie from where it ought to, in world units.
    pub place: f64,
    /// By how much the ray's direction may be wrong, in radians.
    pub direction: f64,
    /// How many mirrors or panes the path has met before.
    pub bounces: u32,
    /// How far beside its way a ray may pass there, in world units: the one that arrives, or one that
    /// starts there in the same direction.
    beside: f64,
}

impl Errors {
    /// The errors at the next hit of the path.
    ///
    /// Where a ray passes beside its way, its hit slides along the surface: by as much as that, divided by
    /// the cosine of the angle to the normal.
    #[must_use]
    pub fn at(self, ray: &Ray, hit: &Hit, shape: &Shape) -> Self {
        let (_, start) = ray.origin.seen_from(hit.point.anchor);
        let rounding = FOOT * (start + hit.point.offset.abs().element_sum());
        let slip = shape.point_error() * shape.distance_error(ray, hit) + rounding;
        let beside = self.beside + times(self.direction, hit.t);
        let slide = times(beside, 1.0 / ray.dir.dot(hit.normal).abs());
        Self {
            place: slide + slip,
            beside: beside + slip,
            ..self
        }
    }

    /// The errors behind a surface that sends the path on, which came along this unit direction.
    #[must_use]
    #[inline(never)]
    pub fn behind(self, shape: &Shape, turn: Scattering, dir: DVec3, normal: DVec3) -> Self {
        let curvature = shape.round().map_or(0.0, |[_, axes]| {
            // An ellipse is most curved at the ends of its long axis.
            axes.max_element() / axes.min_element().powi(2)
        });
        let tilt = times(curvature, self.place);
        let cosine = dir.dot(normal).abs().min(1.0);
        let [beside, direction] = turn.behind([self.beside, self.direction], tilt, cosine);
        Self {
            beside,
            direction,
            bounces: self.bounces + 1,
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Plane, Sphere};
    use crate::math::{Point, Span};

    fn falling(angle: f64) -> DVec3 {
        DVec3::new(libm::sin(angle), -libm::cos(angle), 0.0)
    }

    #[test]
    fn what_goes_straight_on_is_off_by_no_more_behind() {
        let before = Errors {
            direction: 1e-9,
            place: 1e-3,
            beside: 1e-7,
            ..Errors::default()
        };
        let ball = Shape::from(Sphere::new(DVec3::ZERO, 1.0).expect("a ball"));
        let behind = before.behind(&ball, Scattering::Straight, falling(0.3), DVec3::Y);
        assert_eq!(
            behind,
            Errors {
                bounces: 1,
                ..before
            }
        );
    }

    #[test]
    fn a_ray_beside_its_way_slides_along_the_surface() {
        let floor = Shape::from(Plane::new(DVec3::ZERO, DVec3::Y).expect("a plane"));
        for angle in (0..157).map(|hundredth| f64::from(hundredth) / 100.0) {
            let dir = falling(angle);
            let beside = 1e-3;
            let from = |start: DVec3| Ray::new(Point::exact(start - dir), dir);
            let hit = |ray: &Ray| floor.intersect(ray, Span::AHEAD).expect("the floor");
            let errors = Errors {
                beside,
                ..Errors::default()
            };
            let (own, other) = (from(DVec3::ZERO), from(dir.cross(DVec3::Z) * beside));
            let met = [hit(&own), hit(&other)];
            let apart = met[1].point.world() - met[0].point.world();
            let share = apart.length() / errors.at(&own, &met[0], &floor).place;
            assert!(share <= 1.0 + 1e-12 && share > 0.999, "{share}");
        }
    }
}
