//! How deep into the picture a ray from the eye goes.

use super::{Errors, Probe};
use crate::camera::Camera;
use crate::surface::Hit;

/// Notes where a ray from the eye meets something first.
pub(super) struct Watch<'a> {
    camera: &'a Camera,
    /// The depth; infinite if it meets nothing.
    pub(super) depth: f64,
}

impl<'a> Watch<'a> {
    pub(super) fn new(camera: &'a Camera) -> Self {
        Self {
            camera,
            depth: f64::INFINITY,
        }
    }
}

impl Probe for Watch<'_> {
    fn met(&mut self, _surface: usize, hit: &Hit, _errors: Errors) {
        if self.depth.is_infinite() {
            let way = hit.point.from(self.camera.viewpoint());
            self.depth = self.camera.depth(way);
        }
    }
}
