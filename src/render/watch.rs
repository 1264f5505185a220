//! How deep into the picture rays from the eye go.

use super::{Arrival, Errors, Probe, RayKind, Unfollowed};
use crate::camera::Camera;
use crate::math::{Decisions, Rgb};
use crate::surface::Hit;

/// Notes how far rays from the eye go before they meet something, and tells another onlooker
/// everything.
pub(super) struct Watch<'a> {
    other: &'a mut (dyn Probe + 'a),
    camera: &'a Camera,
    /// The largest depth so far at which one has met something.
    farthest: f64,
    /// Whether the last one has met nothing yet.
    is_under_way: bool,
}

impl<'a> Watch<'a> {
    pub(super) fn new(other: &'a mut (dyn Probe + 'a), camera: &'a Camera) -> Self {
        Self {
            other,
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
    fn ray(&mut self, kind: RayKind, share: Rgb) {
        if kind == RayKind::Camera {
            self.farthest = self.farthest();
            self.is_under_way = true;
        }
        self.other.ray(kind, share);
    }

    fn not_followed(&mut self, kind: RayKind, why: Unfollowed) {
        self.other.not_followed(kind, why);
    }

    fn follows_errors(&self) -> bool {
        self.other.follows_errors()
    }

    fn met(&mut self, surface: usize, hit: &Hit, errors: Errors) {
        if self.is_under_way {
            let way = hit.point.from(self.camera.viewpoint());
            self.farthest = self.farthest.max(self.camera.depth(way));
            self.is_under_way = false;
        }
        self.other.met(surface, hit, errors);
    }

    fn light(&mut self, light: usize, arrival: Arrival) {
        self.other.light(light, arrival);
    }

    fn own_color(&mut self, color: Rgb, of_lamps: Rgb) {
        self.other.own_color(color, of_lamps);
    }

    fn came_back(&mut self, color: Rgb) {
        self.other.came_back(color);
    }

    fn hit_tests(&mut self, count: u64) {
        self.other.hit_tests(count);
    }

    fn occlusion_tests(&mut self, light: usize, count: u64) {
        self.other.occlusion_tests(light, count);
    }

    fn texel_fetches(&mut self, count: u64) {
        self.other.texel_fetches(count);
    }

    fn decisions(&mut self, decisions: Decisions) {
        self.other.decisions(decisions);
    }
}
