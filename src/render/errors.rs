//! Errors of hits along a path.

use glam::DVec3;

use super::scattering::{Scattering, times};
use crate::geometry::{Hit, Shape};
use crate::math::Ray;
use crate::math::error_bounds::FOOT;

/// The errors that rounding may have caused along a path, at a hit.
///
/// For a camera ray, and one straight through transparent surfaces, they are bounds. Behind a
/// reflection or refraction they are estimates: to first order, for the largest curvature of each
/// surface. They are infinite if the first order does not suffice.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Errors {
    /// The error of the hit point, in world units.
    pub place: f64,
    /// The error of the ray's direction, in radians.
    pub direction: f64,
    /// The number of reflections and transmissions before the hit.
    pub bounces: u32,
    /// The distance from the ray's exact path there, in world units.
    ///
    /// It holds for the arriving ray, and for a ray that starts there in the same direction.
    lateral: f64,
}

impl Errors {
    /// The errors at the next hit of the path.
    #[must_use]
    pub fn at(self, ray: &Ray, hit: &Hit, shape: &Shape) -> Self {
        let (_, start) = ray.origin.seen_from(hit.point.anchor);
        let rounding = FOOT * (start + hit.point.offset.abs().element_sum());
        let point_error = shape.point_error() * shape.distance_error(ray, hit) + rounding;
        let lateral = self.lateral + times(self.direction, hit.t);
        // A ray that is off its path moves its hit along the surface, by that distance divided by
        // the cosine of the angle to the normal.
        let slide = times(lateral, 1.0 / ray.dir.dot(hit.normal).abs());
        Self {
            place: slide + point_error,
            lateral: lateral + point_error,
            ..self
        }
    }

    /// The errors behind a surface that scatters a path along unit `dir`.
    #[must_use]
    #[inline(never)]
    pub fn behind(self, shape: &Shape, scattering: Scattering, dir: DVec3, normal: DVec3) -> Self {
        let curvature = shape.round().map_or(0.0, |[_, axes]| {
            // An ellipse is most curved at the ends of its long axis.
            axes.max_element() / axes.min_element().powi(2)
        });
        let tilt = times(curvature, self.place);
        let cosine = dir.dot(normal).abs().min(1.0);
        let [lateral, direction] = scattering.behind([self.lateral, self.direction], tilt, cosine);
        Self {
            lateral,
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
            lateral: 1e-7,
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
            let lateral = 1e-3;
            let from = |start: DVec3| Ray::new(Point::exact(start - dir), dir);
            let hit = |ray: &Ray| floor.intersect(ray, Span::AHEAD).expect("the floor");
            let errors = Errors {
                lateral,
                ..Errors::default()
            };
            let (own, other) = (from(DVec3::ZERO), from(dir.cross(DVec3::Z) * lateral));
            let hits = [hit(&own), hit(&other)];
            let apart = hits[1].point.world() - hits[0].point.world();
            let share = apart.length() / errors.at(&own, &hits[0], &floor).place;
            assert!(share <= 1.0 + 1e-12 && share > 0.999, "{share}");
        }
    }
}
