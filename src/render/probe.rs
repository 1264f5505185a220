//! Onlookers: what the tracer does, seen from outside.

use std::iter::Sum;

use super::Errors;
use crate::math::{Decisions, Rgb};
use crate::surface::Hit;

/// The kinds of rays.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RayKind {
    /// From the eye.
    Camera,
    /// From a surface to a light.
    Shadow,
    /// From a surface to a point of a lamp.
    Lamp,
    /// Mirrored by a surface.
    Mirror,
    /// Straight through a surface.
    Transmitted,
}

/// Why a ray is not followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Unfollowed {
    /// The way from the eye is longer than the scene's `reach`.
    BeyondReach,
    /// It could add no more than this to its pixel, which the `cut-off` allows to lack.
    TooFaint(f64),
    /// Its ray from the eye has caused as many others as it may; it could have added this much.
    Capped(f64),
}

/// What arrives at a surface from a light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Arrival {
    /// The plan says that the light cannot light the surface.
    Unplanned,
    /// The light is behind the surface.
    Behind,
    /// The beam passes by.
    OutsideBeam,
    /// Something stands in the way.
    Hidden,
    /// This light; no ray was needed to know that nothing stands in the way if it is `unasked`.
    Light {
        /// What arrives.
        color: Rgb,
        /// Whether the plan says that nothing can stand in the way.
        unasked: bool,
    },
}

/// Someone who is told what the tracer does. `()` does not listen and costs nothing.
pub trait Probe {
    /// A ray sets out; of what it brings back, its surface passes this share on.
    fn ray(&mut self, _kind: RayKind, _share: Rgb) {}
    /// A ray does not set out.
    fn not_followed(&mut self, _kind: RayKind, _why: Unfollowed) {}
    /// The ray that set out last and has not come back yet meets the surface with this place in the
    /// list, and how far off that may be.
    fn met(&mut self, _surface: usize, _hit: &Hit, _errors: Errors) {}
    /// What one of the scene's lights adds where that ray has met a surface.
    fn light(&mut self, _light: usize, _arrival: Arrival) {}
    /// What the surface itself sends back to the eye: its ambient colour and that of all lights,
    /// faded.
    fn own_color(&mut self, _color: Rgb) {}
    /// That ray comes back with this colour, before its surface takes its share.
    fn came_back(&mut self, _color: Rgb) {}
    /// Surfaces that were asked whether a ray meets them.
    fn hit_tests(&mut self, _count: u64) {}
    /// Surfaces that were asked whether they hide one of the scene's lights, or of its lamps, which
    /// are counted on from them.
    fn occlusion_tests(&mut self, _light: usize, _count: u64) {}
    /// Surfaces that were asked whether they hide a point of a lamp.
    fn lamp_tests(&mut self, _count: u64) {}
    /// Texels, or sums of texels, that a filter looked up.
    fn texel_fetches(&mut self, _count: u64) {}
    /// What of that rounded values could not decide.
    fn decisions(&mut self, _decisions: Decisions) {}
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
    /// Rays that were not followed because they could add no more than the `cut-off` allows a pixel
    /// to lack.
    pub faint_rays: u64,
    /// Rays that were not followed because a ray from the eye may cause only so many.
    pub capped_rays: u64,
    /// Surfaces that were asked whether a ray meets them.
    pub hit_tests: u64,
    /// Surfaces that were asked whether they hide a light, or a point of a lamp.
    pub occlusion_tests: u64,
    /// Texels, or sums of texels, that filters looked up; `nearest` is none.
    pub texel_fetches: u64,
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

    /// The same counts times `of / pixels`, rounded: what so many pixels take if others are like
    /// these.
    #[must_use]
    pub fn scaled(mut self, of: u64, pixels: u64) -> Self {
        for count in self.each() {
            let scaled = u128::from(*count) * u128::from(of) + u128::from(pixels / 2);
            *count = u64::try_from(scaled / u128::from(pixels.max(1))).unwrap_or(u64::MAX);
        }
        self
    }

    fn each(&mut self) -> [&mut u64; 12] {
        let Self {
            camera_rays,
            shadow_rays,
            lamp_rays,
            mirror_rays,
            transmitted_rays,
            faint_rays,
            capped_rays,
            hit_tests,
            occlusion_tests,
            texel_fetches,
            decisions: Decisions { exactly, by_rule },
        } = self;
        [
            camera_rays,
            shadow_rays,
            lamp_rays,
            mirror_rays,
            transmitted_rays,
            faint_rays,
            capped_rays,
            hit_tests,
            occlusion_tests,
            texel_fetches,
            exactly,
            by_rule,
        ]
    }
}

impl Probe for Counts {
    fn ray(&mut self, kind: RayKind, _share: Rgb) {
        match kind {
            RayKind::Camera => self.camera_rays += 1,
            RayKind::Shadow => self.shadow_rays += 1,
            RayKind::Lamp => self.lamp_rays += 1,
            RayKind::Mirror => self.mirror_rays += 1,
            RayKind::Transmitted => self.transmitted_rays += 1,
        }
    }

    fn not_followed(&mut self, _kind: RayKind, why: Unfollowed) {
        match why {
            Unfollowed::Capped(_) => self.capped_rays += 1,
            Unfollowed::TooFaint(missed) if missed > 0.0 => self.faint_rays += 1,
            Unfollowed::TooFaint(_) | Unfollowed::BeyondReach => {}
        }
    }

    fn hit_tests(&mut self, count: u64) {
        self.hit_tests += count;
    }

    fn occlusion_tests(&mut self, _light: usize, count: u64) {
        self.occlusion_tests += count;
    }

    fn lamp_tests(&mut self, count: u64) {
        self.occlusion_tests += count;
    }

    fn texel_fetches(&mut self, count: u64) {
        self.texel_fetches += count;
    }

    fn decisions(&mut self, decisions: Decisions) {
        self.decisions = self.decisions + decisions;
    }
}

impl Sum for Counts {
    fn sum<I: Iterator<Item = Self>>(counts: I) -> Self {
        counts.fold(Self::default(), |mut sum, mut next| {
            for (sum, next) in sum.each().into_iter().zip(next.each()) {
                *sum += *next;
            }
            sum
        })
    }
}
