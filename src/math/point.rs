//! Points that keep their digits far from the origin.

use glam::DVec3;

use super::exact::ExactVector;

/// A point as an exact anchor and a small offset from it.
///
/// The anchor is a number of the scene file: the eye, the corner of a plane, the centre of a
/// sphere. Differences between anchors are exact or nearly so. A scene far from the origin is
/// computed like the same scene at the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// A point given in the scene.
    pub anchor: DVec3,
    /// The vector from the anchor to the point.
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

    /// The vector from another point to this one.
    #[must_use]
    pub fn way_from(&self, other: &Self) -> DVec3 {
        (self.anchor - other.anchor) + (self.offset - other.offset)
    }

    /// The sum of the absolute values of all coordinates of anchor and offset.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.anchor.abs().element_sum() + self.offset.abs().element_sum()
    }

    /// The vector from a scene point to this one, and the sum of all lengths in it.
    ///
    /// The sum bounds the rounding of the vector.
    #[must_use]
    pub fn seen_from(&self, other: DVec3) -> (DVec3, f64) {
        let between = self.anchor - other;
        let size = between.abs().element_sum() + self.offset.abs().element_sum();
        (between + self.offset, size)
    }

    /// Two vectors whose sum leads from a scene point to this one.
    #[must_use]
    pub fn parts_from(&self, other: DVec3) -> [DVec3; 2] {
        [self.anchor - other, self.offset]
    }

    /// The exact vector from a scene point to this one.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_far_scene_is_computed_like_a_near_one() {
        let far = Point {
            anchor: DVec3::splat(1e9),
            offset: DVec3::new(0.1, 0.2, 0.3),
        };
        assert_eq!(far.from(DVec3::splat(1e9 - 1.0)), DVec3::new(1.1, 1.2, 1.3));
    }
}
