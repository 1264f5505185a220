//! Screen bounds: the part of the raster in which each surface can appear.

use super::padded_bounds::shared_border_error;
use super::primitive::Primitive;
use super::surface_list::{SurfaceList, nearest};
use crate::camera::{Camera, PixelSpan, RasterRect};
use crate::geometry::Hit;
use crate::math::{Limits, Ray};

/// The surfaces that a camera can see, each with its rectangle of the raster.
///
/// A ray through the raster outside of that rectangle certainly misses the surface.
#[derive(Debug)]
pub struct ScreenBounds<'a> {
    seen: Vec<(RasterRect, Primitive<'a>)>,
}

/// The surfaces that camera rays through a pixel span can hit.
#[derive(Debug, Clone, Copy)]
pub enum Visible<'s, 'a> {
    /// None.
    Nothing,
    /// One surface, in every pixel.
    One(&'s Primitive<'a>),
    /// Several surfaces, or one in some of the pixels.
    Several,
}

impl<'a> ScreenBounds<'a> {
    /// The rectangles of all surfaces in front of a camera.
    #[must_use]
    pub fn new(surfaces: &SurfaceList<'a>, camera: &Camera) -> Self {
        let window = |primitive: &Primitive<'a>| {
            let outline = primitive.surface.shape().outline();
            if !outline.is_empty() {
                return camera.raster_bounds(outline, shared_border_error(primitive.surface));
            }
            match primitive.surface.shape().bounds() {
                Some(bounds) => camera.raster_bounds(bounds.corners(), 0.0),
                None => Some(RasterRect::EVERYWHERE),
            }
        };
        let seen = surfaces
            .primitives()
            .iter()
            .filter_map(|primitive| Some((window(primitive)?, *primitive)));
        Self {
            seen: seen.collect(),
        }
    }

    /// Returns for each of `count` surfaces whether it can appear in a raster.
    #[must_use]
    pub fn visible(&self, size: [u32; 2], count: usize) -> Vec<bool> {
        let mut seen = vec![false; count];
        for (window, primitive) in &self.seen {
            seen[primitive.index] = window.overlaps_picture(size);
        }
        seen
    }

    /// The surfaces that camera rays through a pixel span can hit.
    #[must_use]
    pub fn along(&self, span: &PixelSpan<'_>) -> Visible<'_, 'a> {
        let mut here = self
            .seen
            .iter()
            .filter(|(window, _)| window.overlaps_span(span));
        match (here.next(), here.next()) {
            (None, _) => Visible::Nothing,
            (Some((window, primitive)), None) if window.contains_span(span) => {
                Visible::One(primitive)
            }
            _ => Visible::Several,
        }
    }

    /// The surface that a camera ray through a raster position hits first.
    ///
    /// As [`SurfaceList::nearest`].
    #[must_use]
    #[inline]
    pub fn nearest(
        &self,
        [x, y]: [f64; 2],
        ray: &Ray,
        span: Limits<'_>,
        tests: &mut u64,
    ) -> Option<(&Primitive<'a>, Hit)> {
        let here = self.seen.iter().filter(|(window, _)| window.contains(x, y));
        nearest(here.map(|(_, primitive)| primitive), ray, span, tests)
    }
}
