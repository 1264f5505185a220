//! The rays around a ray, from the eye and behind surfaces, and what they see of textures.

use glam::DVec3;

use super::tracer::Interaction;
use super::{RayKind, Tracer};
use crate::camera::{Pattern, Places, Share};
use crate::geometry::Hit;
use crate::math::{Beam, Rgb};
use crate::texture::Filter;
use crate::visibility::Primitive;

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
            Some(Filter::Exact) => Places::new(pattern, 0, 0, self.rays).share(place),
            _ => Share::around(place, self.rays),
        };
        let middle = [0, 1].map(|axis| pixel[axis] + share.center[axis]);
        self.plan.camera.beam(middle, share.sides)
    }

    /// What a beam shows of the texture of what it meets.
    #[cold]
    pub(super) fn texel_over(&self, primitive: &Primitive<'_>, hit: &Hit, beam: &Beam) -> Rgb {
        let filter = self.plan.filter;
        filter.map_or(hit.texel, |filter| {
            primitive.surface.texel_over(hit, beam, filter)
        })
    }

    /// The beam behind a surface that reflects or transmits a ray in this direction.
    ///
    /// Straight through it is the same beam. Behind a flat mirror it is exact, behind a round one right
    /// to first order. A refracted beam is as wide as if it were not refracted.
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
