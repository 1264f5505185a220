//! The line along a border of a flat surface.

use glam::DVec3;

use super::exact::{Exact, ExactVector, Sign};
use super::{Crossing, Decisions, Flat, Grazing, Ray};

/// A line in a plane with an inner side, as one border of a surface. Neighbours that share the line
/// decide by the same one, so no ray passes between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// A point from which the line is reached by going `across` to the outer side.
    pub point: DVec3,
    /// Along the line, of unit length if `across` is not zero; seen from the front the inner side is on the right.
    pub dir: DVec3,
    /// What rounding took from `dir`.
    pub dir_rest: DVec3,
    /// How far the line lies from `point`.
    pub across: f64,
    /// Whether the line itself belongs to the surface. It does, unless there is a neighbour beyond
    /// it that owns it.
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
        // What the rounded difference lacks is itself a double (Knuth 1969, vol. 2, §4.2.2).
        let virtual_from = to - dir;
        let dir_rest = (virtual_from - from) + (to - (dir + virtual_from));
        Self {
            dir_rest,
            ..Self::new(from, dir, 0.0)
        }
    }

    /// The same line for another surface in the plane, whose normal points to the same side or not,
    /// and which lies on the same side of the line or not.
    #[must_use]
    pub fn for_neighbor(&self, same_front: bool, same_side: bool) -> Self {
        let sign = |keep: bool| if keep { 1.0 } else { -1.0 };
        let turn = sign(same_front == same_side);
        Self {
            dir: self.dir * turn,
            dir_rest: self.dir_rest * turn,
            across: self.across * sign(same_side),
            ..*self
        }
    }

    /// On which side of the line a ray passes: positive on the inner side, if it goes up along
    /// the plane's normal, and the other way round if it goes down.
    ///
    /// With the vector `c` from the line's point to the ray's origin this is
    /// `a·(d × c) + across n·d`: the distance of the ray's crossing from the line, times `n·d`.
    #[must_use]
    pub fn side(&self, ray: &Ray, normal: DVec3) -> Sign {
        let along = &ExactVector::from(self.dir) + &ExactVector::from(self.dir_rest);
        let dir = ExactVector::from(ray.dir);
        let moment = dir.cross(&ray.origin.exactly_from(self.point));
        let side = along.dot(&moment);
        if self.across == 0.0 {
            return side.sign();
        }
        let shift = &dir.dot(&normal.into()) * &Exact::from(self.across);
        (&side + &shift).sign()
    }

    /// On which side of the line a ray crosses the plane, if the line is brought into the plane;
    /// positive on the inner side.
    ///
    /// Of a ray that is nearly parallel to the plane, [`side`](Self::side) says little about where it
    /// crosses, since the line lies off the plane by a rounding.
    #[must_use]
    fn side_in_plane(&self, ray: &Ray, flat: &Flat) -> Sign {
        let along = &ExactVector::from(self.dir) + &ExactVector::from(self.dir_rest);
        let right = along.cross(&flat.decisive_normal().into());
        let (place, slope) = flat.exact_place(ray, self.point);
        let shift = &slope * &Exact::from(self.across);
        (&right.dot(&place) + &shift).sign() * slope.sign()
    }

    /// How far at most a corner of a surface, which ought to lie on the line, lies from it in the plane,
    /// and the line there from the plane.
    #[must_use]
    pub fn apart(&self, corner: &ExactVector, flat: &Flat) -> f64 {
        let (point, dir) = (ExactVector::from(self.point), ExactVector::from(self.dir));
        let along = (corner - &point).dot(&dir).to_f64() / self.dir.length_squared();
        let rise = flat.exact_slope(self.dir).to_f64() * along;
        let height = flat.exact_height(&point).to_f64() + rise;
        self.inward(corner, flat.normal).abs() + height.abs()
    }

    /// How far a point in the plane lies on the inner side of the line.
    #[must_use]
    pub fn inward(&self, point: &ExactVector, normal: DVec3) -> f64 {
        let way = point - &self.point.into();
        let along = &ExactVector::from(self.dir) + &ExactVector::from(self.dir_rest);
        let right = along.cross(&normal.into());
        right.dot(&way).to_f64() / self.dir.length() + self.across
    }
}

/// Whether a ray crosses a plane on the inner side of all borders of a surface, without rounding;
/// `corners` are the surface's.
///
/// A ray that is nearly parallel to the plane is asked where it crosses the plane itself, and so never
/// meets what lies elsewhere.
///
/// A ray that starts within rounding of the plane crosses it where it starts. If it starts within
/// rounding of the surface, it meets it, unless the surface hangs on the other side of the plane
/// that the ray leaves. So there is no way out between two walls of a room for a ray that rounding
/// has put into the edge, and none is lost that leaves the outer edge of a box.
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
            // What lies at the crossing lies behind the start, and that is no rounding.
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

/// Whether a surface with these corners, next to which a ray starts, is on the side of the plane
/// left behind to which the ray goes; `None` if it is within rounding of that plane.
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
