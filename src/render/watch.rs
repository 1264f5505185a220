//! How deep into the picture rays from the eye go.

use super::{Errors, Probe, RayKind};
use crate::camera::Camera;
use crate::math::Rgb;
use crate::surface::Hit;

/// Notes how far rays from the eye go before they meet something.
pub(super) struct Watch<'a> {
    camera: &'a Camera,
    /// The largest depth so far at which one has met something.
    farthest: f64,
    /// Whether the last one has met nothing yet.
    is_under_way: bool,
}

impl<'a> Watch<'a> {
    pub(super) fn new(camera: &'a Camera) -> Self {
        Self {
            camera,
            farthest: 0.0,
            is_under_way: false,
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
}

impl Probe for Watch<'_> {
    fn ray(&mut self, kind: RayKind, _share: Rgb) {
        if kind == RayKind::Camera {
            self.farthest = self.farthest();
            self.is_under_way = true;
        }
    }

    fn met(&mut self, _surface: usize, hit: &Hit, _errors: Errors) {
        if self.is_under_way {
            let way = hit.point.from(self.camera.viewpoint());
            self.farthest = self.farthest.max(self.camera.depth(way));
            self.is_under_way = false;
        }
    }
}
