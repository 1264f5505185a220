//! Counts of the work that a picture took.

use std::iter::Sum;

use super::{Event, Probe, RayKind, Unfollowed};
use crate::math::Decisions;

/// Counts of the work that a picture took.
#[derive(Debug, Clone, Default, PartialEq, Eq, serde::Serialize)]
pub struct Counts {
    /// Camera rays.
    pub camera_rays: u64,
    /// Shadow rays to point lights.
    pub shadow_rays: u64,
    /// Shadow rays to points of lamps.
    pub lamp_rays: u64,
    /// Reflected rays.
    pub mirror_rays: u64,
    /// Rays through surfaces, straight on or refracted.
    pub transmitted_rays: u64,
    /// Rays that were not followed because their light is within the `cut-off`.
    pub faint_rays: u64,
    /// Rays that were not followed because of the limit of rays per camera ray.
    pub capped_rays: u64,
    /// Tests of a ray against a surface.
    pub hit_tests: u64,
    /// Tests of a shadow ray against an occluder.
    pub occlusion_tests: u64,
    /// The occlusion tests of each light, then of each lamp.
    ///
    /// Trailing zeros may be missing.
    #[serde(skip)]
    pub occlusion_tests_of: Vec<u64>,
    /// The tests that rounded values could not decide.
    pub decisions: Decisions,
    /// Texels that were fetched from images.
    pub texel_fetches: u64,
}

impl Counts {
    /// The number of all rays.
    #[must_use]
    pub fn rays(&self) -> u64 {
        self.camera_rays
            + self.shadow_rays
            + self.lamp_rays
            + self.mirror_rays
            + self.transmitted_rays
    }

    /// The counts times `of / pixels`, rounded.
    ///
    /// An estimate for `of` pixels from `pixels` of them.
    #[must_use]
    pub fn scaled(mut self, of: u64, pixels: u64) -> Self {
        for count in self.each() {
            let scaled = u128::from(*count) * u128::from(of) + u128::from(pixels / 2);
            *count = u64::try_from(scaled / u128::from(pixels.max(1))).unwrap_or(u64::MAX);
        }
        self
    }

    /// The occlusion tests of a light or a lamp; lamps are numbered after the lights.
    #[must_use]
    pub fn occlusion_tests_of(&self, light: usize) -> u64 {
        self.occlusion_tests_of.get(light).copied().unwrap_or(0)
    }

    /// The count of a light, after extending the list to it.
    #[cold]
    fn extend_to(&mut self, light: usize) -> &mut u64 {
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
        let single = [
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
        single.into_iter().chain(occlusion_tests_of)
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
                    None => *self.extend_to(light) += count,
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
                sum.extend_to(last);
            }
            for (sum, next) in sum.each().zip(next.each()) {
                *sum += *next;
            }
            sum
        })
    }
}
