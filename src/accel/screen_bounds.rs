//! Which surfaces the eye can see where.

use super::{Entry, SurfaceList, nearest, overhang};
use crate::camera::{Camera, PixelSpan, RasterRect};
use crate::math::{Limits, Ray};
use crate::surface::Hit;

/// The surfaces that a camera can see, each with the part of the picture in which it can appear.
///
/// A ray that passes outside of that part misses the surface for certain, so it need not be asked.
#[derive(Debug)]
pub struct ScreenBounds<'a> {
    seen: Vec<(RasterRect, Entry<'a>)>,
}

/// What rays from the eye through a stretch of the picture can meet.
#[derive(Debug, Clone, Copy)]
pub enum Ahead<'s, 'a> {
    /// Nothing at all.
    Nothing,
    /// This surface alone, all along.
    One(&'s Entry<'a>),
    /// Several surfaces, or one in a part of it.
    Several,
}

impl<'a> ScreenBounds<'a> {
    /// What a camera sees of these surfaces.
    #[must_use]
    pub fn new(surfaces: &SurfaceList<'a>, camera: &Camera) -> Self {
        let window = |entry: &Entry<'a>| {
            let outline = entry.surface.outline();
            if !outline.is_empty() {
                return camera.raster_bounds(outline, overhang(entry.surface));
            }
            match entry.surface.bounds() {
                Some(bounds) => camera.raster_bounds(bounds.corners(), 0.0),
                None => Some(RasterRect::EVERYWHERE),
            }
        };
        let seen = surfaces
            .entries()
            .iter()
            .filter_map(|entry| Some((window(entry)?, *entry)));
        Self {
            seen: seen.collect(),
        }
    }

    /// Whether each of so many surfaces can appear in a picture of this width and height.
    #[must_use]
    pub fn seen(&self, size: [u32; 2], count: usize) -> Vec<bool> {
        let mut seen = vec![false; count];
        for (window, entry) in &self.seen {
            seen[entry.index] = window.overlaps_picture(size);
        }
        seen
    }

    /// What rays from the eye through a stretch of the picture can meet.
    #[must_use]
    pub fn along(&self, stretch: &PixelSpan<'_>) -> Ahead<'_, 'a> {
        let mut here = self
            .seen
            .iter()
            .filter(|(window, _)| window.overlaps_span(stretch));
        match (here.next(), here.next()) {
            (None, _) => Ahead::Nothing,
            (Some((window, entry)), None) if window.contains_span(stretch) => Ahead::One(entry),
            _ => Ahead::Several,
        }
    }

    /// The surface that a ray from the eye through a place of the picture meets first; as
    /// [`SurfaceList::nearest`].
    #[must_use]
    #[inline]
    pub fn nearest(
        &self,
        [x, y]: [f64; 2],
        ray: &Ray,
        span: Limits<'_>,
        tests: &mut u64,
    ) -> Option<(&Entry<'a>, Hit)> {
        let here = self.seen.iter().filter(|(window, _)| window.contains(x, y));
        nearest(here.map(|(_, entry)| entry), ray, span, tests)
    }
}
