//! Onlookers: what the tracer does, seen from outside.

use std::iter::Sum;

use super::Errors;
use crate::math::Decisions;

/// Someone who is told what the tracer does. `()` does not listen and costs nothing.
pub trait Probe {
    /// A ray from the eye.
    fn camera_ray(&mut self) {}
    /// A ray from a surface to a light.
    fn shadow_ray(&mut self) {}
    /// A ray from a surface to a point of a lamp.
    fn lamp_ray(&mut self) {}
    /// A ray mirrored by a surface.
    fn mirror_ray(&mut self) {}
    /// A ray straight through a surface.
    fn transmitted_ray(&mut self) {}
    /// Surfaces that were asked whether a ray meets them.
    fn hit_tests(&mut self, _count: u64) {}
    /// Surfaces that were asked whether they hide a light.
    fn occlusion_tests(&mut self, _count: u64) {}
    /// What of that rounded values could not decide.
    fn decisions(&mut self, _decisions: Decisions) {}
    /// A ray that would have been followed if one ray from the eye could cause more, and how much
    /// it could have added to the pixel.
    fn capped(&mut self, _missed: f64) {}
    /// A hit, with how far off it may be.
    fn hit(&mut self, _errors: Errors) {}
}

impl Probe for () {}

/// How much work a picture took.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, serde::Serialize)]
pub struct Counts {
    /// Rays from the eye.
    pub camera_rays: u64,
    /// Rays to lights.
    pub shadow_rays: u64,
    /// Rays to points of lamps.
    pub lamp_rays: u64,
    /// Rays from mirrors.
    pub mirror_rays: u64,
    /// Rays through surfaces.
    pub transmitted_rays: u64,
    /// Surfaces that were asked whether a ray meets them.
    pub hit_tests: u64,
    /// Surfaces that were asked whether they hide a light.
    pub occlusion_tests: u64,
    /// What of that rounded values could not decide.
    pub decisions: Decisions,
}

impl Counts {
    /// All rays.
    #[must_use]
    pub fn rays(&self) -> u64 {
        self.camera_rays
            + self.shadow_rays
            + self.lamp_rays
            + self.mirror_rays
            + self.transmitted_rays
    }
}

impl Probe for Counts {
    fn camera_ray(&mut self) {
        self.camera_rays += 1;
    }

    fn shadow_ray(&mut self) {
        self.shadow_rays += 1;
    }

    fn lamp_ray(&mut self) {
        self.lamp_rays += 1;
    }

    fn mirror_ray(&mut self) {
        self.mirror_rays += 1;
    }

    fn transmitted_ray(&mut self) {
        self.transmitted_rays += 1;
    }

    fn hit_tests(&mut self, count: u64) {
        self.hit_tests += count;
    }

    fn occlusion_tests(&mut self, count: u64) {
        self.occlusion_tests += count;
    }

    fn decisions(&mut self, decisions: Decisions) {
        self.decisions = self.decisions + decisions;
    }
}

impl Sum for Counts {
    fn sum<I: Iterator<Item = Self>>(counts: I) -> Self {
        counts.fold(Self::default(), |sum, next| Self {
            camera_rays: sum.camera_rays + next.camera_rays,
            shadow_rays: sum.shadow_rays + next.shadow_rays,
            lamp_rays: sum.lamp_rays + next.lamp_rays,
            mirror_rays: sum.mirror_rays + next.mirror_rays,
            transmitted_rays: sum.transmitted_rays + next.transmitted_rays,
            hit_tests: sum.hit_tests + next.hit_tests,
            occlusion_tests: sum.occlusion_tests + next.occlusion_tests,
            decisions: sum.decisions + next.decisions,
        })
    }
}
