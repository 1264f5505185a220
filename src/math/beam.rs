//! Ray differentials: the rays of one pixel around its middle ray.

use glam::DVec3;

use super::{Flat, Footprint, Point};

/// A ray and its differentials: the changes of origin and direction per pixel.
///
/// From the eye and behind flat mirrors all rays go through one point, and footprints are exact.
/// Behind round mirrors they are right to first order (Igehy 1999, "Tracing Ray Differentials").
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam {
    origin: Point,
    /// The direction, of any length.
    dir: DVec3,
    /// The change of the origin for one pixel to the right and for one pixel up.
    origin_steps: [DVec3; 2],
    /// The change of the direction for the same.
    dir_steps: [DVec3; 2],
}

impl Beam {
    /// The rays from one point; direction and steps share a unit of length.
    #[must_use]
    pub fn new(apex: Point, dir: DVec3, steps: [DVec3; 2]) -> Self {
        Self {
            origin: apex,
            dir,
            origin_steps: [DVec3::ZERO; 2],
            dir_steps: steps,
        }
    }

    /// The footprint on a plane through this corner with these unit axes.
    #[must_use]
    pub fn on(&self, corner: DVec3, axes: [DVec3; 2], normal: DVec3) -> Footprint {
        let way = self.origin.from(corner);
        // The crossing is at way − dir (n·way / n·dir), here times n·dir. Where the origin changes
        // from ray to ray, products of two steps are left out.
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
        // Points ahead have a depth above zero, even if the middle is beyond the horizon.
        let ahead = if height > 0.0 { -1.0 } else { 1.0 };
        Footprint {
            center: center * ahead,
            steps: [step(0) * ahead, step(1) * ahead],
        }
    }

    /// The change of the hit point from pixel to pixel on a surface with this normal.
    #[must_use]
    pub fn steps_at(&self, point: &Point, normal: DVec3) -> [DVec3; 2] {
        let slope = normal.dot(self.dir);
        let distance = self.distance(point);
        [0, 1].map(|number| {
            let moved = self.origin_steps[number] + self.dir_steps[number] * distance;
            moved - self.dir * (normal.dot(moved) / slope)
        })
    }

    /// The distance of a point along the ray, in lengths of the direction.
    fn distance(&self, point: &Point) -> f64 {
        point.way_from(&self.origin).dot(self.dir) / self.dir.length_squared()
    }

    /// The differential behind a flat mirror.
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

    /// The differential behind a round mirror with these half axes.
    ///
    /// `point` is the hit, anchored at the centre.
    #[must_use]
    pub fn mirrored_at(&self, point: Point, normal: DVec3, axes: DVec3) -> Self {
        let origin_steps = self.steps_at(&point, normal);
        let length = self.dir.length();
        let dir = self.dir / length;
        // The normal is along the offset over the squares of the half axes.
        let steepness = (point.offset / axes / axes).length();
        let falls = dir.dot(normal);
        let dir_steps = [0, 1].map(|number| {
            let dir_step = self.dir_steps[number] / length;
            let dir_step = dir_step - dir * dir.dot(dir_step);
            let tilt = origin_steps[number] / axes / axes / steepness;
            let tilt = tilt - normal * normal.dot(tilt);
            let falls_step = dir_step.dot(normal) + dir.dot(tilt);
            dir_step - (tilt * falls + normal * falls_step) * 2.0
        });
        Self {
            origin: point,
            dir: dir - normal * (2.0 * falls),
            origin_steps,
            dir_steps,
        }
    }

    /// The differential in another direction, as wide as before at the point.
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

    /// The floor crossing of the ray at a point of the pixel.
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

    /// Compares the steps behind a round mirror with rays a little aside.
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
