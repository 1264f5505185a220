//! What of a ray counts, and what decides where that ends.

use super::error_bounds::{UNDERFLOW, UNIT};
use super::exact::Sign;
use super::{Flat, Ray, Side, Span};

/// The distances along a ray that count, as rounded values and as what they mean: up to a plane,
/// from a plane on, or all ahead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits<'a> {
    span: Span,
    /// Where the ray crosses the plane, if there is one; infinitely far if not.
    edge: f64,
    /// How far at most that is from the exact distance.
    doubt: f64,
    plane: Option<&'a Flat>,
}

impl From<Span> for Limits<'_> {
    fn from(span: Span) -> Self {
        Self {
            span,
            edge: f64::INFINITY,
            doubt: 0.0,
            plane: None,
        }
    }
}

impl<'a> Limits<'a> {
    /// Everything ahead counts.
    pub const AHEAD: Self = Self {
        span: Span::AHEAD,
        edge: f64::INFINITY,
        doubt: 0.0,
        plane: None,
    };

    /// What lies in a plane across the z axis, or below it.
    ///
    /// The ray's way to the plane has a rounding in the difference of anchors and one in the sum;
    /// the slope is a component of the direction, without any; its reciprocal and the product have
    /// one each. In units of what is rounded that is 1 and 3.
    #[must_use]
    #[inline]
    pub fn below(plane: &'a Flat, ray: &Ray) -> Self {
        let between = ray.origin.anchor.z - plane.point.z;
        let slope = ray.dir.z;
        if slope == 0.0 {
            return Self::beside(plane, ray);
        }
        let reciprocal = 1.0 / slope;
        let edge = -(between + ray.origin.offset.z) * reciprocal;
        let doubt = (4.0 * UNIT) * ((between * reciprocal).abs() + edge.abs()) + UNDERFLOW;
        let span = if slope < 0.0 {
            Span::AHEAD.since(edge - doubt)
        } else {
            Span::AHEAD.until(edge + doubt)
        };
        Self {
            span,
            edge,
            doubt,
            plane: Some(plane),
        }
    }

    /// The same for a ray along the plane: all or nothing.
    #[cold]
    fn beside(plane: &Flat, ray: &Ray) -> Self {
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

    /// Whether something counts that was met in the span, at distance `t` but for this error;
    /// `flat` is its plane, if it lies in one.
    ///
    /// A plane along that of the limit lies on one side of it, whatever the ray, and that is
    /// decided exactly. What passes through that plane counts as far as it, and there within
    /// rounding: the direction of a ray that is aimed at the very place is rounded itself.
    #[must_use]
    #[inline(always)]
    pub fn hold(&self, t: f64, error: f64, flat: Option<&Flat>) -> bool {
        // Not-a-number is in doubt.
        (t - self.edge).abs() > error + self.doubt || self.hold_in_doubt(flat)
    }

    #[cold]
    fn hold_in_doubt(&self, flat: Option<&Flat>) -> bool {
        let pair = self.plane.zip(flat);
        let pair = pair.filter(|(plane, flat)| flat.is_parallel(plane));
        pair.is_none_or(|(plane, flat)| !flat.lies_on(plane, Side::Front))
    }
}
