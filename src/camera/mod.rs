//! From pixels to rays.

mod image;
mod pattern;
mod places;
mod raster_rect;
mod row;
mod view;

pub use pattern::Pattern;
pub use places::{Places, Share};
pub use raster_rect::RasterRect;
pub use row::{PixelSpan, Row};
pub use view::{View, WindowOrigin};

use glam::DVec3;

use crate::math::{Beam, Flat, Limits, Point, Ray, direction};

/// A viewpoint and the window that it looks through, for a picture of a certain size.
#[derive(Debug, Clone, PartialEq)]
pub struct Camera {
    viewpoint: DVec3,
    /// From the viewpoint to the window's lower-left corner.
    lower_left: DVec3,
    /// Along the window's lower edge, whole.
    right: DVec3,
    /// Along the window's left edge, whole.
    up: DVec3,
    /// How far the first pixel's centre lies inside the window's edge, in pixels.
    inset: f64,
    /// Pixels from edge to edge.
    span: [f64; 2],
    /// The plane of the chapter's screen, whose normal is the z axis; hits before it are misses.
    screen: Option<Flat>,
}

impl Camera {
    /// Where the camera is.
    #[must_use]
    pub fn viewpoint(&self) -> DVec3 {
        self.viewpoint
    }

    /// The ray through a place of the picture, counted in pixels from the centre of the
    /// lower-left one.
    #[must_use]
    pub fn ray(&self, x: f64, y: f64) -> Ray<'static> {
        Ray::new(Point::exact(self.viewpoint), direction(self.way(x, y)))
    }

    /// The rays around that one through a rectangle with these sides in pixels.
    #[must_use]
    pub fn beam(&self, [x, y]: [f64; 2], [width, height]: [f64; 2]) -> Beam {
        let [right, up] = [self.right / self.span[0], self.up / self.span[1]];
        let way = self.way(x, y);
        Beam::new(
            Point::exact(self.viewpoint),
            way,
            [right * width, up * height],
        )
    }

    /// From the viewpoint to a place in the window.
    #[inline(always)]
    fn way(&self, x: f64, y: f64) -> DVec3 {
        self.way_across(x) + self.upward(y)
    }

    /// From the viewpoint to a place on the window's lower edge.
    #[inline(always)]
    fn way_across(&self, x: f64) -> DVec3 {
        self.lower_left + self.right * ((x + self.inset) / self.span[0])
    }

    /// From the window's lower edge to a row.
    #[inline(always)]
    fn upward(&self, y: f64) -> DVec3 {
        self.up * ((y + self.inset) / self.span[1])
    }

    /// The distances at which a ray can meet a surface.
    ///
    /// Behind the chapter's screen everything counts, on the viewer's side nothing does.
    #[must_use]
    #[inline]
    pub fn span(&self, ray: &Ray) -> Limits<'_> {
        match &self.screen {
            Some(screen) => Limits::below(screen, ray),
            None => Limits::AHEAD,
        }
    }

    /// The plane of the chapter's screen, before which nothing counts, if it looks through one.
    #[must_use]
    pub fn screen(&self) -> Option<&Flat> {
        self.screen.as_ref()
    }

    /// The directions from the viewpoint through the window's corners.
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
