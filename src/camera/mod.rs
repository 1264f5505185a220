//! Cameras: rays of pixels, and raster positions of points.

mod image;
mod pattern;
mod raster_rect;
mod row;
mod samples;
mod view;

pub use pattern::Pattern;
pub use raster_rect::RasterRect;
pub use row::{PixelSpan, Row};
pub use samples::{SampleCell, SamplePositions};
pub use view::{View, WindowOrigin};

use glam::DVec3;

use crate::math::{Beam, Flat, Limits, Point, Ray, direction};

/// A viewpoint and a window in front of it, for a picture of a certain size.
///
/// Raster positions are in pixels from the centre of the lower-left pixel.
#[derive(Debug, Clone, PartialEq)]
pub struct Camera {
    viewpoint: DVec3,
    /// From the viewpoint to the window's lower-left corner.
    lower_left: DVec3,
    /// The window's lower edge.
    right: DVec3,
    /// The window's left edge.
    up: DVec3,
    /// Distance from the window's edge to the first pixel centre, in pixels.
    inset: f64,
    /// Width and height of the window in pixels.
    pixels: [f64; 2],
    /// The plane of the chapter's screen, with the z axis as normal.
    ///
    /// Hits in front of it do not count.
    screen: Option<Flat>,
}

impl Camera {
    /// The viewpoint in world units.
    #[must_use]
    pub fn viewpoint(&self) -> DVec3 {
        self.viewpoint
    }

    /// The ray through a raster position.
    #[must_use]
    pub fn ray(&self, x: f64, y: f64) -> Ray<'static> {
        Ray::new(
            Point::exact(self.viewpoint),
            direction(self.to_window(x, y)),
        )
    }

    /// The rays through a rectangle around a raster position, with its sides in pixels.
    #[must_use]
    pub fn beam(&self, [x, y]: [f64; 2], [width, height]: [f64; 2]) -> Beam {
        let [right, up] = [self.right / self.pixels[0], self.up / self.pixels[1]];
        Beam::new(
            Point::exact(self.viewpoint),
            self.to_window(x, y),
            [right * width, up * height],
        )
    }

    /// The vector from the viewpoint to a raster position in the window.
    #[inline(always)]
    fn to_window(&self, x: f64, y: f64) -> DVec3 {
        self.to_lower_edge(x) + self.above_lower_edge(y)
    }

    /// The vector from the viewpoint to the window's lower edge.
    #[inline(always)]
    fn to_lower_edge(&self, x: f64) -> DVec3 {
        self.lower_left + self.right * ((x + self.inset) / self.pixels[0])
    }

    /// The vector from the window's lower edge to a row.
    #[inline(always)]
    fn above_lower_edge(&self, y: f64) -> DVec3 {
        self.up * ((y + self.inset) / self.pixels[1])
    }

    /// The distances along a ray that count: those behind the chapter's screen.
    #[must_use]
    #[inline]
    pub fn limits(&self, ray: &Ray) -> Limits<'_> {
        match &self.screen {
            Some(screen) => Limits::below(screen, ray),
            None => Limits::AHEAD,
        }
    }

    /// The plane of the chapter's screen, if the camera has one.
    #[must_use]
    pub fn screen(&self) -> Option<&Flat> {
        self.screen.as_ref()
    }

    /// The vectors from the viewpoint to the window's corners.
    #[must_use]
    pub fn corners(&self) -> [DVec3; 4] {
        let corner = self.lower_left;
        [
            corner,
            corner + self.right,
            corner + self.up,
            corner + self.right + self.up,
        ]
    }
}
