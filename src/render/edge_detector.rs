//! What the rays through a pixel meet, as far as it tells how many more it takes.

use super::{Arrival, Errors, Probe, RayKind};
use crate::camera::Camera;
use crate::math::{Rgb, scramble};
use crate::plan::{Plan, Unlit};
use crate::scene::{Falloff, Scene};
use crate::surface::{Hit, Surface};

/// Notes how far rays from the eye go before they meet something, and whether they all find the same.
#[derive(Debug, Clone, Copy)]
pub(super) struct EdgeDetector<'a> {
    camera: &'a Camera,
    scene: &'a Scene,
    /// The largest depth so far at which one has met something.
    farthest: f64,
    /// Whether the last one has met nothing yet.
    is_under_way: bool,
    /// What stands for all that the last one has found; `None` before the first.
    path: Option<u64>,
    /// The same of the one before.
    path_before: Option<u64>,
    /// Whether all before the last one have found the same.
    was_even: bool,
    /// Whether the exact filter is exact for all that was met, and nothing else varies there.
    is_exact: bool,
    /// How many rays are under way that show nothing of what they meet.
    idle: u32,
    /// Whether light is seen on the surface that was met last.
    answers: bool,
}

impl<'a> EdgeDetector<'a> {
    /// Of no ray yet.
    pub(super) fn new(plan: &'a Plan<'a>) -> Self {
        Self {
            camera: &plan.camera,
            scene: plan.scene,
            farthest: 0.0,
            is_under_way: false,
            path: None,
            path_before: None,
            was_even: true,
            // Light that fades varies even within a thing.
            is_exact: plan.scene.lighting.view_falloff == Falloff::None,
            idle: 0,
            answers: false,
        }
    }

    /// The largest depth at which a ray met something; infinite if one met nothing.
    pub(super) fn farthest(&self) -> f64 {
        if self.is_under_way {
            f64::INFINITY
        } else {
            self.farthest
        }
    }

    /// What stands for all that a ray has found, if no border lies between any two: they met the same
    /// surfaces, in the same colours but for images with a filter, and the same lights shone there.
    pub(super) fn path(&self) -> Option<u64> {
        self.path.filter(|_| self.is_even())
    }

    fn is_even(&self) -> bool {
        self.was_even && (self.path_before.is_none() || self.path == self.path_before)
    }

    /// Whether the exact filter shows just a ray's share of all that was met, and nothing else varies
    /// between borders.
    pub(super) fn is_exact(&self) -> bool {
        self.is_exact
    }

    /// Adds to what the last ray has found.
    fn note<const MANY: usize>(&mut self, what: [u64; MANY]) {
        let path = |path, what| scramble(path ^ what);
        self.path = self.path.map(|start| what.into_iter().fold(start, path));
    }
}

impl Probe for EdgeDetector<'_> {
    fn ray(&mut self, kind: RayKind, share: Rgb) {
        match kind {
            RayKind::Camera => {
                self.farthest = self.farthest();
                self.was_even = self.is_even();
                self.path_before = self.path;
                self.is_under_way = true;
                self.path = Some(0);
            }
            RayKind::Mirror | RayKind::Transmitted if self.idle > 0 || share.is_black() => {
                self.idle += 1;
            }
            _ => {}
        }
    }

    fn came_back(&mut self, _color: Rgb) {
        self.idle = self.idle.saturating_sub(1);
    }

    fn met(&mut self, surface: usize, hit: &Hit, _errors: Errors) {
        if self.is_under_way {
            let way = hit.point.from(self.camera.viewpoint());
            self.farthest = self.farthest.max(self.camera.depth(way));
            self.is_under_way = false;
        }
        if self.idle > 0 {
            return;
        }
        self.note([surface as u64]);
        let surface = &*self.scene.surfaces[surface];
        self.is_exact &= is_shown_exactly(surface);
        self.answers = Unlit::by_itself(surface).is_none();
        if surface.texture().is_none() {
            self.note(bits(surface.getamb(hit)));
            self.note(bits(surface.getdiff(hit)));
        }
    }

    fn light(&mut self, light: usize, arrival: Arrival) {
        let (color, what) = match arrival {
            Arrival::Light { color, .. } => (color, color),
            Arrival::Lamp { color, passed } => (color, passed),
            _ => return,
        };
        // What nothing is seen of may be planned or not.
        if self.idle == 0 && self.answers && !color.is_black() {
            self.note([light as u64]);
            self.note(bits(what));
            // It comes from another side to each place.
            self.is_exact = false;
        }
    }
}

/// Whether the exact filter shows just what a beam covers of a surface, and of what is seen by way of it.
///
/// Images on round things are shown right to first order, and so is what these and glass bend. Before
/// another image, the mean of both is not the product of their means. Glints have no filter.
fn is_shown_exactly(surface: &dyn Surface) -> bool {
    let material = &surface.common().material;
    let has_image = surface.texture().is_some();
    let is_shown = match surface.flat() {
        Some(_) => material.ior.is_none() && !(has_image && material.transparency > 0.0),
        None => !has_image && !material.spawns_rays(),
    };
    is_shown && !material.has_highlights()
}

fn bits(color: Rgb) -> [u64; 3] {
    color.channels().map(f64::to_bits)
}
