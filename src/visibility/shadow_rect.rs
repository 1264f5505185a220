//! Shadow rectangles: ranges of uv outside of which an occluder casts no shadow.

use glam::{DVec2, DVec3};

use super::silhouette::Silhouette;
use crate::math::error_bounds::{SHADE, UNDERFLOW};
use crate::math::{Point, Ray};

/// A range of uv on a rectangular receiver, outside of which an occluder casts no shadow.
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
    /// `None` if the receiver is no rectangle, or the occluder not lower above it than the light.
    pub(super) fn of(light: DVec3, occluder: &Silhouette, receiver: &Silhouette) -> Option<Self> {
        let rectangle = receiver.rectangle.as_ref()?;
        let (x, y, normal) = (rectangle.frame.x, rectangle.frame.y, rectangle.flat.normal);
        let corner = rectangle.flat.point;
        let way = light - corner;
        let height = normal.dot(way);
        let length = way.length() + rectangle.size.element_sum();
        let hull: Vec<_> = occluder.corners().collect();
        if !occluder.is_bounded() {
            return None;
        }

        let sum = |point: DVec3| Point::exact(point).size();
        let largest = hull.iter().map(|point| sum(*point)).fold(0.0, f64::max);
        let size = sum(light) + sum(corner) + rectangle.size.element_sum() + largest;
        let slant = slant(occluder, light, length)?;
        let blur = (SHADE * size + 2.0 * occluder.border_error) * slant + UNDERFLOW;

        // If the segment from P on the receiver to the light L meets the occluder's hull, then P is the
        // image, seen from L, of a point X in the hull: Q(X) = L + (X − L) H / (H − h), where H and h are
        // the heights of L and X above the receiver. So P is in the convex hull of the images of the
        // hull's corners, for all of them are lower than the light.
        let mut range = Self {
            low: DVec2::INFINITY,
            high: DVec2::NEG_INFINITY,
            origin_error: blur / 8.0,
        };
        let mut gap = f64::INFINITY;
        for point in hull {
            let fall = normal.dot(light - point);
            gap = gap.min(fall);
            let image = way + (point - light) * (height / fall);
            let uv = DVec2::new(x.dot(image), y.dot(image));
            range.low = range.low.min(uv);
            range.high = range.high.max(uv);
        }
        // Let each of the decided line, the deciding occluder and the point be off by a share of `blur`,
        // so that a line that is said to hit the occluder comes as near as `blur` to its hull. Then P is
        // as near as 2 blur (H + |P − L|) / gap to the images, if the whole hull is lower than the
        // light by gap > 2 blur: the difference of Q(X) and Q(Y) = P for the point Y of the line next to
        // X. Twice that is added on every side.
        let margin = 8.0 * blur * (length / gap);
        range.low -= margin;
        range.high += margin;
        (gap > 4.0 * blur && range.low.is_finite() && range.high.is_finite()).then_some(range)
    }

    /// Returns whether the ray from a point at these coordinates to the light certainly misses.
    #[inline(always)]
    pub(super) fn is_missed(&self, uv: DVec2, ray: &Ray) -> bool {
        let outside =
            uv.x < self.low.x || uv.x > self.high.x || uv.y < self.low.y || uv.y > self.high.y;
        outside && ray.astray <= self.origin_error
    }
}

/// The factor between the rounding of a ray to a light and the distance at which it may pass the
/// occluder and still count as a hit. The ray is no longer than `length`.
fn slant(occluder: &Silhouette, light: DVec3, length: f64) -> Option<f64> {
    match (&occluder.plane, occluder.round) {
        // Borders are decided by lines that are off the plane by rounding, so a ray at a small angle
        // to the plane can miss by more. From across the plane to the light it rises by more than the
        // light's height.
        (Some(plane), _) => Some((length / plane.normal.dot(light - plane.point).abs()).max(1.0)),
        // An ellipsoid is decided in a space where its axes are equal.
        (None, Some([_, axes])) => Some(axes.max_element() / axes.min_element()),
        (None, None) => None,
    }
}
