//! Points, rays, and the stretch of a ray that counts.

use glam::DVec3;

use super::Flat;
use super::band::{FOOT, HEIGHT, SLIDE, UNIT};
use super::exact::ExactVector;
use super::vector::reflected;

/// A point as an exact anchor and a small offset from it.
///
/// The anchor is a number of the scene file (the eye, the corner of a plane, the centre of a
/// sphere), so differences between anchors are exact or nearly so, and a scene far from the
/// origin is computed like the same scene at the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// A point given in the scene.
    pub anchor: DVec3,
    /// From the anchor to the point.
    pub offset: DVec3,
}

impl Point {
    /// A point given in the scene.
    #[must_use]
    pub const fn exact(anchor: DVec3) -> Self {
        Self {
            anchor,
            offset: DVec3::ZERO,
        }
    }

    /// The vector from a scene point to this one.
    #[must_use]
    pub fn from(&self, other: DVec3) -> DVec3 {
        (self.anchor - other) + self.offset
    }

    /// The same point, as an offset from another scene point.
    #[must_use]
    pub fn about(&self, anchor: DVec3) -> Self {
        Self {
            anchor,
            offset: self.from(anchor),
        }
    }

    /// The vector to this point from another.
    #[must_use]
    pub fn way_from(&self, other: &Self) -> DVec3 {
        (self.anchor - other.anchor) + (self.offset - other.offset)
    }

    /// The sum of all lengths that it is made of.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.anchor.abs().element_sum() + self.offset.abs().element_sum()
    }

    /// The vector from a scene point to this one, and the sum of all lengths that went into it,
    /// which bounds its rounding.
    #[must_use]
    pub fn seen_from(&self, other: DVec3) -> (DVec3, f64) {
        let between = self.anchor - other;
        let size = between.abs().element_sum() + self.offset.abs().element_sum();
        (between + self.offset, size)
    }

    /// Two vectors that lead from a scene point to this one, one after the other.
    #[must_use]
    pub fn parts_from(&self, other: DVec3) -> [DVec3; 2] {
        [self.anchor - other, self.offset]
    }

    /// The vector from a scene point to this one, exactly.
    #[must_use]
    pub fn exactly_from(&self, other: DVec3) -> ExactVector {
        let between = &ExactVector::from(self.anchor) - &ExactVector::from(other);
        &between + &ExactVector::from(self.offset)
    }

    /// The point in world coordinates, rounded.
    #[must_use]
    pub fn world(&self) -> DVec3 {
        self.anchor + self.offset
    }
}

impl From<DVec3> for Point {
    fn from(anchor: DVec3) -> Self {
        Self::exact(anchor)
    }
}

/// The plane, sphere or other surface sheet that a hit lies on. Coplanar surfaces share one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Support(pub u32);

/// A half-line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray<'a> {
    /// Where it starts.
    pub origin: Point,
    /// Where it goes; of unit length, so that `t` is a distance.
    pub dir: DVec3,
    /// The hit that it starts from, if it does not start in free space.
    pub departure: Option<&'a Departure<'a>>,
    /// The ray's share in what a height above a plane can be off by when the way to the plane's
    /// point is computed.
    pub(crate) doubt: f64,
    /// A bound of how far its origin lies from where it ought to.
    pub(crate) astray: f64,
}

/// A hit from which other rays start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Departure<'a> {
    /// The surface's sheet, which the rays cannot meet again: a line meets a plane once. `None` if
    /// they can.
    pub support: Option<Support>,
    /// The surface's plane, if it is flat.
    pub flat: Option<&'a Flat>,
    /// The hit.
    pub point: Point,
    /// What the hit is on, if the rays that go to its inside meet it again.
    pub curve: Option<Curve>,
    /// The ray that arrived there.
    pub arriving: &'a Ray<'a>,
    /// How far at most the point lies from where it ought to.
    rounding: f64,
    doubt: f64,
    astray: f64,
}

/// The place on a round thing that rays can be inside of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curve {
    /// The centre and the half axes.
    pub round: [DVec3; 2],
    /// The unit normal, outward.
    pub normal: DVec3,
}

impl<'a> Departure<'a> {
    /// The hit of a ray at this point of a surface on this sheet.
    ///
    /// `slip` is how far it may be off because its distance is.
    #[must_use]
    #[inline]
    pub fn new(
        (support, flat): (Option<Support>, Option<&'a Flat>),
        arriving: &'a Ray<'a>,
        point: Point,
        slip: f64,
    ) -> Self {
        let size = point.size();
        let (_, before) = arriving.origin.seen_from(point.anchor);
        let length = before + point.offset.abs().element_sum();
        Self {
            support,
            flat,
            point,
            curve: None,
            arriving,
            rounding: arriving.rounding() + FOOT * length + slip.min(SLIDE * length),
            doubt: HEIGHT * size,
            astray: arriving.astray + (FOOT / HEIGHT) * arriving.doubt + FOOT * size + slip,
        }
    }

    /// Whether the surface is known to lie in this plane.
    #[must_use]
    pub fn is_in(&self, flat: &Flat) -> bool {
        self.flat
            .is_some_and(|own| own.decisive() == flat.decisive())
    }

    /// How far at most the point lies from where it ought to: beyond a plane that was not crossed.
    ///
    /// That is how far it lies from where the ray that arrived met the surface, and how far that
    /// ray's own origin was off, since a ray that starts beyond a plane and runs along it ends as
    /// far beyond.
    #[must_use]
    pub fn rounding(&self) -> f64 {
        self.rounding
    }
}

impl<'a> Ray<'a> {
    /// A ray that starts in free space.
    #[must_use]
    pub fn new(origin: Point, dir: DVec3) -> Self {
        debug_assert!(is_unit(dir), "{dir} is not unit");
        Self {
            origin,
            dir,
            departure: None,
            doubt: HEIGHT * origin.size(),
            astray: 0.0,
        }
    }

    /// A ray that starts from a hit.
    #[must_use]
    pub fn leaving(departure: &'a Departure<'a>, dir: DVec3) -> Self {
        debug_assert!(is_unit(dir), "{dir} is not unit");
        Self {
            origin: departure.point,
            dir,
            departure: Some(departure),
            doubt: departure.doubt,
            astray: departure.astray,
        }
    }

    /// A bound of the sum of all lengths that its origin is made of.
    #[must_use]
    pub(crate) fn size(&self) -> f64 {
        const SIZE: f64 = (1.0 + 4.0 * UNIT) / HEIGHT;
        self.doubt * SIZE
    }

    /// How far at most its origin lies from where it ought to.
    #[must_use]
    pub fn rounding(&self) -> f64 {
        self.departure.map_or(0.0, |departure| departure.rounding())
    }

    /// The sheet that it starts from.
    #[must_use]
    pub fn leaves(&self) -> Option<Support> {
        self.departure.and_then(|departure| departure.support)
    }

    /// Whether it goes to the inside of this round thing, if it starts from its surface.
    ///
    /// That is the side for which the direction was made, whatever the rounded point says.
    #[must_use]
    pub fn goes_inside(&self, round: [DVec3; 2]) -> Option<bool> {
        let curve = self.departure?.curve?;
        (curve.round == round).then(|| self.dir.dot(curve.normal) < 0.0)
    }

    /// The point at distance `t`.
    #[must_use]
    pub fn at(&self, t: f64) -> Point {
        Point {
            anchor: self.origin.anchor,
            offset: self.origin.offset + self.dir * t,
        }
    }

    /// The direction of the mirrored ray at a surface with this unit normal, from either side.
    #[must_use]
    pub fn mirrored(&self, normal: DVec3) -> DVec3 {
        reflected(self.dir, normal)
    }
}

fn is_unit(dir: DVec3) -> bool {
    (dir.length_squared() - 1.0).abs() < 16.0 * f64::EPSILON
}

/// The distances along a ray that count: open at zero, closed at the given bounds.
///
/// Comparisons are written so that not-a-number lies outside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    min: f64,
    max: f64,
}

impl Span {
    /// Everything ahead of the origin.
    pub const AHEAD: Self = Self {
        min: 0.0,
        max: f64::MAX,
    };

    /// The largest distance that counts.
    #[must_use]
    pub fn max(self) -> f64 {
        self.max
    }

    /// Whether a hit at distance `t` counts.
    #[must_use]
    pub fn contains(self, t: f64) -> bool {
        t > 0.0 && t >= self.min && t <= self.max
    }

    /// Whether a hit counts that was computed to lie at distance `t`, but may be nearer by as much
    /// as `error`.
    ///
    /// So a hit that may be the nearest is not lost only because another is known better.
    #[must_use]
    pub fn admits(self, t: f64, error: f64) -> bool {
        t > 0.0 && t >= self.min && t - error <= self.max && t <= f64::MAX
    }

    /// The part up to distance `t`.
    #[must_use]
    pub fn until(self, t: f64) -> Self {
        Self {
            max: self.max.min(t),
            ..self
        }
    }

    /// The part from distance `t` on.
    #[must_use]
    pub fn since(self, t: f64) -> Self {
        Self {
            min: self.min.max(t),
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_span_excludes_its_origin_and_nonsense() {
        let span = Span::AHEAD.until(2.0).since(1.0);
        assert!(span.contains(1.0) && span.contains(2.0));
        assert!(!span.contains(0.5) && !span.contains(f64::NAN) && !span.contains(f64::INFINITY));
        assert!(!Span::AHEAD.contains(0.0) && Span::AHEAD.contains(5e-324));
    }

    #[test]
    fn a_far_scene_is_computed_like_a_near_one() {
        let far = Point {
            anchor: DVec3::splat(1e9),
            offset: DVec3::new(0.1, 0.2, 0.3),
        };
        assert_eq!(far.from(DVec3::splat(1e9 - 1.0)), DVec3::new(1.1, 1.2, 1.3));
    }
}
