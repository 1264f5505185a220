//! Where on a rectangle the shadow of another surface can fall.

use glam::{DVec2, DVec3};

use super::receivers::Body;
use crate::math::error_bounds::{SHADE, UNDERFLOW};
use crate::math::{Point, Ray};

/// A part of a rectangle, in its own coordinates: outside of it lies no shadow of what it was made
/// for, so that need not be asked there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Shade {
    low: DVec2,
    high: DVec2,
    /// How far a point may be from where it ought to.
    astray: f64,
}

impl Shade {
    /// The part of a rectangle where a bounded surface can hide a light from it; `None` if the
    /// receiver is no rectangle or the caster not lower above it than the light.
    ///
    /// If the way from `P` on the receiver to the light `L` meets the caster's hull, then `P` is the
    /// image, seen from `L`, of a point `X` in the hull: `Q(X) = L + (X − L) H / (H − h)`, where `H` and
    /// `h` are the heights of `L` and `X` above the receiver. So `P` is in the convex hull of the
    /// images of the hull's corners, for all of them are lower than the light, and in the
    /// rectangle around these.
    ///
    /// That holds on either side of the caster and of the start, so it does not matter which side is
    /// inherited. What is left is rounding. Of the decided line, the caster that decides, and the
    /// point, let each be off by a share of `blur`, so that a line that is said to meet the caster
    /// comes as near as `blur` to its hull. Then `P` is as near as `2 blur (H + |P − L|) / gap` to the
    /// images, if the whole hull is lower than the light by `gap > 2 blur`: the difference of `Q(X)`
    /// and `Q(Y) = P` for the point `Y` of the line next to `X`. Twice that is added on every side.
    pub(super) fn of(light: DVec3, caster: &Body, receiver: &Body) -> Option<Self> {
        let rectangle = receiver.rectangle()?;
        let [x, y, normal] = rectangle.axes;
        let way = light - rectangle.corner;
        let height = normal.dot(way);
        let reach = way.length() + rectangle.size.element_sum();
        let hull: Vec<_> = caster.hull()?.collect();

        // A ray that is nearly parallel to the caster is told from its borders less well.
        let slant = caster.slant(light, reach)?;
        let sum = |point: DVec3| Point::exact(point).size();
        let largest = hull.iter().map(|point| sum(*point)).fold(0.0, f64::max);
        let size = sum(light) + sum(rectangle.corner) + rectangle.size.element_sum() + largest;
        let blur = (SHADE * size + 2.0 * caster.overhang) * slant + UNDERFLOW;

        let mut shade = Self {
            low: DVec2::INFINITY,
            high: DVec2::NEG_INFINITY,
            astray: blur / 8.0,
        };
        let mut gap = f64::INFINITY;
        for point in hull {
            let fall = normal.dot(light - point);
            gap = gap.min(fall);
            let image = way + (point - light) * (height / fall);
            let place = DVec2::new(x.dot(image), y.dot(image));
            shade.low = shade.low.min(place);
            shade.high = shade.high.max(place);
        }
        let margin = 8.0 * blur * (reach / gap);
        shade.low -= margin;
        shade.high += margin;
        (gap > 4.0 * blur && shade.low.is_finite() && shade.high.is_finite()).then_some(shade)
    }

    /// Whether the way to the light from a place on the receiver passes the caster by for certain.
    #[inline(always)]
    pub(super) fn is_beside(&self, place: DVec2, ray: &Ray) -> bool {
        let outside = place.x < self.low.x
            || place.x > self.high.x
            || place.y < self.low.y
            || place.y > self.high.y;
        outside && ray.astray <= self.astray
    }
}
