//! Rays through the pixels of a row.

use glam::DVec3;

use super::Camera;
use crate::math::{Point, Ray, RayPacket, direction};

/// The rays through a row of pixels, bit for bit those of [`Camera::ray`].
#[derive(Debug, Clone, Copy)]
pub struct Row<'a> {
    camera: &'a Camera,
    /// Raster position of the row.
    pub y: f64,
    /// From the window's lower edge to the row.
    above_lower_edge: DVec3,
    /// A ray from the viewpoint.
    ray: Ray<'static>,
}

/// Consecutive pixels of a row.
#[derive(Debug, Clone, Copy)]
pub struct PixelSpan<'a> {
    /// The row.
    pub row: &'a Row<'a>,
    /// The first pixel.
    pub first: u32,
    /// The number of pixels, at least one.
    pub count: u32,
}

impl Camera {
    /// The rays through the row at a raster position.
    #[must_use]
    pub fn row(&self, y: f64) -> Row<'_> {
        Row {
            camera: self,
            y,
            above_lower_edge: self.above_lower_edge(y),
            ray: Ray::new(Point::exact(self.viewpoint), DVec3::Z),
        }
    }
}

impl Row<'_> {
    /// The ray through a raster position of the row.
    #[must_use]
    #[inline(always)]
    pub fn ray(&self, x: f64) -> Ray<'static> {
        Ray {
            dir: self.dir(x),
            ..self.ray
        }
    }

    /// The direction of the ray through a raster position of the row.
    #[must_use]
    #[inline(always)]
    pub fn dir(&self, x: f64) -> DVec3 {
        direction(self.window_point(x))
    }

    #[inline(always)]
    fn window_point(&self, x: f64) -> DVec3 {
        self.camera.to_lower_edge(x) + self.above_lower_edge
    }
}

impl PixelSpan<'_> {
    /// Raster positions of the pixel centres.
    #[inline(always)]
    pub fn centers(&self) -> impl Iterator<Item = f64> {
        let first = f64::from(self.first);
        (0..self.count).map(move |number| first + f64::from(number))
    }

    /// Raster positions of the first and the last pixel centre.
    #[must_use]
    pub fn ends(&self) -> [f64; 2] {
        let first = f64::from(self.first);
        [first, first + f64::from(self.count - 1)]
    }

    /// The rays through the pixel centres.
    #[must_use]
    pub fn packet(&self) -> RayPacket {
        let camera = self.row.camera;
        let sides = [camera.lower_left, camera.right, camera.up];
        RayPacket {
            ray: self.row.ray,
            ends: self.ends().map(|x| self.row.window_point(x)),
            size: sides.iter().map(|side| side.abs().element_sum()).sum(),
        }
    }
}
