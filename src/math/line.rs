//! Border lines of flat surfaces.

use glam::DVec3;

use super::exact::{Exact, ExactVector, Sign};
use super::{Crossing, Decisions, Flat, Grazing, Ray};

/// A line in a plane with an inner side: a border of a surface.
///
/// Neighbours share the line and decide by the same numbers, so no ray passes between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// A point from which going `across` to the outer side leads to the line.
    pub point: DVec3,
    /// The direction; from the front, the inner side is on its right.
    ///
    /// It is of unit length if `across` is not zero.
    pub dir: DVec3,
    /// The exact direction less the rounded one.
    pub dir_rest: DVec3,
    /// The distance of the line from `point`.
    pub across: f64,
    /// True if the line belongs to the surface, and not to a neighbour beyond it.
    pub owned: bool,
}

impl Line {
    /// A line that belongs to its surface.
    #[must_use]
    pub fn new(point: DVec3, dir: DVec3, across: f64) -> Self {
        Self {
            point,
            dir,
            dir_rest: DVec3::ZERO,
            across,
            owned: true,
        }
    }

    /// The line from one point to another.
    #[must_use]
    pub fn between(from: DVec3, to: DVec3) -> Self {
        let dir = to - from;
        // The rounding error of a difference is itself a double (Knuth 1969, vol. 2, §4.2.2).
        let virtual_from = to - dir;
        let dir_rest = (virtual_from - from) + (to - (dir + virtual_from));
        Self {
            dir_rest,
            ..Self::new(from, dir, 0.0)
        }
    }

    /// The same line for another surface in the plane.
    ///
    /// `same_front` is true if both normals agree, `same_side` if both surfaces are on one side of
    /// the line.
    #[must_use]
    pub fn for_neighbor(&self, same_front: bool, same_side: bool) -> Self {
        let sign = |keep: bool| if keep { 1.0 } else { -1.0 };
        let flip = sign(same_front == same_side);
        Self {
            dir: self.dir * flip,
            dir_rest: self.dir_rest * flip,
            across: self.across * sign(same_side),
            ..*self
        }
    }

    /// The side of the line on which a rising ray passes: positive on the inner side.
    ///
    /// For a ray that falls along the plane's normal the sign is the opposite one.
    #[must_use]
    pub fn side(&self, ray: &Ray, normal: DVec3) -> Sign {
        let along = &ExactVector::from(self.dir) + &ExactVector::from(self.dir_rest);
        // With the vector c from the line's point to the ray's origin this is a·(d × c) + across
        // n·d: the distance of the crossing from the line, times n·d.
        let dir = ExactVector::from(ray.dir);
        let moment = dir.cross(&ray.origin.exactly_from(self.point));
        let side = along.dot(&moment);
        if self.across == 0.0 {
            return side.sign();
        }
        let shift = &dir.dot(&normal.into()) * &Exact::from(self.across);
        (&side + &shift).sign()
    }

    /// The side of the line, projected into the plane, on which a ray crosses.
    ///
    /// It is positive on the inner side. The line is off the plane by a rounding. For a ray nearly
    /// parallel to the plane, [`side`](Self::side) therefore decides little about its crossing.
    #[must_use]
    fn side_in_plane(&self, ray: &Ray, flat: &Flat) -> Sign {
        let along = &ExactVector::from(self.dir) + &ExactVector::from(self.dir_rest);
        let right = along.cross(&flat.decisive_normal().into());
        let (place, slope) = flat.exact_place(ray, self.point);
        let shift = &slope * &Exact::from(self.across);
        (&right.dot(&place) + &shift).sign() * slope.sign()
    }

    /// A bound of the distance between the line and a corner that should lie on it.
    ///
    /// It adds the distance in the plane and the height of the line above the plane.
    #[must_use]
    pub fn apart(&self, corner: &ExactVector, flat: &Flat) -> f64 {
        let (point, dir) = (ExactVector::from(self.point), ExactVector::from(self.dir));
        let along = (corner - &point).dot(&dir).to_f64() / self.dir.length_squared();
        let rise = flat.exact_slope(self.dir).to_f64() * along;
        let height = flat.exact_height(&point).to_f64() + rise;
        self.inward(corner, flat.normal).abs() + height.abs()
    }

    /// The distance of a point in the plane from the line, positive on the inner side.
    #[must_use]
    pub fn inward(&self, point: &ExactVector, normal: DVec3) -> f64 {
        let way = point - &self.point.into();
        let along = &ExactVector::from(self.dir) + &ExactVector::from(self.dir_rest);
        let right = along.cross(&normal.into());
        right.dot(&way).to_f64() / self.dir.length() + self.across
    }
}

/// Returns whether a ray crosses a plane inside all borders, without rounding.
///
/// `corners` are the surface's. Borders of a ray nearly parallel to the plane are decided in the
/// plane.
// A ray that starts within rounding of the plane crosses it at its origin. If the origin is within
// rounding of the surface, the ray hits it, unless the surface lies on the other side of the plane
// that the ray leaves. A ray that rounding has put into the edge between two walls cannot escape,
// and no ray that leaves the outer edge of a box is lost.
#[cold]
#[must_use]
pub fn inside_all(
    borders: &[Line],
    corners: impl FnOnce() -> Vec<ExactVector>,
    ray: &Ray,
    flat: &Flat,
    crossing: &Crossing,
) -> bool {
    let normal = flat.decisive_normal();
    if let Some(rounding) = crossing.at_start {
        let start = ray.origin.exactly_from(DVec3::ZERO);
        let inside = |border: &Line| border.inward(&start, normal) >= -rounding;
        if borders.iter().all(inside) {
            let met = rises_ahead(&corners(), ray, rounding);
            if let Some(met) = met {
                Decisions::note(true);
                return met;
            }
        } else if crossing.grazing == Some(Grazing::Behind) {
            // The crossing is behind the origin by more than rounding.
            return false;
        }
    }
    let outer = if crossing.rises {
        Sign::Negative
    } else {
        Sign::Positive
    };
    let mut tie = false;
    let inside = borders.iter().all(|border| {
        let side = match crossing.grazing {
            None => border.side(ray, normal),
            Some(_) if crossing.rises => border.side_in_plane(ray, flat),
            Some(_) => -border.side_in_plane(ray, flat),
        };
        tie |= side == Sign::Zero;
        side != outer && (border.owned || side != Sign::Zero)
    });
    Decisions::note(tie);
    inside
}

/// Returns whether a surface near the origin is on the side that the ray goes to.
///
/// The side is that of the plane left behind. `None` if the corners are within rounding of it.
fn rises_ahead(corners: &[ExactVector], ray: &Ray, rounding: f64) -> Option<bool> {
    let Some(left) = ray.spawned_from.and_then(|ray_origin| ray_origin.flat) else {
        return Some(true);
    };
    let goes = left.exact_slope(ray.dir).sign();
    let heights = corners.iter().map(|corner| left.exact_height(corner));
    let on_either = heights.fold((false, false), |(ahead, behind), height| {
        let beyond = height.to_f64().abs() > rounding;
        let same = height.sign() == goes;
        (ahead || beyond && same, behind || beyond && !same)
    });
    match on_either {
        (true, _) => Some(true),
        (false, true) => Some(false),
        (false, false) => None,
    }
}
