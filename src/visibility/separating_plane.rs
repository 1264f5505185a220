//! Separating planes between lamps and adjacent round occluders.

use glam::DVec3;

use super::silhouette::Silhouette;
use crate::math::error_bounds::OCCLUSION;
use crate::math::exact::{Exact, ExactVector, Sign};
use crate::math::{Flat, Point, Side, direction};

/// A plane with a round occluder behind it and a lamp in front.
///
/// Both may touch it.
///
/// The occluder hides no part of the lamp from a point that is certainly in front of the plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct SeparatingPlane {
    point: DVec3,
    normal: DVec3,
    /// A bound of the error of the point and of the lamp's own plane.
    error: f64,
    /// `short³/long²`.
    thickness: f64,
    /// The sum of all lengths in it, the scale of its rounding error.
    size: f64,
}

impl SeparatingPlane {
    /// A plane between a round occluder and a lamp; `None` if none is known.
    pub(super) fn between(occluder: &Silhouette, lamp: &Silhouette) -> Option<Self> {
        let round = occluder.round?;
        match (&lamp.plane, lamp.round) {
            (Some(plane), _) => {
                let radius = lamp.ball()?.radius();
                let is_behind = !occluder.reaches(plane, Side::Front);
                is_behind.then(|| Self::of_rectangle(plane, radius, round))
            }
            (None, Some(lamp)) => Self::of_balls(lamp, round),
            (None, None) => None,
        }
    }

    /// The plane of a rectangular lamp, for a round occluder not in front of it.
    fn of_rectangle(plane: &Flat, radius: f64, [center, axes]: [DVec3; 2]) -> Self {
        let lamp = Point::exact(plane.point).size() + radius;
        Self {
            point: plane.point,
            normal: plane.normal,
            error: plane.slack(),
            thickness: thickness(axes),
            size: lamp + Point::exact(center).size() + axes.element_sum(),
        }
    }

    /// A plane between a ball lamp and the ball around an occluder.
    ///
    /// `None` if they overlap.
    fn of_balls([lamp, lamp_axes]: [DVec3; 2], [center, axes]: [DVec3; 2]) -> Option<Self> {
        let (lamp_radius, radius) = (lamp_axes.max_element(), axes.max_element());
        let offset = &ExactVector::from(lamp) - &ExactVector::from(center);
        let radii = &Exact::from(lamp_radius) + &Exact::from(radius);
        let gap = &offset.dot(&offset) - &radii.squared();
        (gap.sign() != Sign::Negative).then(|| {
            let normal = direction(offset.rounded());
            let size = Point::exact(lamp).size() + lamp_radius;
            Self {
                point: center + normal * radius,
                normal,
                error: 0.0,
                thickness: thickness(axes),
                size: size + Point::exact(center).size() + axes.element_sum(),
            }
        })
    }

    /// Returns whether the occluder certainly hides nothing from a point in front.
    ///
    /// `error` bounds the error of the point.
    pub(super) fn has_in_front(&self, point: &Point, error: f64) -> bool {
        // Let the point be h above the plane, and the segment to a point of the lamp no longer than
        // D. The segment does not go below the plane. Let the tested ray be within ε of it, by
        // rounding. If the ray enters a ball of radius r below the plane, its foot F from the
        // centre C is in the ball, and at most ε below the plane. So F − C rises by at least r − ε,
        // and its part along the plane is at most √(2 r ε). The ray's direction falls by h/D, up to
        // rounding, and is at right angles to F − C. Hence (r − ε) h/D ≤ √(2 r ε).
        // If h² r > 8 ε D², that is false: then the foot lies beyond the ray's end, and a ball that
        // is entered only beyond the end hides nothing.
        //
        // An ellipsoid is a ball of radius 1 in a scaled space. There lengths are divided by at
        // least the shortest half axis, and heights by at most the longest. So the condition is
        // h² short³/long² > 8 ε D².
        let (offset, length) = point.seen_from(self.point);
        let size = length + self.size;
        let bound = OCCLUSION * size + 8.0 * (error + self.error);
        let height = self.normal.dot(offset) - bound;
        height > 0.0 && height * height * self.thickness > bound * size * size
    }
}

fn thickness(axes: DVec3) -> f64 {
    let (short, long) = (axes.min_element(), axes.max_element());
    short * (short / long) * (short / long)
}
