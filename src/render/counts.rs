//! How much work a picture took.

use std::iter::Sum;

use super::{Event, Probe, RayKind, Unfollowed};
use crate::math::Decisions;

/// How much work a picture took.
#[derive(Debug, Clone, Default, PartialEq, Eq, serde::Serialize)]
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
    /// The same for every light by itself, and after the lights for every lamp; the last ones are
    /// left out if nothing was asked for them.
    #[serde(skip)]
    pub occlusion_tests_of: Vec<u64>,
    /// What of that rounded values could not decide.
    pub decisions: Decisions,
    /// Texels that were fetched from images.
    pub texel_fetches: u64,
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

    /// Surfaces that were asked whether they hide a light, or a lamp, which are counted on from the
    /// lights.
    #[must_use]
    pub fn occlusion_tests_of(&self, light: usize) -> u64 {
        self.occlusion_tests_of.get(light).copied().unwrap_or(0)
    }

    /// Makes room for the lights up to this one.
    #[cold]
    fn reach_light(&mut self, light: usize) -> &mut u64 {
        let count = self.occlusion_tests_of.len().max(light + 1);
        self.occlusion_tests_of.resize(count, 0);
        &mut self.occlusion_tests_of[light]
    }

    fn each(&mut self) -> impl Iterator<Item = &mut u64> {
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
            occlusion_tests_of,
            decisions: Decisions { exactly, by_rule },
            texel_fetches,
        } = self;
        let alone = [
            camera_rays,
            shadow_rays,
            lamp_rays,
            mirror_rays,
            transmitted_rays,
            faint_rays,
            capped_rays,
            hit_tests,
            occlusion_tests,
            exactly,
            by_rule,
            texel_fetches,
        ];
        alone.into_iter().chain(occlusion_tests_of)
    }
}

impl Probe for Counts {
    #[inline(always)]
    fn on(&mut self, event: Event<'_>) {
        match event {
            Event::Ray(RayKind::Camera, _) => self.camera_rays += 1,
            Event::Ray(RayKind::Shadow, _) => self.shadow_rays += 1,
            Event::Ray(RayKind::Lamp, _) => self.lamp_rays += 1,
            Event::Ray(RayKind::Mirror, _) => self.mirror_rays += 1,
            Event::Ray(RayKind::Transmitted, _) => self.transmitted_rays += 1,
            Event::NotFollowed(_, Unfollowed::Capped(_)) => self.capped_rays += 1,
            Event::NotFollowed(_, Unfollowed::TooFaint(missed)) if missed > 0.0 => {
                self.faint_rays += 1;
            }
            Event::HitTests(count) => self.hit_tests += count,
            Event::OcclusionTests(light, count) => {
                self.occlusion_tests += count;
                match self.occlusion_tests_of.get_mut(light) {
                    Some(of_light) => *of_light += count,
                    None => *self.reach_light(light) += count,
                }
            }
            Event::Decisions(decisions) => self.decisions = self.decisions + decisions,
            Event::TexelFetches(count) => self.texel_fetches += count,
            Event::NotFollowed(..)
            | Event::Hit(..)
            | Event::Light(..)
            | Event::OwnColor { .. }
            | Event::OwnShare(_)
            | Event::Returned(_) => {}
        }
    }
}

impl Sum for Counts {
    fn sum<I: Iterator<Item = Self>>(counts: I) -> Self {
        counts.fold(Self::default(), |mut sum, mut next| {
            if let Some(last) = next.occlusion_tests_of.len().checked_sub(1) {
                sum.reach_light(last);
            }
            for (sum, next) in sum.each().zip(next.each()) {
                *sum += *next;
            }
            sum
        })
    }
}
