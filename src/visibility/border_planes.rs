//! The planes through a border of an occluder and the corners of a lamp.

use glam::DVec3;

use super::silhouette::Silhouette;
use crate::math::error_bounds::OCCLUSION;
use crate::math::{Ray, Side};

/// The planes through one border of an occluder and each corner of a lamp.
///
/// Empty if the corners have the occluder on different sides of the border: no side is certain
/// then.
#[derive(Debug)]
pub(super) struct BorderPlanes {
    point: DVec3,
    planes: Vec<BorderPlane>,
}

/// A plane through a point of a border; its normal points toward the occluder.
#[derive(Debug)]
struct BorderPlane {
    normal: DVec3,
    /// The error bound of a height above it, as a polynomial in the size of the point.
    bound: [f64; 3],
}

impl BorderPlanes {
    /// The planes of all borders of an occluder.
    pub(super) fn all(occluder: &Silhouette, lamp: &Silhouette) -> Vec<Self> {
        let outline = &occluder.outline;
        let next = outline.iter().cycle().skip(1);
        let inner = outline.iter().cycle().skip(2);
        let borders = outline.iter().zip(next).zip(inner);
        let planes = |((from, to), inner): ((&DVec3, &DVec3), &DVec3)| {
            let plane =
                |corner| BorderPlane::new(corner, [*from, *to], *inner, occluder.border_error);
            let planes: Option<Vec<_>> = lamp.corners().map(plane).collect();
            let planes = planes.unwrap_or_default();
            let flipped = |(_, flipped): &(BorderPlane, bool)| *flipped;
            let uniform = planes.iter().all(flipped) || !planes.iter().any(flipped);
            let planes = planes.into_iter().filter(|_| uniform);
            Self {
                point: *from,
                planes: planes.map(|(plane, _)| plane).collect(),
            }
        };
        borders.map(planes).collect()
    }

    /// The side of all planes that a ray's origin is certainly on.
    ///
    /// The front is the side of the occluder. `None` if the sides differ or are uncertain.
    pub(super) fn side(&self, ray: &Ray) -> Option<Side> {
        let (offset, _) = ray.origin.seen_from(self.point);
        let size = ray.origin.size();
        let side = |plane: &BorderPlane| plane.side(offset, size, ray.astray);
        let mut sides = self.planes.iter().map(side);
        let first = sides.next()??;
        sides.all(|side| side == Some(first)).then_some(first)
    }
}

impl BorderPlane {
    /// The plane through a corner and a border, and whether its normal was flipped.
    ///
    /// Normals point toward the occluder. `None` if rounding leaves their sign uncertain. The
    /// border that decides hits may lie `border_error` away.
    fn new(
        corner: DVec3,
        [from, to]: [DVec3; 2],
        inner: DVec3,
        border_error: f64,
    ) -> Option<(Self, bool)> {
        let normal = (from - corner).cross(to - corner);
        let size = |point: DVec3| (point.abs() + corner.abs()).element_sum();
        let sizes = size(from) + size(to);
        let share = OCCLUSION * size(from) * size(to) + border_error * (sizes + border_error);
        let square = OCCLUSION * sizes;
        let fixed = share * (size(from) + corner.abs().element_sum())
            + normal.abs().element_sum() * border_error;
        let height = normal.dot(inner - from);
        let flipped = height < 0.0;
        (height.abs() > fixed + share * size(inner)).then(|| {
            let plane = Self {
                normal: if flipped { -normal } else { normal },
                bound: [fixed, share, square],
            };
            (plane, flipped)
        })
    }

    /// The side of a point, given relative to the border's point; `None` if uncertain.
    fn side(&self, offset: DVec3, size: f64, error: f64) -> Option<Side> {
        let height = self.normal.dot(offset);
        let [fixed, share, square] = self.bound;
        let bound =
            fixed + (share + square * size) * size + self.normal.abs().element_sum() * error;
        (height.abs() > bound).then_some(if height > 0.0 {
            Side::Front
        } else {
            Side::Back
        })
    }
}
