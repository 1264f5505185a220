//! How far from a light whatever could hide it is at least.

use glam::DVec3;

use super::Entry;
use crate::math::{Point, Segment, UNIT};

/// How clear of a light a scene's surfaces are that have an end: what hides it from a place is met
/// before the light, but for rounding, which counts the more the nearer the light is to a surface's plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Clearance {
    /// How far the light is at least from each plane and from each round thing.
    distance: f64,
    /// The sum of all lengths that this is made of, at most.
    size: f64,
}

impl Clearance {
    /// The clearance of a light from these surfaces.
    pub(super) fn new<'e, 'a: 'e>(
        light: DVec3,
        surfaces: impl Iterator<Item = &'e Entry<'a>>,
    ) -> Self {
        let all = Self {
            distance: f64::MAX,
            size: Point::exact(light).size(),
        };
        surfaces.fold(all, |all, entry| {
            let [distance, size] = from_surface(light, entry);
            Self {
                distance: all.distance.min(distance),
                size: all.size.max(size),
            }
        })
    }

    /// How far along a segment to the light it has to be searched for what hides it.
    ///
    /// Between a place and a light on opposite sides of a plane a ray rises by at least this distance `c` on
    /// its length `l`. Its start, its direction and the plane put the height by which it crosses off by
    /// less than the doubt `e`, so that it crosses by `l e / c` later at most; and while `e` is far below
    /// `c`, rounding cannot have put the start beyond the light. A ball that is this far from the
    /// light, and before it, is passed before the light.
    pub(super) fn until(self, segment: &Segment) -> f64 {
        let doubt = 64.0 * UNIT * (self.size + segment.ray.size()) + 4.0 * segment.ray.astray;
        if 4.0 * doubt < self.distance {
            segment.length * (1.0 + doubt / self.distance)
        } else {
            f64::MAX
        }
    }
}

/// How far a light is from a surface's plane, or from it, if it is round; and the size of what that is
/// computed from.
fn from_surface(light: DVec3, entry: &Entry<'_>) -> [f64; 2] {
    let light = Point::exact(light);
    if let Some(flat) = entry.flat {
        let (way, _) = light.seen_from(flat.point);
        let size = light.size() + Point::exact(flat.point).size();
        return [flat.normal.dot(way).abs() - flat.slack(), size];
    }
    let Some([center, axes]) = entry.surface.round() else {
        return [0.0, 0.0];
    };
    let (way, _) = light.seen_from(center);
    let [long, short] = [axes.max_element(), axes.min_element()];
    // What is asked in a space where it is a ball is off by that much more.
    let stretch = (short / long) * (short / long);
    let size = light.size() + Point::exact(center).size() + long;
    [(way.length() - long) * stretch, size]
}
