//! The least distance of any occluder from a light.

use glam::DVec3;

use super::primitive::Primitive;
use crate::math::error_bounds::CROSSING_HEIGHT;
use crate::math::{Point, Segment};

/// The least distance of a point light from the plane, or the round surface, of any bounded occluder.
///
/// Occluders are hit before the light, except for rounding, which matters more the nearer the light is to
/// an occluder's plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct OccluderDistance {
    distance: f64,
    /// The largest sum of lengths that the distance is made of.
    size: f64,
}

impl OccluderDistance {
    /// The least distance of a light from these surfaces.
    pub(super) fn new<'e, 'a: 'e>(
        light: DVec3,
        surfaces: impl Iterator<Item = &'e Primitive<'a>>,
    ) -> Self {
        let none = Self {
            distance: f64::MAX,
            size: Point::exact(light).size(),
        };
        surfaces.fold(none, |least, primitive| {
            let other = Self::from(light, primitive);
            Self {
                distance: least.distance.min(other.distance),
                size: least.size.max(other.size),
            }
        })
    }

    /// The distance along a segment to the light up to which occluders have to be searched for.
    pub(super) fn until(self, segment: &Segment) -> f64 {
        // Between a point and a light on opposite sides of a plane a ray rises by at least the distance
        // c on its length l. Its start, its direction and the plane put the height by which it crosses
        // off by less than the bound e, so it crosses by l e / c later at most; and while e is far below
        // c, rounding cannot have put the start beyond the light. A ball at this distance from the
        // light, and before it, is passed before the light.
        let sizes = self.size + segment.ray.size();
        let bound = CROSSING_HEIGHT * sizes + 4.0 * segment.ray.astray;
        if 4.0 * bound < self.distance {
            segment.length * (1.0 + bound / self.distance)
        } else {
            f64::MAX
        }
    }

    /// The distance of a light from one surface.
    fn from(light: DVec3, primitive: &Primitive<'_>) -> Self {
        let light = Point::exact(light);
        if let Some(plane) = primitive.plane {
            let (way, _) = light.seen_from(plane.point);
            return Self {
                distance: plane.normal.dot(way).abs() - plane.slack(),
                size: light.size() + Point::exact(plane.point).size(),
            };
        }
        let Some([center, axes]) = primitive.surface.shape().round() else {
            return Self {
                distance: 0.0,
                size: 0.0,
            };
        };
        let (way, _) = light.seen_from(center);
        let [long, short] = [axes.max_element(), axes.min_element()];
        // Values in the space where an ellipsoid is a ball are off by that much more.
        let stretch = (short / long) * (short / long);
        Self {
            distance: (way.length() - long) * stretch,
            size: light.size() + Point::exact(center).size() + long,
        }
    }
}
