//! Rays through neighbouring places of a picture.

use glam::DVec3;

use super::Camera;
use crate::math::{Point, Ray, RayPacket, direction};

/// The rays through a row of a picture: those of [`Camera::ray`], bit for bit.
#[derive(Debug, Clone, Copy)]
pub struct Row<'a> {
    camera: &'a Camera,
    /// Its place, counted in pixels from the centre of the lowest.
    pub y: f64,
    upward: DVec3,
    /// A ray from the eye.
    ray: Ray<'static>,
}

/// Neighbouring pixels of a row.
#[derive(Debug, Clone, Copy)]
pub struct PixelSpan<'a> {
    /// The row.
    pub row: &'a Row<'a>,
    /// The first pixel.
    pub first: u32,
    /// How many there are; at least one.
    pub count: u32,
}

impl Camera {
    /// The rays through the row at this height, counted in pixels from the centre of the lowest.
    #[must_use]
    pub fn row(&self, y: f64) -> Row<'_> {
        Row {
            camera: self,
            y,
            upward: self.upward(y),
            ray: Ray::new(Point::exact(self.viewpoint), DVec3::Z),
        }
    }
}

impl Row<'_> {
    /// The ray through a place of the row, counted in pixels from the centre of the leftmost.
    #[must_use]
    #[inline(always)]
    pub fn ray(&self, x: f64) -> Ray<'static> {
        Ray {
            dir: self.dir(x),
            ..self.ray
        }
    }

    /// Its direction.
    #[must_use]
    #[inline(always)]
    pub fn dir(&self, x: f64) -> DVec3 {
        direction(self.way(x))
    }

    #[inline(always)]
    fn way(&self, x: f64) -> DVec3 {
        self.camera.way_across(x) + self.upward
    }
}

impl PixelSpan<'_> {
    /// The centres of its pixels.
    #[inline(always)]
    pub fn places(&self) -> impl Iterator<Item = f64> {
        let first = f64::from(self.first);
        (0..self.count).map(move |number| first + f64::from(number))
    }

    /// The centres of the first pixel and of the last.
    #[must_use]
    pub fn ends(&self) -> [f64; 2] {
        let first = f64::from(self.first);
        [first, first + f64::from(self.count - 1)]
    }

    /// The rays through it.
    #[must_use]
    pub fn packet(&self) -> RayPacket {
        let Camera {
            lower_left,
            right,
            up,
            ..
        } = self.row.camera;
        let sides = [lower_left, right, up].map(|side| side.abs().element_sum());
        RayPacket {
            ray: self.row.ray,
            ends: self.ends().map(|x| self.row.way(x)),
            size: sides.iter().sum(),
        }
    }
}
