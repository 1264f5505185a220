//! Onlookers: what the tracer does, seen from outside.

use std::iter::Sum;

/// Someone who is told what the tracer does. `()` does not listen and costs nothing.
pub trait Probe {
    /// A ray from the eye.
    fn camera_ray(&mut self) {}
    /// A ray from a surface to a light.
    fn shadow_ray(&mut self) {}
    /// A ray mirrored by a surface.
    fn mirror_ray(&mut self) {}
    /// A ray straight through a surface.
    fn transmitted_ray(&mut self) {}
}

impl Probe for () {}

/// How much work a picture took.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, serde::Serialize)]
pub struct Counts {
    /// Rays from the eye.
    pub camera_rays: u64,
    /// Rays to lights.
    pub shadow_rays: u64,
    /// Rays from mirrors.
    pub mirror_rays: u64,
    /// Rays through surfaces.
    pub transmitted_rays: u64,
}

impl Counts {
    /// All rays.
    #[must_use]
    pub fn rays(&self) -> u64 {
        self.camera_rays + self.shadow_rays + self.mirror_rays + self.transmitted_rays
    }
}

impl Probe for Counts {
    fn camera_ray(&mut self) {
        self.camera_rays += 1;
    }

    fn shadow_ray(&mut self) {
        self.shadow_rays += 1;
    }

    fn mirror_ray(&mut self) {
        self.mirror_rays += 1;
    }

    fn transmitted_ray(&mut self) {
        self.transmitted_rays += 1;
    }
}

impl Sum for Counts {
    fn sum<I: Iterator<Item = Self>>(counts: I) -> Self {
        counts.fold(Self::default(), |sum, next| Self {
            camera_rays: sum.camera_rays + next.camera_rays,
            shadow_rays: sum.shadow_rays + next.shadow_rays,
            mirror_rays: sum.mirror_rays + next.mirror_rays,
            transmitted_rays: sum.transmitted_rays + next.transmitted_rays,
        })
    }
}
