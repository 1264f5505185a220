//! Where in a picture something can appear.

use glam::DVec3;

use super::{Camera, PixelSpan};
use crate::math::error_bounds::IMAGE;

/// A part of a picture, in pixels from the centre of the lower-left one: nothing outside of it can
/// show what it was made for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RasterRect {
    low: [f64; 2],
    high: [f64; 2],
}

impl RasterRect {
    /// The whole picture and beyond.
    pub const EVERYWHERE: Self = Self {
        low: [f64::MIN; 2],
        high: [f64::MAX; 2],
    };

    /// Whether some place of a picture of this width and height lies inside, up to half a pixel
    /// beyond the centres of the outermost.
    #[must_use]
    pub fn meets(&self, size: [u32; 2]) -> bool {
        let mut axes = self.low.iter().zip(&self.high).zip(size);
        axes.all(|((low, high), pixels)| *low <= f64::from(pixels) && *high >= -1.0)
    }

    /// Whether some place of a stretch lies inside.
    #[must_use]
    pub fn meets_stretch(&self, stretch: &PixelSpan<'_>) -> bool {
        let (y, [first, last]) = (stretch.row.y, stretch.ends());
        y >= self.low[1] && y <= self.high[1] && first <= self.high[0] && last >= self.low[0]
    }

    /// Whether all places of a stretch lie inside.
    #[must_use]
    pub fn holds_stretch(&self, stretch: &PixelSpan<'_>) -> bool {
        let mut ends = stretch.ends().into_iter();
        ends.all(|x| self.contains(x, stretch.row.y))
    }

    /// Whether a place lies inside.
    #[must_use]
    #[inline(always)]
    pub fn contains(&self, x: f64, y: f64) -> bool {
        x >= self.low[0] && x <= self.high[0] && y >= self.low[1] && y <= self.high[1]
    }
}

impl Camera {
    /// The part of the picture in which the convex hull of some points can appear, which may be `astray` by
    /// so much: their images and a pixel more on every side, which is far more than rounding can move them.
    /// `None` if all of them are behind the eye.
    #[must_use]
    pub fn window(
        &self,
        points: impl IntoIterator<Item = DVec3>,
        astray: f64,
    ) -> Option<RasterRect> {
        // The window's plane: at depth 1 its lower-left corner is where the camera says.
        let normal = self.right.cross(self.up);
        let unit_depth = self.lower_left.dot(normal);
        let (mut behind, mut before) = (true, true);
        let mut window = RasterRect {
            low: [f64::MAX; 2],
            high: [f64::MIN; 2],
        };
        for point in points {
            let way = point - self.viewpoint;
            let depth = way.dot(normal) / unit_depth;
            // What rounding the point and the eye can do to the image.
            let size = (point.abs() + self.viewpoint.abs()).element_sum() + way.length();
            let blur = (IMAGE * size + astray) * self.stretch() / depth.abs();
            if blur.is_nan() || blur > 0.25 {
                return Some(RasterRect::EVERYWHERE);
            }
            behind &= depth < 0.0;
            before &= depth > 0.0;
            let image = way / depth - self.lower_left;
            let places = [self.right, self.up].map(|axis| image.dot(axis) / axis.length_squared());
            for (axis, place) in places.into_iter().enumerate() {
                let pixel = place * self.span[axis] - self.inset;
                window.low[axis] = window.low[axis].min(pixel - 1.0);
                window.high[axis] = window.high[axis].max(pixel + 1.0);
            }
        }
        if behind {
            None
        } else if before {
            Some(window)
        } else {
            Some(RasterRect::EVERYWHERE)
        }
    }

    /// By how many pixels an image moves at most when a place at depth 1 moves by one unit.
    fn stretch(&self) -> f64 {
        let along = |axis: DVec3, span: f64| span / axis.length();
        let reach = self.lower_left.length() + self.right.length() + self.up.length();
        let tilt = reach / (self.lower_left.dot(self.right.cross(self.up).normalize())).abs();
        along(self.right, self.span[0]).max(along(self.up, self.span[1])) * (1.0 + tilt)
    }
}
