//! The least distance of any occluder from a light.

use glam::DVec3;

use super::primitive::Primitive;
use crate::math::error_bounds::CROSSING_HEIGHT;
use crate::math::{Point, Segment};

/// The least distance of a point light from the carrier of any bounded occluder.
///
/// Occluders are hit before the light, up to a rounding error that grows as the light approaches an
/// occluder's plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct OccluderDistance {
    distance: f64,
    /// The largest sum of lengths in a distance, the scale of its rounding error.
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

    /// The distance along a segment up to which occluders must be searched.
    pub(super) fn until(self, segment: &Segment) -> f64 {
        // A ray of length l from a point to a light on the other side of a plane rises by at least
        // the light's distance c. Errors of its origin, its direction and the plane change the
        // height of the crossing by less than the bound e. So it crosses at most l e / c later.
        // While e is far below c, rounding cannot have moved the origin beyond the light. A ball in
        // front of the light at this distance is passed before the light.
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
            let (offset, _) = light.seen_from(plane.point);
            return Self {
                distance: plane.normal.dot(offset).abs() - plane.slack(),
                size: light.size() + Point::exact(plane.point).size(),
            };
        }
        let Some([center, axes]) = primitive.surface.shape().round() else {
            return Self {
                distance: 0.0,
                size: 0.0,
            };
        };
        let (offset, _) = light.seen_from(center);
        let [long, short] = [axes.max_element(), axes.min_element()];
        // In the space where an ellipsoid is a ball, errors are larger by this factor.
        let scale = (short / long) * (short / long);
        Self {
            distance: (offset.length() - long) * scale,
            size: light.size() + Point::exact(center).size() + long,
        }
    }
}
