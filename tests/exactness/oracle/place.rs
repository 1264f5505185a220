//! A plane or a ball and a ray at it, as numbers that can be changed a little.

use glam::DVec3;
use heliodon::math::{Flat, Point, Ray, UNIT, unit};

use support::random::Random;

/// A plane and a ray, as numbers that can be changed a little.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    pub(crate) point: DVec3,
    pub(crate) normal: DVec3,
    /// The normal of a neighbour in the same plane, which decides, less this one's.
    pub(crate) tilt: DVec3,
    pub(crate) anchor: DVec3,
    pub(crate) offset: DVec3,
    pub(crate) dir: DVec3,
}

impl Place {
    pub(crate) fn any(random: &mut Random) -> Self {
        let direction = |random: &mut Random| unit(random.cube()).unwrap_or(DVec3::X);
        let normal = direction(random);
        // Any, nearly along the normal, or nearly along the plane, where distances are least certain.
        let dir = match random.below(4) {
            0 | 1 => Some(direction(random)),
            2 => unit(normal + random.cube() * random.power(-20, -2)),
            _ => {
                let way = random.cube();
                let along = unit(way - normal * normal.dot(way)).unwrap_or(DVec3::X);
                unit(along + normal * (random.signed() * random.power(-24, -2)))
            }
        };
        let dir = dir.unwrap_or(normal);
        // The rounding of a difference is largest where both terms are there and add up.
        let anchor = if random.once_in(4) {
            -dir
        } else {
            random.cube()
        };
        Self {
            point: anchor * -random.share(),
            normal,
            tilt: random.cube() * (2.0 * UNIT),
            anchor,
            offset: random.cube() * random.power(-30, 0),
            dir,
        }
    }

    /// The same but for some numbers, one more often than several.
    pub(crate) fn changed(mut self, random: &mut Random) -> Self {
        self = self.changed_once(random);
        while random.once_in(3) {
            self = self.changed_once(random);
        }
        self
    }

    fn changed_once(mut self, random: &mut Random) -> Self {
        let axis = random.below(3) as usize;
        // Of the order of a rounding, so that others stay as they are, or of any.
        let most = random.pick(&[-48, -48, -24, 0]);
        let step = random.signed() * random.power(-56, most);
        match random.below(6) {
            0 => self.point[axis] += step,
            1 => self.normal[axis] += step,
            2 => self.anchor[axis] += step,
            3 => self.offset[axis] += step,
            4 => self.tilt[axis] = random.signed() * 2.0 * UNIT,
            _ => self.dir[axis] += step,
        }
        if most > -48 {
            self.normal = unit(self.normal).unwrap_or(DVec3::X);
            self.dir = unit(self.dir).unwrap_or(DVec3::X);
        }
        self
    }

    /// Whether both directions are as long as unit vectors come out.
    pub(crate) fn is_unit(&self) -> bool {
        let is_unit = |vector: DVec3| (vector.length_squared() - 1.0).abs() <= 6.0 * UNIT;
        is_unit(self.normal) && is_unit(self.dir)
    }

    pub(crate) fn flat(&self) -> Flat {
        let neighbor = Flat::with_unit_normal(self.point, self.normal + self.tilt);
        Flat::with_unit_normal(self.point, self.normal).welded(&neighbor)
    }

    pub(crate) fn ray(&self) -> Ray<'static> {
        let Self { anchor, offset, .. } = *self;
        Ray::new(Point { anchor, offset }, self.dir)
    }
}
