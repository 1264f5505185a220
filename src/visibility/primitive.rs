//! Primitives: surfaces prepared for ray tests.

use std::cmp::Ordering;

use crate::geometry::{Hit, Resolved, classic};
use crate::math::{
    CarrierId, Curve, Decisions, Flat, Numerics, Point, Ray, RayOrigin, Segment, Side, Span,
};
use crate::surface::{Common, Surface};

/// A surface with its carrier, its index in the scene, and its numerics.
#[derive(Debug, Clone, Copy)]
pub struct Primitive<'a> {
    /// The surface.
    pub surface: &'a dyn Surface,
    /// The properties of every surface.
    pub common: &'a Common,
    /// The index in the scene's list.
    pub index: usize,
    /// The carrier; rays that leave the surface cannot hit it again, except for `None`.
    pub carrier: Option<CarrierId>,
    /// The plane that it lies in, if it is flat and the numerics are robust.
    pub plane: Option<&'a Flat>,
    /// True if rays that start inward can hit it again: it is round, and refracts.
    pub is_entered: bool,
    /// True if it reflects or transmits rays.
    pub sends_on: bool,
    /// The arithmetic that decides hits.
    pub numerics: Numerics,
    /// A bound of the error of a hit point, per unit of error in the hit's distance.
    point_error: f64,
}

impl<'a> Primitive<'a> {
    /// A surface whose hits are decided exactly.
    pub(super) fn robust(index: usize, surface: &'a dyn Surface, carrier: CarrierId) -> Self {
        let shape = surface.shape();
        let enters = shape.round().is_some() && surface.common().material.is_entered();
        Self {
            carrier: Some(carrier),
            plane: shape.carrier(),
            // A carrier has the index of its first surface, which wins all its hits.
            is_entered: enters && carrier.0 as usize == index,
            ..Self::classic(index, surface, Numerics::Robust)
        }
    }

    /// A surface whose hits are decided by rounded values, without proven bounds.
    pub(super) fn classic(index: usize, surface: &'a dyn Surface, numerics: Numerics) -> Self {
        Self {
            surface,
            common: surface.common(),
            index,
            carrier: None,
            plane: None,
            is_entered: false,
            sends_on: surface.common().material.spawns_rays(),
            numerics,
            point_error: surface.shape().point_error(),
        }
    }

    /// The nearest hit of a ray in a span of distances.
    #[must_use]
    #[inline(always)]
    pub fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        match self.numerics {
            Numerics::Robust => self.surface.hits(ray, span),
            Numerics::Classic => classic::intersect::<f64>(self.surface.shape(), ray, span),
            Numerics::ClassicF32 => classic::intersect::<f32>(self.surface.shape(), ray, span),
        }
    }

    /// The exact texel or tile at a hit, and the texel's colour.
    #[must_use]
    #[inline(always)]
    pub fn resolve(&self, hit: &Hit, ray: &Ray) -> Resolved {
        self.surface.resolve(hit, ray, self.numerics)
    }

    /// The side of the surface that a point is on; the front for classic numerics.
    #[must_use]
    pub fn side(&self, point: &Point) -> Side {
        match self.numerics {
            Numerics::Robust => self.surface.shape().side(point),
            Numerics::Classic | Numerics::ClassicF32 => Side::Front,
        }
    }

    /// Returns whether the surface lies on this carrier; false for `None`.
    #[must_use]
    #[inline(always)]
    pub fn lies_on(&self, carrier: Option<CarrierId>) -> bool {
        carrier.is_some() && self.carrier == carrier
    }

    /// The origin of rays that leave the surface at a hit of another ray.
    #[must_use]
    #[inline(always)]
    pub fn ray_origin<'b>(&self, arriving: &'b Ray<'b>, hit: &Hit) -> RayOrigin<'b>
    where
        'a: 'b,
    {
        let on = (self.carrier, self.plane);
        let mut ray_origin = RayOrigin::new(on, arriving, hit.point, self.point_error * hit.error);
        if self.is_entered {
            let normal = hit.normal;
            let round = self.surface.shape().round();
            ray_origin.curve = round.map(|round| Curve { round, normal });
        }
        ray_origin
    }

    /// Returns whether the surface hides one end of a segment from the other.
    ///
    /// `end` is the side of the surface that the segment's end is on. `can_hide` returns whether
    /// the surface can hide the light there from any part of the receiver.
    #[inline]
    pub(super) fn hides(
        &self,
        segment: &Segment,
        end: Side,
        can_hide: impl FnOnce() -> bool,
    ) -> bool {
        let occludes = match self.numerics {
            Numerics::Robust => self.surface.shape().occludes(segment, end),
            Numerics::Classic => classic::occludes::<f64>(self.surface.shape(), segment),
            Numerics::ClassicF32 => classic::occludes::<f32>(self.surface.shape(), segment),
        };
        // A ray that starts within rounding of the occluder's plane keeps the arriving ray's side
        // of it, where the receiver may have no part. An occluder that is proven to hide nothing
        // must not hide, whether it is tested or not.
        let is_in_doubt = |plane: &Flat| plane.is_next_to_start(&segment.ray);
        occludes && (!self.plane.is_some_and(is_in_doubt) || can_hide())
    }

    /// Returns whether a hit of this surface comes before a hit of another one.
    ///
    /// The nearer hit comes first; of equally near ones, the first in the file.
    pub(super) fn is_before(&self, hit: &Hit, other: &Self, other_hit: &Hit, ray: &Ray) -> bool {
        let first_in_file = self.index < other.index;
        if self.carrier.is_some() && self.carrier == other.carrier {
            return first_in_file;
        }
        // The rounded distances are within their errors of the exact ones, except that an exact one
        // below zero is rounded to next above zero. So distances further apart than both errors are
        // in the order of the exact ones.
        let error = hit.error + other_hit.error;
        let nearer = other_hit.t - hit.t;
        if nearer.abs() > error {
            return nearer > 0.0;
        }
        let order = self.exact_order(other, ray);
        let order = order.unwrap_or_else(|| hit.t.total_cmp(&other_hit.t));
        order == Ordering::Less || order == Ordering::Equal && first_in_file
    }

    /// The order of the exact distances; `None` for classic numerics.
    #[cold]
    fn exact_order(&self, other: &Self, ray: &Ray) -> Option<Ordering> {
        if self.numerics != Numerics::Robust {
            return None;
        }
        let [own, other] = [self, other].map(|it| it.surface.shape().exact_distance(ray));
        let order = own?.compare(&other?);
        Decisions::note(order == Ordering::Equal);
        Some(order)
    }
}
