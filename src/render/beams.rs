//! The rays around a ray, from the eye and behind surfaces, and what they see of textures.

use glam::DVec3;

use super::{RayKind, Tracer};
use crate::accel::Entry;
use crate::camera::{Pattern, SampleCell, SamplePositions};
use crate::math::{Beam, Ray, Rgb};
use crate::surface::Hit;
use crate::texture::Filter;

impl Tracer<'_> {
    /// The beam from the eye through a place of the picture: through the ray's share of its pixel.
    ///
    /// An area is the same wherever in it the ray is, so the mean over all areas is that over the pixel if
    /// they are its parts. Filters that look at one place look where the ray goes.
    #[cold]
    pub(super) fn beam(&self, x: f64, y: f64) -> Beam {
        let picture = &self.plan.scene.settings;
        let pattern = match self.plan.outlines {
            Some(_) => Pattern::Sobol,
            None => picture.pattern,
        };
        let pixel = [x, y].map(|place| (place + 0.5).floor());
        let place = [x - pixel[0], y - pixel[1]];
        let share = match self.plan.filter {
            // Which pixel it is does not matter to the cells.
            Some(Filter::Exact) => SamplePositions::new(pattern, 0, 0, self.rays).cell(place),
            _ => SampleCell::around(place, self.rays),
        };
        let middle = [0, 1].map(|axis| pixel[axis] + share.center[axis]);
        self.plan.camera.beam(middle, share.sides)
    }

    /// What a beam shows of the texture of what it meets.
    #[cold]
    pub(super) fn texel_over(&self, entry: &Entry<'_>, hit: &Hit, beam: &Beam) -> Rgb {
        let filter = self.plan.filter;
        filter.map_or(hit.texel, |filter| {
            entry.surface.texel_over(hit, beam, filter)
        })
    }

    /// The beam behind a surface that a ray met, of which rays go on in this direction.
    ///
    /// Straight through is the same beam; behind a flat mirror it is exact, behind a round one right
    /// to first order. Where light is bent, the beam is as wide as if it were not.
    #[cold]
    pub(super) fn onward(
        &self,
        beam: &Beam,
        entry: &Entry<'_>,
        (ray, hit): (&Ray, &Hit),
        (kind, onward): (RayKind, DVec3),
    ) -> Beam {
        // Classic surfaces have no shape to ask for.
        let surface = &self.plan.scene.surfaces[entry.index];
        match (kind, surface.flat(), surface.round()) {
            (RayKind::Mirror, Some(flat), _) => beam.mirrored_by(flat),
            (RayKind::Mirror, None, Some([center, axes])) => {
                beam.mirrored_at(hit.point.about(center), hit.normal, axes)
            }
            _ if onward == ray.dir => *beam,
            _ => beam.turned(hit.point, onward),
        }
    }
}
