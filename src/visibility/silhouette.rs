//! The geometry of a surface or a light as occluder, emitter and receiver.

use std::sync::OnceLock;

use glam::DVec3;

use super::padded_bounds::shared_border_error;
use super::primitive::Primitive;
use crate::geometry::{Rectangle, Shape};
use crate::math::error_bounds::VOLUME;
use crate::math::exact::ExactVector;
use crate::math::{Ball, Bounds, CarrierId, Flat, Numerics, Point, Side};
use crate::surface::Surface;

/// The geometry by which a surface hides a light, emits light, or receives shadows.
///
/// A point light is a silhouette whose hull has one point.
#[derive(Debug, Clone, Default)]
pub struct Silhouette {
    carrier: Option<CarrierId>,
    pub(super) plane: Option<Flat>,
    pub(super) outline: Vec<DVec3>,
    /// A bound of the distance at which it can be hit outside of its outline.
    pub(super) border_error: f64,
    /// Points whose convex hull holds it, exact and rounded; `None` if it is unbounded.
    hull: Option<Vec<(ExactVector, DVec3)>>,
    /// Centre and half axes of a round shape.
    pub(super) round: Option<[DVec3; 2]>,
    /// A rectangle, on whose front shadows fall.
    pub(super) rectangle: Option<Rectangle>,
}

/// The silhouettes of all surfaces, each computed on first use.
#[derive(Debug)]
pub struct Silhouettes {
    // In large scenes few are ever needed, and exact corners are slow to compute.
    computed: Vec<OnceLock<Box<Silhouette>>>,
}

impl Silhouettes {
    /// The silhouettes of `count` surfaces, none of them computed yet.
    #[must_use]
    pub fn new(count: usize) -> Self {
        Self {
            computed: (0..count).map(|_| OnceLock::new()).collect(),
        }
    }

    /// The silhouette of a surface.
    #[must_use]
    pub fn of(&self, primitive: &Primitive<'_>) -> &Silhouette {
        self.computed[primitive.index].get_or_init(|| Box::new(Silhouette::of(primitive)))
    }
}

impl Silhouette {
    /// The silhouette of a surface; empty for one with classic numerics.
    #[must_use]
    pub fn of(primitive: &Primitive<'_>) -> Self {
        match primitive.numerics {
            Numerics::Robust => Self::of_surface(primitive.surface, primitive.carrier),
            Numerics::Classic | Numerics::ClassicF32 => Self::default(),
        }
    }

    /// The silhouette of a surface on a carrier.
    #[must_use]
    pub fn of_surface(surface: &dyn Surface, carrier: Option<CarrierId>) -> Self {
        let shape = surface.shape();
        let with_rounded = |point: ExactVector| {
            let rounded = point.rounded();
            (point, rounded)
        };
        let hull = shape.hull();
        Self {
            carrier,
            plane: shape.carrier().copied(),
            outline: shape.outline(),
            border_error: shared_border_error(surface),
            hull: hull.map(|hull| hull.into_iter().map(with_rounded).collect()),
            round: shape.round(),
            rectangle: match shape {
                Shape::Rectangle(rectangle) => Some(*rectangle),
                _ => None,
            },
        }
    }

    /// The silhouette of a point light.
    #[must_use]
    pub fn of_point(light: DVec3) -> Self {
        Self {
            hull: Some(vec![(light.into(), light)]),
            ..Self::default()
        }
    }

    /// The rounded points of the hull; empty if the silhouette is unbounded.
    pub(super) fn corners(&self) -> impl Iterator<Item = DVec3> {
        let hull = self.hull.iter().flatten();
        hull.map(|(_, rounded)| *rounded)
    }

    /// Returns whether the hull is known and bounded.
    pub(super) fn is_bounded(&self) -> bool {
        self.hull.is_some()
    }

    /// The only point of the hull: the location of a point light.
    fn point(&self) -> Option<DVec3> {
        match self.hull.as_deref() {
            Some([(_, rounded)]) => Some(*rounded),
            _ => None,
        }
    }

    /// A ball around the hull.
    pub(super) fn ball(&self) -> Option<Ball> {
        self.is_bounded()
            .then(|| Ball::around(&Bounds::around(self.corners())))
    }

    /// Returns whether part of it lies strictly in front of a receiver's plane.
    ///
    /// True for a receiver that is not flat.
    #[must_use]
    pub fn is_in_front_of(&self, receiver: &Self) -> bool {
        let plane = receiver.plane.as_ref();
        plane.is_none_or(|plane| self.reaches(plane, Side::Front))
    }

    /// Returns whether its light can reach the front of a receiver, without occluders.
    #[must_use]
    pub fn can_light(&self, receiver: &Self) -> bool {
        self.is_in_front_of(receiver) && receiver.is_in_front_of(self)
    }

    /// The side of its plane that holds all of an emitter not in the plane.
    ///
    /// `None` if the emitter is on both sides, or if this is not flat.
    pub(super) fn side_of(&self, emitter: &Self) -> Option<Side> {
        let plane = self.plane.as_ref()?;
        match [Side::Front, Side::Back].map(|side| emitter.reaches(plane, side)) {
            [true, true] => None,
            [true, false] => Some(Side::Front),
            [false, true] => Some(Side::Back),
            [false, false] => Some(Side::On),
        }
    }

    /// Returns whether it can hide part of an emitter from part of a receiver.
    ///
    /// A plane hides only points strictly on its other side, and a bounded flat surface only points
    /// in its shadow pyramid. So the floor and walls of a room hide nothing in it.
    pub(super) fn can_hide(&self, emitter: &Self, receiver: &Self) -> bool {
        if self.carrier.is_some() && [receiver.carrier, emitter.carrier].contains(&self.carrier) {
            return false;
        }
        let Some(plane) = &self.plane else {
            // A round occluder of a lamp is tested at each hit.
            let light = emitter.point();
            return light.is_none_or(|light| !self.shadow_cone_misses(light, receiver));
        };
        let between = |(lit, dark)| emitter.reaches(plane, lit) && receiver.reaches(plane, dark);
        let sides = [(Side::Front, Side::Back), (Side::Back, Side::Front)];
        sides.into_iter().any(between) && !self.shadow_pyramid_misses(emitter, receiver)
    }

    /// Returns whether part of it can lie strictly on this side of a plane.
    pub(super) fn reaches(&self, plane: &Flat, side: Side) -> bool {
        if let Some(round) = self.round {
            return plane.has_some_of(round, side);
        }
        match (&self.hull, &self.plane) {
            (Some(hull), _) => hull
                .iter()
                .any(|(exact, rounded)| plane.side_of(exact, *rounded) == side),
            (None, Some(own)) => !own.is_parallel(plane) || own.lies_on(plane, side),
            (None, None) => true,
        }
    }

    /// Returns whether a receiver certainly lies outside of its shadow cone.
    fn shadow_cone_misses(&self, light: DVec3, receiver: &Self) -> bool {
        let (Some(own), Some(receiver)) = (self.ball(), receiver.ball()) else {
            return false;
        };
        own.cone_from(light).is_some_and(|(axis, half_angle)| {
            receiver.is_outside(light, axis, half_angle) && own.is_told_from(light, &receiver)
        })
    }

    /// Returns whether a receiver certainly lies outside of its shadow pyramid.
    ///
    /// It lies on the outer side of the planes through one border and each corner of the emitter.
    /// All these planes have the surface on one side.
    fn shadow_pyramid_misses(&self, emitter: &Self, receiver: &Self) -> bool {
        // The volume is linear in both ends, so its sign holds for points between corners, too.
        let (Some(hull), Some(first_light)) = (&receiver.hull, emitter.corners().next()) else {
            return false;
        };
        let next = self.outline.iter().cycle().skip(1);
        let inner = self.outline.iter().cycle().skip(2);
        let mut borders = self.outline.iter().zip(next).zip(inner);
        borders.any(|((from, to), inner)| {
            let volume = |light, point| volume(light, [*from, *to], point, self.border_error);
            let first = volume(first_light, *inner);
            emitter.corners().all(|light| {
                let inside = volume(light, *inner);
                let is_outside = |(_, point): &(ExactVector, DVec3)| match volume(light, *point) {
                    0.0 => false,
                    side => inside != 0.0 && (side > 0.0) != (inside > 0.0),
                };
                inside * first > 0.0 && hull.iter().all(is_outside)
            })
        })
    }
}

/// Six times the signed volume of a tetrahedron.
///
/// The sign is the orientation of its corners.
///
/// Zero if rounding leaves the sign uncertain, or the side on which a ray from `c` to `top` passes
/// the border `ab`. The border that decides hits may lie `border_error` away.
fn volume(top: DVec3, [a, b]: [DVec3; 2], c: DVec3, border_error: f64) -> f64 {
    let size = |point: DVec3| Point::exact(point).size() + Point::exact(top).size();
    let volume = (a - top).cross(b - top).dot(c - top);
    let [a, b, c] = [a, b, c].map(size);
    let rounding = VOLUME * c * (a * b + (a + b) * c);
    let bound = rounding + border_error * (a + b + border_error) * c;
    if volume.abs() > bound { volume } else { 0.0 }
}
