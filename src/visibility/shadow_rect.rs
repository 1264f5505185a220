//! Shadow rectangles: ranges of uv outside of which an occluder casts no shadow.

use glam::{DVec2, DVec3};

use super::silhouette::Silhouette;
use crate::math::error_bounds::{SHADE, UNDERFLOW};
use crate::math::{Point, Ray};

/// A range of uv on a rectangle, outside of which an occluder casts no shadow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ShadowRect {
    low: DVec2,
    high: DVec2,
    /// The largest error of a ray's origin for which the range holds.
    origin_error: f64,
}

impl ShadowRect {
    /// The range in which a bounded occluder can hide a point light from a rectangle.
    ///
    /// `None` if the receiver is not a rectangle, or if the occluder is not certainly below the
    /// light, in heights above the receiver.
    pub(super) fn of(light: DVec3, occluder: &Silhouette, receiver: &Silhouette) -> Option<Self> {
        let rectangle = receiver.rectangle.as_ref()?;
        let (x, y, normal) = (rectangle.frame.x, rectangle.frame.y, rectangle.flat.normal);
        let corner = rectangle.flat.point;
        let offset = light - corner;
        let height = normal.dot(offset);
        let length = offset.length() + rectangle.size.element_sum();
        let hull: Vec<_> = occluder.corners().collect();
        if !occluder.is_bounded() {
            return None;
        }

        let sum = |point: DVec3| Point::exact(point).size();
        let largest = hull.iter().map(|point| sum(*point)).fold(0.0, f64::max);
        let size = sum(light) + sum(corner) + rectangle.size.element_sum() + largest;
        let slant = slant(occluder, light, length)?;
        let tolerance = (SHADE * size + 2.0 * occluder.border_error) * slant + UNDERFLOW;

        // If the segment from P on the receiver to the light L hits the occluder's hull, then P is
        // the projection from L of a point X in the hull: Q(X) = L + (X − L) H / (H − h), where H
        // and h are the heights of L and X above the receiver. All corners of the hull are lower
        // than the light, so P is in the convex hull of their projections.
        let mut range = Self {
            low: DVec2::INFINITY,
            high: DVec2::NEG_INFINITY,
            origin_error: tolerance / 8.0,
        };
        let mut gap = f64::INFINITY;
        for point in hull {
            let fall = normal.dot(light - point);
            gap = gap.min(fall);
            let image = offset + (point - light) * (height / fall);
            let uv = DVec2::new(x.dot(image), y.dot(image));
            range.low = range.low.min(uv);
            range.high = range.high.max(uv);
        }
        // The errors of the tested line, the deciding occluder and the point add up to at most the
        // tolerance τ, so a line that counts as a hit comes within τ of the hull. Let the whole
        // hull be lower than the light by gap > 2 τ. For the point Y of the line nearest to X,
        // Q(Y) = P, and P is within 2 τ (H + |P − L|) / gap of Q(X). Twice that is added on every
        // side.
        let margin = 8.0 * tolerance * (length / gap);
        range.low -= margin;
        range.high += margin;
        (gap > 4.0 * tolerance && range.low.is_finite() && range.high.is_finite()).then_some(range)
    }

    /// Returns whether a ray from these coordinates to the light certainly misses.
    #[inline(always)]
    pub(super) fn is_missed(&self, uv: DVec2, ray: &Ray) -> bool {
        let outside =
            uv.x < self.low.x || uv.x > self.high.x || uv.y < self.low.y || uv.y > self.high.y;
        outside && ray.astray <= self.origin_error
    }
}

/// The miss distance that counts as a hit, per unit of rounding of the ray.
///
/// `length` bounds the length of the ray. `None` if the occluder is neither flat nor round.
fn slant(occluder: &Silhouette, light: DVec3, length: f64) -> Option<f64> {
    match (&occluder.plane, occluder.round) {
        // Border lines are off the plane by rounding, so a ray at a small angle to the plane can
        // miss by more. From the other side of the plane to the light it rises by more than the
        // light's height.
        (Some(plane), _) => Some((length / plane.normal.dot(light - plane.point).abs()).max(1.0)),
        // An ellipsoid is tested in a space where its axes are equal.
        (None, Some([_, axes])) => Some(axes.max_element() / axes.min_element()),
        (None, None) => None,
    }
}
