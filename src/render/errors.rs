//! How far off a hit may be.

use glam::DVec3;

use crate::math::Ray;
use crate::math::band::{FOOT, UNIT};
use crate::surface::{Hit, Surface};

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

/// How a ray goes on where it meets a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Turn {
    /// In its own direction, bit for bit.
    Straight,
    /// Mirrored.
    Mirrored,
    /// Bent, between media whose indices of refraction have this ratio, that before the surface to that
    /// behind it.
    Bent(f64),
}

impl Errors {
    /// The errors at the next hit of the path.
    ///
    /// Where a ray passes beside its way, its hit slides along the surface: by as much as that, divided by
    /// the cosine of the angle to the normal.
    #[must_use]
    pub fn at(self, ray: &Ray, hit: &Hit, surface: &dyn Surface) -> Self {
        let (_, start) = ray.origin.seen_from(hit.point.anchor);
        let rounding = FOOT * (start + hit.point.offset.abs().element_sum());
        let slip = surface.slip() * surface.error(ray, hit) + rounding;
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
    pub fn behind(self, surface: &dyn Surface, turn: Turn, dir: DVec3, normal: DVec3) -> Self {
        let curvature = surface.round().map_or(0.0, |[_, axes]| {
            // An ellipse is most curved at the ends of its long axis.
            axes.max_element() / axes.min_element().powi(2)
        });
        let tilt = times(curvature, self.place);
        let (beside, direction) = match turn {
            Turn::Straight => (self.beside, self.direction),
            Turn::Mirrored => (self.beside, self.mirrored(tilt)),
            Turn::Bent(ratio) => self.bent(tilt, ratio, dir.dot(normal).abs().min(1.0)),
        };
        Self {
            beside,
            // To first order says nothing of large angles.
            direction: if direction < 1.0 {
                direction
            } else {
                f64::INFINITY
            },
            bounces: self.bounces + 1,
            ..self
        }
    }

    /// By how much the direction may be wrong behind a mirror whose normal is off by `tilt`: by twice
    /// that more.
    fn mirrored(self, tilt: f64) -> f64 {
        // Twice the product with the normal is off by 6 u, and taking it off and making the rest
        // unit add 3 and 5.
        const MIRRORING: f64 = 16.0 * UNIT;
        self.direction + 2.0 * tilt + MIRRORING
    }

    /// How far beside its way a ray may be that was bent, and by how much its direction may be wrong.
    ///
    /// With `μ` for the ratio, the law of refraction is `sin β = μ sin α`. So if the ray before is off in the
    /// plane of both rays, that behind is off by `μ cos α / cos β` times as much; if it is turned about
    /// the normal, their parts along the surface turn by the same angle, which is `μ` times as much. And
    /// if the normal is off by an angle, so is `α`, but `β` is counted from that normal: in the plane the ray
    /// is off by `|μ cos α / cos β − 1|` times the angle, and across by `|μ cos α − cos β|` times, which is
    /// less.
    ///
    /// Towards the angle of total reflection `cos β` goes to zero, and these grow without bound. So they
    /// are taken for the largest `α` that may be; if nothing passes at that one, all is unknown.
    ///
    /// Rounding puts `cos α` off by 5 u, so `μ² sin² α` by `(10 μ² + 5) u`, the root `cos β` by half of that and u,
    /// divided by itself, and the unit direction by `(10 μ + 12) u` more.
    ///
    /// What slides along the surface by `1 / cos α` passes the ray behind at `cos β / cos α`.
    fn bent(self, tilt: f64, ratio: f64, cosine: f64) -> (f64, f64) {
        let angle = self.direction + tilt + 16.0 * UNIT;
        let sine = (1.0 - cosine * cosine).sqrt();
        let most = ratio * (sine + angle);
        if most.is_nan() || most >= 1.0 {
            return (f64::INFINITY, f64::INFINITY);
        }
        let [cosine_at_least, cosine_at_most] = [ratio * (sine - angle).max(0.0), most]
            .map(|bent_sine| (1.0 - bent_sine * bent_sine).sqrt());
        let in_plane = ratio * (cosine + angle) / cosine_at_most;
        let of_tilt = if ratio > 1.0 {
            in_plane - 1.0
        } else {
            1.0 - ratio * (cosine - angle) / cosine_at_least
        };
        let rounding = ((5.0 * ratio * ratio + 3.0) / cosine_at_most + 10.0 * ratio + 12.0) * UNIT;
        let direction = self.direction * ratio.max(in_plane) + tilt * of_tilt + rounding;
        let widening = (cosine_at_least / cosine).max(1.0);
        (times(self.beside, widening), direction)
    }
}

/// A product of errors: none of anything is none.
fn times(error: f64, factor: f64) -> f64 {
    if error == 0.0 || factor == 0.0 {
        0.0
    } else {
        error * factor
    }
}

#[cfg(test)]
mod tests {
    use dashu::float::FBig;

    use super::*;
    use crate::math::{Point, Refraction, direction};
    use crate::surface::{Common, Plane, Sphere};

    const RATIOS: [f64; 6] = [0.4, 1.0 / 1.5, 0.99, 1.333, 1.5, 2.4];

    /// A plane, or a ball of radius 1.
    fn surface(is_round: bool) -> Box<dyn Surface> {
        let common = Common::black(None, None);
        if is_round {
            Box::new(Sphere::new(common, DVec3::ZERO, 1.0, None).expect("a ball"))
        } else {
            Box::new(Plane::new(common, DVec3::ZERO, DVec3::Y).expect("a plane"))
        }
    }

    fn falling(angle: f64) -> DVec3 {
        DVec3::new(libm::sin(angle), -libm::cos(angle), 0.0)
    }

    fn angles() -> impl Iterator<Item = f64> {
        (0..157).map(|hundredth| f64::from(hundredth) / 100.0)
    }

    fn turned(dir: DVec3, normal: DVec3, turn: Turn) -> Option<DVec3> {
        match turn {
            Turn::Straight => Some(dir),
            Turn::Mirrored => Some(Ray::new(Point::exact(DVec3::ZERO), dir).mirrored(normal)),
            Turn::Bent(ratio) => Refraction::new(dir, normal, ratio, 1.0).bent,
        }
    }

    /// The largest angle by which a ray is off when its direction and the normal are off by these in
    /// any way; `None` if there is no ray then.
    fn largest(angle: f64, turn: Turn, off: f64, tilt: f64) -> Option<f64> {
        let dir = falling(angle);
        let across = [direction(dir.cross(DVec3::Z)), DVec3::Z];
        let expected = turned(dir, DVec3::Y, turn)?;
        let mut largest = 0f64;
        for step in 0..256 {
            let (first, second) = (f64::from(step % 16) / 8.0, f64::from(step / 16) / 8.0);
            let way = |turns: f64, [x, y]: [DVec3; 2]| {
                let turns = turns * std::f64::consts::PI;
                x * libm::cos(turns) + y * libm::sin(turns)
            };
            let dir = direction(dir + way(first, across) * off);
            let normal = direction(DVec3::Y + way(second, [DVec3::X, DVec3::Z]) * tilt);
            largest = largest.max((turned(dir, normal, turn)? - expected).length());
        }
        Some(largest)
    }

    #[test]
    fn what_is_off_before_a_surface_is_off_behind_it_by_no_more_than_said() {
        let mut compared = 0;
        let turns = RATIOS
            .map(Turn::Bent)
            .into_iter()
            .chain([Turn::Mirrored, Turn::Straight]);
        for turn in turns {
            for angle in angles() {
                for (off, tilt) in [(1e-6, 0.0), (0.0, 1e-6), (1e-6, 1e-6), (1e-6, 1e-9)] {
                    let before = Errors {
                        direction: off,
                        place: tilt,
                        ..Errors::default()
                    };
                    let behind = before.behind(&*surface(true), turn, falling(angle), DVec3::Y);
                    let Some(found) = largest(angle, turn, off, tilt) else {
                        assert!(behind.direction.is_infinite(), "{turn:?} {angle}");
                        continue;
                    };
                    let said = behind.direction;
                    assert!(
                        found <= said * (1.0 + 1e-5) + 1e-15,
                        "{found} {said} {turn:?} {angle}"
                    );
                    if let Turn::Bent(ratio) = turn
                        && ratio * libm::sin(angle) > 0.999
                    {
                        continue;
                    }
                    assert!(
                        said <= 2.0 * found + 1e-13,
                        "{found} {said} {turn:?} {angle} {off} {tilt}"
                    );
                    compared += 1;
                }
            }
        }
        assert!(compared > 3000, "{compared}");
    }

    #[test]
    fn what_goes_straight_on_is_off_by_no_more_behind() {
        let before = Errors {
            direction: 1e-9,
            place: 1e-3,
            beside: 1e-7,
            ..Errors::default()
        };
        let behind = before.behind(&*surface(true), Turn::Straight, falling(0.3), DVec3::Y);
        assert_eq!(
            behind,
            Errors {
                bounces: 1,
                ..before
            }
        );
    }

    #[test]
    fn near_total_reflection_nothing_is_known_and_never_not_a_number() {
        let critical = libm::asin(1.0 / 1.5);
        let near = |off: f64, below: f64, direction: f64| {
            let before = Errors {
                direction,
                place: off,
                beside: off,
                ..Errors::default()
            };
            before.behind(
                &*surface(true),
                Turn::Bent(1.5),
                falling(critical - below),
                DVec3::Y,
            )
        };
        assert!(near(0.0, 1e-9, 0.0).direction < 1e-9);
        assert!(near(0.0, 1e-9, 1e-8).direction.is_infinite());
        for off in [0.0, 1e-300, 1e-9, 1.0, 1e300, f64::INFINITY] {
            for below in [0.0, 1e-16, 1e-12, 0.1, critical] {
                for direction in [0.0, 1e-9, f64::INFINITY] {
                    let mut errors = near(off, below, direction);
                    for turn in [
                        Turn::Mirrored,
                        Turn::Bent(1.5),
                        Turn::Bent(0.5),
                        Turn::Straight,
                    ] {
                        for dir in [DVec3::X, DVec3::NEG_Y, falling(0.7)] {
                            errors = errors.behind(&*surface(true), turn, dir, DVec3::Y);
                            let numbers = [errors.place, errors.direction, errors.beside];
                            assert!(numbers.iter().all(|it| !it.is_nan()), "{errors:?}");
                        }
                    }
                }
            }
        }
    }

    type Big = FBig;

    fn big(number: f64) -> Big {
        Big::try_from(number)
            .expect("finite")
            .with_precision(300)
            .value()
    }

    /// Where a ray is bent to with hundreds of digits, as unit vectors along what is given.
    fn bent_precisely(dir: DVec3, normal: DVec3, ratio: f64) -> [Big; 3] {
        let dot = |a: &[Big; 3], b: &[Big; 3]| &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2];
        let unit = |vector: DVec3| {
            let vector = vector.to_array().map(big);
            let length = dot(&vector, &vector).sqrt();
            vector.map(|it| it / &length)
        };
        let (dir, normal, ratio) = (unit(dir), unit(normal), big(ratio));
        let falls = -dot(&dir, &normal);
        let squared = &ratio * &ratio * (big(1.0) - &falls * &falls);
        let ahead = &ratio * falls - (big(1.0) - squared).sqrt();
        [0, 1, 2].map(|axis| &dir[axis] * &ratio + &normal[axis] * &ahead)
    }

    #[test]
    fn the_rounding_of_a_bend_is_within_what_is_said_and_not_far_below() {
        for ratio in RATIOS {
            for angle in angles().skip(1) {
                let (mut most, mut least_said) = (0f64, f64::INFINITY);
                for step in 0..24 {
                    let angle = angle + f64::from(step) * 1e-5;
                    let sideways = f64::from(step) * 0.3;
                    let normal = direction(DVec3::new(0.3, 0.9, sideways));
                    let along = direction(normal.cross(DVec3::new(1.0, sideways, 0.2)));
                    let dir = direction(along * libm::sin(angle) - normal * libm::cos(angle));
                    let Some(bent) = Refraction::new(dir, normal, ratio, 1.0).bent else {
                        continue;
                    };
                    let exact = bent_precisely(dir, normal, ratio);
                    let apart =
                        [0, 1, 2].map(|axis| (big(bent[axis]) - &exact[axis]).to_f64().value());
                    let apart = DVec3::from(apart).length();
                    let behind =
                        Errors::default().behind(&*surface(false), Turn::Bent(ratio), dir, normal);
                    assert!(apart <= behind.direction, "{apart} {behind:?}");
                    most = most.max(apart);
                    least_said = least_said.min(behind.direction);
                }
                let passes = least_said.is_finite();
                assert!(
                    !passes || least_said < 60.0 * most,
                    "{least_said} {most} {ratio} {angle}"
                );
            }
        }
    }

    #[test]
    fn a_ray_beside_its_way_slides_along_the_surface_and_leaves_beside_its_way() {
        let floor = surface(false);
        for (angle, turn) in angles().zip(RATIOS.map(Turn::Bent).into_iter().cycle()) {
            let dir = falling(angle);
            let beside = 1e-3;
            let from = |start: DVec3| Ray::new(Point::exact(start - dir), dir);
            let hit = |ray: &Ray| {
                floor
                    .hits(ray, crate::math::Span::AHEAD)
                    .expect("the floor")
            };
            let errors = Errors {
                beside,
                ..Errors::default()
            };
            let (own, other) = (from(DVec3::ZERO), from(dir.cross(DVec3::Z) * beside));
            let met = [hit(&own), hit(&other)];
            let apart = met[1].point.world() - met[0].point.world();
            let at = errors.at(&own, &met[0], &*floor);
            let share = apart.length() / at.place;
            assert!(share <= 1.0 + 1e-12 && share > 0.999, "{share}");
            let Some(bent) = turned(dir, DVec3::Y, turn) else {
                continue;
            };
            let leaves = (apart - bent * bent.dot(apart)).length();
            let said = at.behind(&*floor, turn, dir, DVec3::Y).beside;
            assert!(
                leaves <= said * (1.0 + 1e-12) && said <= leaves.max(beside) * 1.001,
                "{leaves} {said}"
            );
        }
    }
}
