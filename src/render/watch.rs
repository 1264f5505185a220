//! How deep into the picture a ray from the eye goes.

use super::{Arrival, Errors, Probe, RayKind, Unfollowed};
use crate::camera::Camera;
use crate::math::{Decisions, Rgb};
use crate::surface::Hit;

/// Notes where a ray from the eye meets something first, and tells another onlooker everything.
pub(super) struct Watch<'a> {
    other: &'a mut (dyn Probe + 'a),
    camera: &'a Camera,
    /// The depth; infinite if it meets nothing.
    pub(super) depth: f64,
}

impl<'a> Watch<'a> {
    pub(super) fn new(other: &'a mut (dyn Probe + 'a), camera: &'a Camera) -> Self {
        Self {
            other,
            camera,
            depth: f64::INFINITY,
        }
    }
}

impl Probe for Watch<'_> {
    fn ray(&mut self, kind: RayKind, share: Rgb) {
        self.other.ray(kind, share);
    }

    fn not_followed(&mut self, kind: RayKind, why: Unfollowed) {
        self.other.not_followed(kind, why);
    }

    fn follows_errors(&self) -> bool {
        self.other.follows_errors()
    }

    fn met(&mut self, surface: usize, hit: &Hit, errors: Errors) {
        if self.depth.is_infinite() {
            let way = hit.point.from(self.camera.viewpoint());
            self.depth = self.camera.depth(way);
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
