//! Many rays from one point to neighbouring places.

use glam::DVec3;

use super::{Flat, Ray};

/// Rays from a point in free space whose directions lie on a straight line between two, before they
/// are made unit.
#[derive(Debug, Clone, Copy)]
pub struct Fan {
    /// One of them, in any direction.
    pub ray: Ray<'static>,
    /// The outermost directions, not made unit.
    pub ends: [DVec3; 2],
    /// The sum of all lengths that the directions are made of; none of them is longer.
    pub size: f64,
}

/// Where the rays of a fan cross a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Crossings {
    /// Nowhere.
    Never,
    /// All do, ahead and beyond the screen, if there is one.
    Always(Distances),
    /// Each has to be asked.
    Unknown,
}

/// The distances at which the rays of a fan cross a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distances {
    normal: DVec3,
    /// How far the origin lies behind the plane.
    height: f64,
}

/// How many times a value has to be larger than what puts it in doubt, for a whole fan to be decided by
/// it at once; half as many are enough. Smaller, and roundings would matter; larger, and fewer fans are
/// decided.
const CLEARLY: f64 = 1_048_576.0;

/// How much further than a limit all rays of a fan have to cross a plane to be decided at once: by far
/// more than the distances can be off by, which `CLEARLY` sees to.
const BEYOND: f64 = 1.0 + 1.0 / 1024.0;

impl Flat {
    /// Where the rays of a fan cross the plane; what is not below a `screen` across the z axis does not
    /// count.
    ///
    /// For a direction `w` that is not made unit, `n·w` is linear, so along the fan it lies between its
    /// values at the ends. If both have one sign and are no smaller than a share of all that went into
    /// them, then every ray rises, or every ray falls, at no small angle, and rounded values are enough.
    ///
    /// The way to the plane, as a multiple of that to the screen, is a quotient of two such linear
    /// values, neither of which changes its sign; so it is monotone along the fan, and lies between its
    /// values at the ends, too.
    #[must_use]
    pub fn crossings(&self, fan: &Fan, screen: Option<&Self>) -> Crossings {
        let height = -self.normal.dot(fan.ray.origin.from(self.point));
        let is_clear = height.abs() > CLEARLY * (self.doubt + fan.ray.doubt);
        let slopes = fan.ends.map(|way| self.normal.dot(way));
        let steep = |slope: f64| CLEARLY * slope.abs() > fan.size;
        let is_decided = is_clear && slopes.iter().all(|slope| steep(*slope));
        if !is_decided || (slopes[0] > 0.0) != (slopes[1] > 0.0) {
            return Crossings::Unknown;
        }
        if (slopes[0] > 0.0) != (height > 0.0) {
            return Crossings::Never;
        }
        // No distance is too large for a number.
        let mut counts = (2.0 * CLEARLY * height).is_finite();
        if let Some(screen) = screen {
            let above = fan.ray.origin.from(screen.point).z;
            counts &= above > 0.0;
            for (way, slope) in fan.ends.iter().zip(slopes) {
                let falls = -way.z;
                counts &= falls > 0.0
                    && steep(falls)
                    && height.abs() * falls > BEYOND * (above * slope.abs());
            }
        }
        if !counts {
            return Crossings::Unknown;
        }
        Crossings::Always(Distances {
            normal: self.normal,
            height,
        })
    }
}

impl Distances {
    /// The distance at which a ray of the fan in this direction crosses the plane: bit for bit that of
    /// [`Flat::crossing`].
    #[must_use]
    #[inline(always)]
    pub fn along(&self, dir: DVec3) -> f64 {
        super::crossing::distance(self.height, self.normal.dot(dir))
    }
}
