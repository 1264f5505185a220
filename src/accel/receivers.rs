//! Which surface can put which other one into shadow.

use glam::{DVec2, DVec3};

use super::Entry;
use super::divide::Divide;
use super::reach::overhang;
use crate::math::error_bounds::UNIT;
use crate::math::exact::ExactVector;
use crate::math::{Ball, Bounds, CarrierId, Flat, Point, Side};
use crate::surface::{Shape, Surface};

/// A surface as the side of others that light comes from, and that shadows fall on.
#[derive(Debug)]
pub(super) struct Body {
    support: Option<CarrierId>,
    flat: Option<Flat>,
    outline: Vec<DVec3>,
    /// How far it can be met beside its outline, though hits on it lie inside.
    pub(super) overhang: f64,
    /// Points around it, exact and rounded; `None` if it has no end.
    hull: Option<Vec<(ExactVector, DVec3)>>,
    /// The centre and the half axes, if it is round.
    round: Option<[DVec3; 2]>,
    rectangle: Option<Sheet>,
}

/// A rectangle on whose front shadows fall; its hits have their offset from its corner for
/// coordinates.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sheet {
    pub(super) corner: DVec3,
    /// Its unit axes: x, y and the normal.
    pub(super) axes: [DVec3; 3],
    pub(super) size: DVec2,
}

impl Body {
    pub(super) fn of(entry: &Entry<'_>) -> Self {
        Self::of_surface(entry.surface, entry.support)
    }

    pub(super) fn of_surface(surface: &dyn Surface, support: Option<CarrierId>) -> Self {
        let with_rounded = |point: ExactVector| {
            let rounded = point.rounded();
            (point, rounded)
        };
        Self {
            support,
            flat: surface.flat().copied(),
            outline: surface.outline(),
            overhang: overhang(surface),
            hull: surface
                .hull()
                .map(|hull| hull.into_iter().map(with_rounded).collect()),
            round: surface.round(),
            rectangle: match surface.anatomy().map(|anatomy| anatomy.shape) {
                Some(Shape::Rectangle { corner, axes, size }) => Some(Sheet { corner, axes, size }),
                _ => None,
            },
        }
    }

    /// The rectangle that it is, if it is one.
    pub(super) fn rectangle(&self) -> Option<&Sheet> {
        self.rectangle.as_ref()
    }

    /// Points around it, rounded, if it has an end.
    pub(super) fn hull(&self) -> Option<impl Iterator<Item = DVec3>> {
        let hull = self.hull.as_ref()?;
        Some(hull.iter().map(|(_, rounded)| *rounded))
    }

    /// How many times further than rounding a ray to a light may pass it by, if it is no longer than
    /// `reach`, and still be said to meet it. `None` if that is not known.
    ///
    /// The borders of a flat surface are told by lines that are off its plane by rounding, so a ray
    /// at a small angle to the plane can be off a border by more; and from across the plane
    /// to the light it rises by more than the light's height. A stretched ball is asked in a space
    /// where its axes are equal.
    pub(super) fn slant(&self, light: DVec3, reach: f64) -> Option<f64> {
        match (&self.flat, self.round) {
            (Some(flat), _) => Some((reach / flat.normal.dot(light - flat.point).abs()).max(1.0)),
            (None, Some([_, axes])) => Some(axes.max_element() / axes.min_element()),
            (None, None) => None,
        }
    }

    /// Whether it can hide a light at this place from some part of another surface; `side` is the
    /// one of its own that the light is on.
    ///
    /// A plane can only stand between the light and what is strictly on its other side, and one
    /// with an end only before what its shadow pyramid meets. What is behind the floor and the
    /// walls of a room is nothing, so they hide nothing.
    pub(super) fn can_hide(&self, light: DVec3, side: Side, from: &Self) -> bool {
        if self.support.is_some() && self.support == from.support {
            return false;
        }
        let Some(flat) = &self.flat else {
            return !self.cone_passes_by(light, from);
        };
        // A plane hides nothing from a light in it.
        side.opposite()
            .is_some_and(|behind| from.reaches(flat, behind))
            && !self.shadow_passes_by(&[light], from)
    }

    /// Whether it can hide some part of a lamp from some part of another surface.
    pub(super) fn can_hide_lamp(&self, lamp: &Self, from: &Self) -> bool {
        if self.support.is_some() && [from.support, lamp.support].contains(&self.support) {
            return false;
        }
        let Some(flat) = &self.flat else {
            // What a round thing hides is found out where it is asked.
            return true;
        };
        let apart = |(lit, dark)| lamp.reaches(flat, lit) && from.reaches(flat, dark);
        let sides = [(Side::Front, Side::Back), (Side::Back, Side::Front)];
        sides.into_iter().any(apart) && !self.shadow_passes_by(&lamp.corners(), from)
    }

    /// The side of its plane on which all of a lamp is, but for what lies in the plane; `None` if
    /// the lamp is on both, or if this is no plane.
    pub(super) fn side_of(&self, lamp: &Self) -> Option<Side> {
        let flat = self.flat.as_ref()?;
        match [Side::Front, Side::Back].map(|side| lamp.reaches(flat, side)) {
            [true, true] => None,
            [true, false] => Some(Side::Front),
            [false, true] => Some(Side::Back),
            [false, false] => Some(Side::On),
        }
    }

    /// A plane between this, if it is round, and a lamp that it leaves out and may touch; `None` if none
    /// is known.
    pub(super) fn divide_from(&self, lamp: &Self) -> Option<Divide> {
        let round = self.round?;
        match (&lamp.flat, lamp.round) {
            (Some(flat), _) => {
                let reach = lamp.ball()?.reach();
                (!self.reaches(flat, Side::Front)).then(|| Divide::of_pane(flat, reach, round))
            }
            (None, Some([center, axes])) => Divide::of_globe((center, axes.max_element()), round),
            (None, None) => None,
        }
    }

    /// Whether some of it lies strictly before another surface's plane, or the other is not flat.
    pub(super) fn is_before(&self, other: &Self) -> bool {
        let flat = other.flat.as_ref();
        flat.is_none_or(|flat| self.reaches(flat, Side::Front))
    }

    /// The points around it, rounded; empty if it has no end.
    pub(super) fn corners(&self) -> Vec<DVec3> {
        let hull = self.hull.iter().flatten();
        hull.map(|(_, rounded)| *rounded).collect()
    }

    /// Whether some of it can lie strictly on this side of a plane.
    fn reaches(&self, flat: &Flat, side: Side) -> bool {
        if let Some(round) = self.round {
            return flat.has_some_of(round, side);
        }
        match (&self.hull, &self.flat) {
            (Some(hull), _) => hull
                .iter()
                .any(|(exact, rounded)| flat.side_of(exact, *rounded) == side),
            (None, Some(own)) => !own.is_parallel(flat) || own.lies_on(flat, side),
            (None, None) => true,
        }
    }

    /// Whether another surface certainly lies outside of the cone from a light around this one.
    fn cone_passes_by(&self, light: DVec3, other: &Self) -> bool {
        let (Some(own), Some(other)) = (self.ball(), other.ball()) else {
            return false;
        };
        own.cone_from(light).is_some_and(|(axis, half_angle)| {
            other.is_outside(light, axis, half_angle) && own.is_told_from(light, &other)
        })
    }

    /// A ball around it, if it has an end.
    fn ball(&self) -> Option<Ball> {
        let hull = self.hull.as_ref()?;
        let bounds = Bounds::around(hull.iter().map(|(_, rounded)| *rounded));
        Some(Ball::around(&bounds))
    }

    /// Whether another surface is certainly on the outer side of the planes through one border of
    /// this one and each of some lights, which have it on one side.
    ///
    /// For points in between the same holds, since what decides is linear in both ends.
    fn shadow_passes_by(&self, lights: &[DVec3], other: &Self) -> bool {
        let (Some(hull), Some(first_light)) = (&other.hull, lights.first()) else {
            return false;
        };
        let next = self.outline.iter().cycle().skip(1);
        let inner = self.outline.iter().cycle().skip(2);
        let mut borders = self.outline.iter().zip(next).zip(inner);
        borders.any(|((from, to), inner)| {
            let border = [*from, *to];
            let inner_side = |light: DVec3| volume(light, border, *inner, self.overhang);
            let first = inner_side(*first_light);
            lights.iter().all(|light| {
                let inside = inner_side(*light);
                let side = |point| volume(*light, border, point, self.overhang);
                let apart = |(_, point): &(ExactVector, DVec3)| match side(*point) {
                    0.0 => false,
                    side => inside != 0.0 && (side > 0.0) != (inside > 0.0),
                };
                inside * first > 0.0 && hull.iter().all(apart)
            })
        })
    }
}

/// Six times the volume of a tetrahedron, positive for one turn of its corners and negative for the
/// other; zero if rounding leaves doubt about which it is, or about how a ray from `c` to the `top` passes `a` and `b`.
/// The line through these may be another one, which lies no further than this `beside` it.
fn volume(top: DVec3, [a, b]: [DVec3; 2], c: DVec3, beside: f64) -> f64 {
    // Each difference, product and sum is rounded once, 11 on the longest path; corners may be
    // rounded too, and points that are computed on a surface lie off it by 16 roundings. All are
    // relative to products of sums of coordinates. The direction of a ray is rounded, too: it passes the
    // top as far off as if that were moved by a few roundings of the whole way.
    const BOUND: f64 = 128.0 * UNIT;
    let size = |point: DVec3| Point::exact(point).size() + Point::exact(top).size();
    let volume = (a - top).cross(b - top).dot(c - top);
    let [a, b, c] = [a, b, c].map(size);
    let doubt = BOUND * c * (a * b + (a + b) * c) + beside * (a + b + beside) * c;
    if volume.abs() > doubt { volume } else { 0.0 }
}
