//! The bundle of rays that one pixel stands for.

use glam::DVec3;

use super::{Flat, Footprint, Point};

/// A ray and its neighbours: how origin and direction change from pixel to pixel.
///
/// From the eye and behind flat mirrors all rays of a beam go through one point, and what is said
/// of its footprints is exact. Behind round mirrors it is right to first order (Igehy 1999,
/// "Tracing Ray Differentials").
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam {
    origin: Point,
    /// Of any length.
    dir: DVec3,
    /// What one pixel to the right and one upwards add to the origin.
    origin_steps: [DVec3; 2],
    /// What they add to the direction.
    dir_steps: [DVec3; 2],
}

impl Beam {
    /// The rays from one point; the direction is of any length, and what is added to it as well.
    #[must_use]
    pub fn new(apex: Point, dir: DVec3, steps: [DVec3; 2]) -> Self {
        Self {
            origin: apex,
            dir,
            origin_steps: [DVec3::ZERO; 2],
            dir_steps: steps,
        }
    }

    /// What it covers of a plane through this corner with these unit axes.
    #[must_use]
    pub fn on(&self, corner: DVec3, axes: [DVec3; 2], normal: DVec3) -> Footprint {
        let way = self.origin.from(corner);
        // The ray meets the plane at way − dir (n·way / n·dir), here times n·dir. Where the origin
        // moves from ray to ray, products of two steps are left out.
        let (height, slope) = (normal.dot(way), normal.dot(self.dir));
        let [x, y] = axes.map(|axis| axis.dot(way) * slope - axis.dot(self.dir) * height);
        let center = DVec3::new(x, y, slope);
        let step = |number: usize| {
            let (way_step, dir_step) = (self.origin_steps[number], self.dir_steps[number]);
            let (height_step, slope_step) = (normal.dot(way_step), normal.dot(dir_step));
            let [x, y] = axes.map(|axis| {
                axis.dot(way_step) * slope + axis.dot(way) * slope_step
                    - axis.dot(dir_step) * height
                    - axis.dot(self.dir) * height_step
            });
            DVec3::new(x, y, slope_step)
        };
        // What lies ahead has a depth above zero, even if the middle is beyond the horizon.
        let ahead = if height > 0.0 { -1.0 } else { 1.0 };
        Footprint {
            center: center * ahead,
            steps: [step(0) * ahead, step(1) * ahead],
        }
    }

    /// How far the place moves from pixel to pixel at which it meets a surface of this normal.
    #[must_use]
    pub fn steps_at(&self, point: &Point, normal: DVec3) -> [DVec3; 2] {
        let slope = normal.dot(self.dir);
        let distance = self.distance(point);
        [0, 1].map(|number| {
            let moved = self.origin_steps[number] + self.dir_steps[number] * distance;
            moved - self.dir * (normal.dot(moved) / slope)
        })
    }

    /// How many times its direction a point is away.
    fn distance(&self, point: &Point) -> f64 {
        point.way_from(&self.origin).dot(self.dir) / self.dir.length_squared()
    }

    /// The beam behind a flat mirror.
    #[must_use]
    pub fn mirrored_by(&self, flat: &Flat) -> Self {
        let normal = flat.normal;
        let mirrored = |vector: DVec3| vector - normal * (2.0 * normal.dot(vector));
        let height = normal.dot(self.origin.from(flat.point));
        Self {
            origin: Point {
                offset: self.origin.offset - normal * (2.0 * height),
                ..self.origin
            },
            dir: mirrored(self.dir),
            origin_steps: self.origin_steps.map(mirrored),
            dir_steps: self.dir_steps.map(mirrored),
        }
    }

    /// The beam behind a round mirror with these half axes, which it meets at a point that is seen
    /// from its centre.
    #[must_use]
    pub fn mirrored_at(&self, point: Point, normal: DVec3, axes: DVec3) -> Self {
        let origin_steps = self.steps_at(&point, normal);
        let length = self.dir.length();
        let dir = self.dir / length;
        // The normal is along the place over the squares of the half axes.
        let steepness = (point.offset / axes / axes).length();
        let falls = dir.dot(normal);
        let dir_steps = [0, 1].map(|number| {
            let turn = self.dir_steps[number] / length;
            let turn = turn - dir * dir.dot(turn);
            let tilt = origin_steps[number] / axes / axes / steepness;
            let tilt = tilt - normal * normal.dot(tilt);
            let falls_step = turn.dot(normal) + dir.dot(tilt);
            turn - (tilt * falls + normal * falls_step) * 2.0
        });
        Self {
            origin: point,
            dir: dir - normal * (2.0 * falls),
            origin_steps,
            dir_steps,
        }
    }

    /// The beam that goes on in another direction from a point, as wide as it would have become on
    /// its old way.
    #[must_use]
    pub fn turned(&self, point: Point, onward: DVec3) -> Self {
        let dir = onward * self.dir.length();
        Self {
            origin: Point {
                offset: point.offset - dir * self.distance(&point),
                ..point
            },
            dir,
            ..*self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::direction;
    use glam::DVec2;

    fn beam() -> Beam {
        let apex = Point::exact(DVec3::new(0.3, 2.0, 5.0));
        let steps = [DVec3::new(0.1, 0.0, 0.0), DVec3::new(0.0, 0.1, 0.02)];
        Beam::new(apex, DVec3::new(0.1, -0.4, -1.0), steps)
    }

    /// Where the ray of a place in the pixel meets the floor.
    fn on_floor(origin: DVec3, dir: DVec3) -> DVec2 {
        let met = origin - dir * (origin.y / dir.y);
        DVec2::new(met.x, -met.z)
    }

    #[test]
    fn a_footprint_is_where_its_rays_meet_the_plane() {
        let beam = beam();
        let footprint = beam.on(DVec3::ZERO, [DVec3::X, -DVec3::Z], DVec3::Y);
        for place in [DVec2::ZERO, DVec2::new(0.5, -0.5), DVec2::new(-0.3, 0.5)] {
            let [right, up] = beam.dir_steps;
            let ray = beam.dir + right * place.x + up * place.y;
            let image = footprint.image(place);
            let expected = on_floor(beam.origin.world(), ray);
            let found = image.truncate() / image.z;
            assert!((found - expected).length() < 1e-12, "{found} {expected}");
        }
    }

    #[test]
    fn a_flat_mirror_shows_the_floor_from_the_mirror_image_of_the_eye() {
        let wall = Flat::new(DVec3::new(0.0, 0.0, -3.0), DVec3::Z).expect("a plane");
        let mirrored = beam().mirrored_by(&wall);
        assert_eq!(mirrored.origin.world(), DVec3::new(0.3, 2.0, -11.0));
        assert_eq!(mirrored.dir, DVec3::new(0.1, -0.4, 1.0));
        let behind = mirrored.mirrored_by(&wall);
        assert_eq!(behind.dir, beam().dir);
    }

    /// The steps behind a round mirror against rays a little aside.
    #[test]
    fn a_round_mirror_spreads_a_beam() {
        let axes = DVec3::new(1.0, 0.5, 2.0);
        let beam = Beam::new(
            Point::exact(DVec3::new(0.2, 3.0, 0.3)),
            DVec3::new(0.0, -2.0, 0.1),
            [DVec3::new(0.01, 0.0, 0.0), DVec3::new(0.0, 0.001, 0.01)],
        );
        let mirror = |aside: DVec2| {
            let [right, up] = beam.dir_steps;
            let dir = direction(beam.dir + right * aside.x + up * aside.y);
            let origin = beam.origin.world();
            let (o, d) = (origin / axes, dir / axes);
            let (a, b, c) = (d.dot(d), o.dot(d), o.dot(o) - 1.0);
            let met = origin + dir * ((-b - (b * b - a * c).sqrt()) / a);
            let normal = direction(met / axes / axes);
            (met, dir - normal * (2.0 * dir.dot(normal)), normal)
        };
        let (met, dir, normal) = mirror(DVec2::ZERO);
        let point = Point {
            anchor: DVec3::ZERO,
            offset: met,
        };
        let mirrored = beam.mirrored_at(point, normal, axes);
        assert!((mirrored.dir - dir).length() < 1e-12);
        let small = 0.001;
        for (number, aside) in [DVec2::X, DVec2::Y].into_iter().enumerate() {
            let (there, turned, _) = mirror(aside * small);
            let (back, turned_back, _) = mirror(aside * -small);
            let moved = (there - back) / (2.0 * small);
            let turn = (turned - turned_back) / (2.0 * small);
            assert!((mirrored.origin_steps[number] - moved).length() < 1e-6 * moved.length());
            assert!((mirrored.dir_steps[number] - turn).length() < 1e-5 * turn.length());
        }
    }
}
