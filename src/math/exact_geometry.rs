//! The geometry of a flat surface without rounding, as in the scene file.

use dashu_ratio::RBig;
use glam::{DVec2, DVec3};

use super::exact::{RationalVector, decimal};
use super::{ExactFrame, Line};

/// A plane and the borders of a surface in it, from the decimals of the scene.
///
/// Surfaces are compared by these numbers when a scene is loaded. Only as decimals are 0.1 + 0.2
/// and 0.3 equal.
#[derive(Debug, Clone)]
pub struct ExactGeometry {
    /// A point of the plane.
    pub point: RationalVector,
    /// The normal, of any length.
    pub normal: RationalVector,
    /// The borders, in the surface's own order; none if it is unbounded.
    pub borders: Vec<Border>,
}

/// One border of a flat surface.
#[derive(Debug, Clone)]
pub struct Border {
    /// A point from which going `across` to the outer side leads to the border.
    pub point: RationalVector,
    /// The direction, of any length; from the front, the inner side is on its right.
    pub along: RationalVector,
    /// The distance of the border from `point`.
    pub across: RBig,
    /// Both ends as seen from `point`, in lengths of `along`.
    pub stretch: [RBig; 2],
}

impl ExactGeometry {
    /// An unbounded plane.
    #[must_use]
    pub fn plane(point: DVec3, normal: DVec3) -> Self {
        Self {
            point: RationalVector::of_decimals(point),
            normal: RationalVector::of_decimals(normal),
            borders: Vec::new(),
        }
    }

    /// A rectangle: borders left, right, bottom and top.
    #[must_use]
    pub fn rectangle(corner: DVec3, normal: DVec3, xdir: DVec3, size: DVec2) -> Self {
        Self::framed(corner, ExactFrame::new(normal, xdir), size)
    }

    /// A rectangle along the axes of a frame.
    pub fn framed(corner: DVec3, frame: ExactFrame, size: DVec2) -> Self {
        let plane = Self {
            point: RationalVector::of_decimals(corner),
            normal: frame.normal,
            borders: Vec::new(),
        };
        let border = |along: &RationalVector, sign: i8, across: f64, length: f64| {
            let end = decimal(length) / along.length().0;
            Border {
                point: plane.point.clone(),
                along: along.times(&RBig::from(sign)),
                across: decimal(across),
                stretch: [RBig::ZERO, end * RBig::from(sign)],
            }
        };
        let borders = vec![
            border(&frame.y, 1, 0.0, size.y),
            border(&frame.y, -1, size.x, size.y),
            border(&frame.x, -1, 0.0, size.x),
            border(&frame.x, 1, size.y, size.x),
        ];
        Self { borders, ..plane }
    }

    /// A convex polygon with corners counter-clockwise as seen from the front.
    ///
    /// Its borders lead from each corner to the next.
    #[must_use]
    pub fn polygon(corners: &[DVec3]) -> Self {
        let corners: Vec<_> = corners
            .iter()
            .copied()
            .map(RationalVector::of_decimals)
            .collect();
        let next = |index: usize| &corners[(index + 1) % corners.len()];
        let border = |(index, from): (usize, &RationalVector)| Border {
            point: from.clone(),
            along: from - next(index),
            across: RBig::ZERO,
            stretch: [RBig::ZERO, -RBig::ONE],
        };
        Self {
            normal: (next(0) - &corners[0]).cross(&(next(1) - &corners[0])),
            borders: corners.iter().enumerate().map(border).collect(),
            point: corners[0].clone(),
        }
    }
}

impl Border {
    /// The border as a line with the numbers of the scene file, without rounding.
    ///
    /// `None` if doubles cannot hold them.
    #[must_use]
    pub fn exact_line(&self, normal: &RationalVector) -> Option<Line> {
        let dir = self.along.whole()?;
        let outer = normal.cross(&self.along);
        let point = if self.across.is_zero() {
            self.point.clone()
        } else {
            let (length, exact) = outer.length();
            if !exact {
                return None;
            }
            &self.point + &outer.times(&(&self.across / length))
        };
        let rounded = point.rounded();
        let same = RationalVector::of_decimals(rounded) == point;
        same.then(|| Line::new(rounded, dir, 0.0))
    }
}
