//! Limits of a ray: a span of distances, and the plane that ends it.

use super::error_bounds::{SCREEN, UNDERFLOW};
use super::exact::Sign;
use super::{Flat, Ray, Side, Span};

/// The distances that count: up to a plane, from a plane on, or all ahead.
///
/// The span is rounded; the plane decides exactly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits<'a> {
    span: Span,
    /// The distance of the plane's crossing; infinite without a plane.
    edge: f64,
    /// The error bound of `edge`.
    edge_error: f64,
    plane: Option<&'a Flat>,
}

impl From<Span> for Limits<'_> {
    fn from(span: Span) -> Self {
        Self {
            span,
            edge: f64::INFINITY,
            edge_error: 0.0,
            plane: None,
        }
    }
}

impl<'a> Limits<'a> {
    /// All distances ahead count.
    pub const AHEAD: Self = Self {
        span: Span::AHEAD,
        edge: f64::INFINITY,
        edge_error: 0.0,
        plane: None,
    };

    /// The limits of a ray that counts only below a plane across the z axis, or in it.
    #[must_use]
    #[inline]
    pub fn below(plane: &'a Flat, ray: &Ray) -> Self {
        let between = ray.origin.anchor.z - plane.point.z;
        let slope = ray.dir.z;
        if slope == 0.0 {
            return Self::parallel(plane, ray);
        }
        let reciprocal = 1.0 / slope;
        // The difference of anchors and the sum have a rounding each; the slope, a component of the
        // direction, has none; the reciprocal and the product have one each. In units of the
        // rounded values that is 1 and 3.
        let edge = -(between + ray.origin.offset.z) * reciprocal;
        let edge_error = SCREEN * ((between * reciprocal).abs() + edge.abs()) + UNDERFLOW;
        let span = if slope < 0.0 {
            Span::AHEAD.since(edge - edge_error)
        } else {
            Span::AHEAD.until(edge + edge_error)
        };
        Self {
            span,
            edge,
            edge_error,
            plane: Some(plane),
        }
    }

    /// The limits of a ray along the plane: all or nothing.
    #[cold]
    fn parallel(plane: &Flat, ray: &Ray) -> Self {
        if plane.exact_side(&ray.origin) == Sign::Positive {
            Span::AHEAD.until(f64::NEG_INFINITY).into()
        } else {
            Self::AHEAD
        }
    }

    /// The distances that may count.
    #[must_use]
    pub fn span(&self) -> Span {
        self.span
    }

    /// Returns whether a hit in the span, at distance `t` with this error, counts.
    ///
    /// `flat` is the plane of the surface, if it has one. A plane parallel to that of the limit
    /// lies on one side of it for all rays, which is decided exactly. A surface that crosses the
    /// limit counts up to it, within rounding.
    #[must_use]
    #[inline(always)]
    pub fn hold(&self, t: f64, error: f64, flat: Option<&Flat>) -> bool {
        // Not-a-number is undecided.
        (t - self.edge).abs() > error + self.edge_error || self.hold_by_side(flat)
    }

    #[cold]
    fn hold_by_side(&self, flat: Option<&Flat>) -> bool {
        let pair = self.plane.zip(flat);
        let pair = pair.filter(|(plane, flat)| flat.is_parallel(plane));
        pair.is_none_or(|(plane, flat)| !flat.lies_on(plane, Side::Front))
    }
}
