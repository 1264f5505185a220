//! Raster rectangles, and the raster bounds of points.

use glam::DVec3;

use super::{Camera, PixelSpan};
use crate::math::error_bounds::IMAGE;

/// A rectangle of raster positions that contains the image of an object.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RasterRect {
    low: [f64; 2],
    high: [f64; 2],
}

impl RasterRect {
    /// All raster positions.
    pub const EVERYWHERE: Self = Self {
        low: [f64::MIN; 2],
        high: [f64::MAX; 2],
    };

    /// True if it overlaps a picture of a size, or a border of one pixel around it.
    #[must_use]
    pub fn overlaps_picture(&self, size: [u32; 2]) -> bool {
        let mut axes = self.low.iter().zip(&self.high).zip(size);
        axes.all(|((low, high), pixels)| *low <= f64::from(pixels) && *high >= -1.0)
    }

    /// True if it overlaps the line through the pixel centres of a span.
    #[must_use]
    pub fn overlaps_span(&self, span: &PixelSpan<'_>) -> bool {
        let (y, [first, last]) = (span.row.y, span.ends());
        y >= self.low[1] && y <= self.high[1] && first <= self.high[0] && last >= self.low[0]
    }

    /// True if it contains all pixel centres of a span.
    #[must_use]
    pub fn contains_span(&self, span: &PixelSpan<'_>) -> bool {
        let mut ends = span.ends().into_iter();
        ends.all(|x| self.contains(x, span.row.y))
    }

    /// True if it contains a raster position.
    #[must_use]
    #[inline(always)]
    pub fn contains(&self, x: f64, y: f64) -> bool {
        x >= self.low[0] && x <= self.high[0] && y >= self.low[1] && y <= self.high[1]
    }
}

impl Camera {
    /// The raster rectangle of the convex hull of points with an error bound.
    ///
    /// It is one pixel larger on each side. `None` if all points are behind the viewpoint.
    #[must_use]
    pub fn raster_bounds(
        &self,
        points: impl IntoIterator<Item = DVec3>,
        error: f64,
    ) -> Option<RasterRect> {
        let (mut all_behind, mut all_in_front) = (true, true);
        let mut bounds = RasterRect {
            low: [f64::MAX; 2],
            high: [f64::MIN; 2],
        };
        for point in points {
            let offset = point - self.viewpoint;
            let depth = self.depth(offset);
            // The error of the raster position in pixels; the extra pixel must be much larger.
            let size = (point.abs() + self.viewpoint.abs()).element_sum() + offset.length();
            let image_error = (IMAGE * size + error) * self.pixels_per_unit() / depth.abs();
            if image_error.is_nan() || image_error > 0.25 {
                return Some(RasterRect::EVERYWHERE);
            }
            all_behind &= depth < 0.0;
            all_in_front &= depth > 0.0;
            let image = offset / depth - self.lower_left;
            for (axis, edge) in [self.right, self.up].into_iter().enumerate() {
                let along = image.dot(edge) / edge.length_squared();
                let pixel = along * self.pixels[axis] - self.inset;
                bounds.low[axis] = bounds.low[axis].min(pixel - 1.0);
                bounds.high[axis] = bounds.high[axis].max(pixel + 1.0);
            }
        }
        if all_behind {
            None
        } else if all_in_front {
            Some(bounds)
        } else {
            Some(RasterRect::EVERYWHERE)
        }
    }

    /// Bound of an image's movement in pixels per unit of movement at depth 1.
    fn pixels_per_unit(&self) -> f64 {
        let along = |axis: DVec3, pixels: f64| pixels / axis.length();
        let reach = self.lower_left.length() + self.right.length() + self.up.length();
        let tilt = reach / (self.lower_left.dot(self.right.cross(self.up).normalize())).abs();
        along(self.right, self.pixels[0]).max(along(self.up, self.pixels[1])) * (1.0 + tilt)
    }
}
