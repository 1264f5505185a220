//! Ray differentials: the footprints of camera rays, reflected and transmitted rays.

use glam::DVec3;

use super::tracer::Interaction;
use super::{RayKind, Tracer};
use crate::camera::{Pattern, SampleCell, SamplePositions};
use crate::geometry::Hit;
use crate::math::{Beam, Rgb};
use crate::texture::Filter;
use crate::visibility::Primitive;

impl Tracer<'_> {
    /// The ray differential of the camera ray through a raster position.
    ///
    /// It covers the ray's share of its pixel. With the exact filter the shares are cells that tile
    /// the pixel, so the mean over all of them is the mean over the pixel. Other filters centre the
    /// share on the ray.
    #[cold]
    pub(super) fn beam(&self, x: f64, y: f64) -> Beam {
        let settings = &self.plan.scene.settings;
        let pattern = match self.plan.outlines {
            Some(_) => Pattern::Sobol,
            None => settings.pattern,
        };
        let pixel = [x, y].map(|coordinate| (coordinate + 0.5).floor());
        let offset = [x - pixel[0], y - pixel[1]];
        let share = match self.plan.filter {
            // The cells are the same in every pixel.
            Some(Filter::Exact) => SamplePositions::new(pattern, 0, 0, self.rays).cell(offset),
            _ => SampleCell::around(offset, self.rays),
        };
        let middle = [0, 1].map(|axis| pixel[axis] + share.center[axis]);
        self.plan.camera.beam(middle, share.sides)
    }

    /// The filtered texel of a surface over the footprint of a ray.
    #[cold]
    pub(super) fn texel_over(&self, primitive: &Primitive<'_>, hit: &Hit, beam: &Beam) -> Rgb {
        let filter = self.plan.filter;
        filter.map_or(hit.texel, |filter| {
            primitive.surface.texel_over(hit, beam, filter)
        })
    }

    /// The ray differential of a ray that a surface reflects or transmits.
    ///
    /// It is unchanged straight through a surface, exact behind a flat mirror, and correct to first
    /// order behind a round one. A refracted one keeps the width that it has without refraction.
    #[cold]
    pub(super) fn onward(
        &self,
        beam: &Beam,
        at: &Interaction<'_, '_>,
        kind: RayKind,
        onward: DVec3,
    ) -> Beam {
        let shape = at.primitive.surface.shape();
        match (kind, shape.carrier(), shape.round()) {
            (RayKind::Mirror, Some(plane), _) => beam.mirrored_by(plane),
            (RayKind::Mirror, None, Some([center, axes])) => {
                beam.mirrored_at(at.hit.point.about(center), at.hit.normal, axes)
            }
            _ if onward == at.ray.dir => *beam,
            _ => beam.turned(at.hit.point, onward),
        }
    }
}
