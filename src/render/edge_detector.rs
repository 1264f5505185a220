//! Edge detection: whether all rays through a pixel have the same path.

use super::{Arrival, Event, Probe, RayKind};
use crate::camera::Camera;
use crate::geometry::Hit;
use crate::math::{Rgb, scramble};
use crate::plan::{Plan, Unlit};
use crate::scene::{Falloff, Scene};
use crate::surface::Surface;

/// A probe that compares the paths of camera rays, and records their largest depth.
#[derive(Debug, Clone, Copy)]
pub(super) struct EdgeDetector<'a> {
    camera: &'a Camera,
    scene: &'a Scene,
    /// The largest depth of a first hit so far.
    farthest_depth: f64,
    /// True if the last camera ray has no hit yet.
    awaits_hit: bool,
    /// A hash of the last camera ray's path; `None` before the first ray.
    path: Option<u64>,
    /// The hash of the path before.
    previous_path: Option<u64>,
    /// True if all paths before the last one were equal.
    were_equal: bool,
    /// True if the exact filter is exact on all surfaces hit.
    is_exact: bool,
    /// The number of open rays that add nothing to the pixel.
    invisible_rays: u32,
    /// True if light is visible on the surface that was hit last.
    shows_light: bool,
}

impl<'a> EdgeDetector<'a> {
    /// A detector that has observed no ray yet.
    pub(super) fn new(plan: &'a Plan<'a>) -> Self {
        Self {
            camera: &plan.camera,
            scene: plan.scene,
            farthest_depth: 0.0,
            awaits_hit: false,
            path: None,
            previous_path: None,
            were_equal: true,
            // Light that fades with distance varies within a surface.
            is_exact: plan.scene.lighting.view_falloff == Falloff::None,
            invisible_rays: 0,
            shows_light: false,
        }
    }

    /// The largest depth of a first hit; infinite if a ray hit nothing.
    pub(super) fn farthest_depth(&self) -> f64 {
        if self.awaits_hit {
            f64::INFINITY
        } else {
            self.farthest_depth
        }
    }

    /// The hash of the paths if all are equal: no edge lies between any two rays.
    ///
    /// Equal paths hit the same surfaces, in the same colours except for filtered images, with
    /// light from the same lights.
    pub(super) fn path_hash(&self) -> Option<u64> {
        self.path.filter(|_| self.are_equal())
    }

    fn are_equal(&self) -> bool {
        self.were_equal && (self.previous_path.is_none() || self.path == self.previous_path)
    }

    /// Returns whether the exact filter is exact on all surfaces hit.
    ///
    /// False if anything but images varies there.
    pub(super) fn is_exact(&self) -> bool {
        self.is_exact
    }

    /// Adds to the hash of the last camera ray's path.
    fn add_to_path<const MANY: usize>(&mut self, words: [u64; MANY]) {
        let path = |path, word| scramble(path ^ word);
        self.path = self.path.map(|start| words.into_iter().fold(start, path));
    }
}

impl Probe for EdgeDetector<'_> {
    fn on(&mut self, event: Event<'_>) {
        match event {
            Event::Ray(kind, share) => self.on_ray(kind, share),
            Event::Returned(_) => self.invisible_rays = self.invisible_rays.saturating_sub(1),
            Event::Hit(surface, hit, _) => self.on_hit(surface, hit),
            Event::Light(light, arrival) => self.on_light(light, arrival),
            _ => {}
        }
    }
}

impl EdgeDetector<'_> {
    fn on_ray(&mut self, kind: RayKind, share: Rgb) {
        match kind {
            RayKind::Camera => {
                self.farthest_depth = self.farthest_depth();
                self.were_equal = self.are_equal();
                self.previous_path = self.path;
                self.awaits_hit = true;
                self.path = Some(0);
            }
            RayKind::Mirror | RayKind::Transmitted
                if self.invisible_rays > 0 || share.is_black() =>
            {
                self.invisible_rays += 1;
            }
            _ => {}
        }
    }

    fn on_hit(&mut self, surface: usize, hit: &Hit) {
        if self.awaits_hit {
            let offset = hit.point.from(self.camera.viewpoint());
            self.farthest_depth = self.farthest_depth.max(self.camera.depth(offset));
            self.awaits_hit = false;
        }
        if self.invisible_rays > 0 {
            return;
        }
        self.add_to_path([surface as u64]);
        let surface = &*self.scene.surfaces[surface];
        self.is_exact &= is_shown_exactly(surface);
        self.shows_light = Unlit::by_itself(surface).is_none();
        if surface.texture().is_none() {
            self.add_to_path(bits(surface.getamb(hit)));
            self.add_to_path(bits(surface.getdiff(hit)));
        }
    }

    fn on_light(&mut self, light: usize, arrival: Arrival) {
        let (color, compared) = match arrival {
            Arrival::Light { color, .. } => (color, color),
            Arrival::Lamp { color, passed } => (color, passed),
            _ => return,
        };
        // Invisible light depends on the scope, so it does not count.
        if self.invisible_rays == 0 && self.shows_light && !color.is_black() {
            self.add_to_path([light as u64]);
            self.add_to_path(bits(compared));
            // Its direction varies from point to point.
            self.is_exact = false;
        }
    }
}

/// Returns whether the exact filter is exact on a surface.
///
/// It must also be exact for the rays that the surface scatters.
///
/// On round surfaces, and behind round mirrors and glass, footprints are correct to first order
/// only. The mean of a transparent image times an image behind it is not the product of their
/// means. Specular highlights have no filter.
fn is_shown_exactly(surface: &dyn Surface) -> bool {
    let material = &surface.common().material;
    let has_image = surface.texture().is_some();
    let is_shown = match surface.shape().carrier() {
        Some(_) => material.ior.is_none() && !(has_image && material.transparency > 0.0),
        None => !has_image && !material.spawns_rays(),
    };
    is_shown && !material.has_highlights()
}

fn bits(color: Rgb) -> [u64; 3] {
    color.channels().map(f64::to_bits)
}
