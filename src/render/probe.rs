//! Onlookers: what the tracer does, seen from outside.

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
    /// Through a surface, straight on or bent.
    Transmitted,
}

/// Why a ray is not followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Unfollowed {
    /// The way from the eye is longer than the scene's `reach`.
    BeyondReach,
    /// It could add no more than this to its pixel, and so much may be missing by the `cut-off`.
    TooFaint(f64),
    /// Its ray from the eye has caused as many others as it may; it could have added this much.
    Capped(f64),
}

/// What arrives at a surface from a light or a lamp.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Arrival {
    /// The plan says that the light cannot light the surface.
    Unplanned,
    /// The light is in the very place that is lit, so that no direction leads to it.
    Here,
    /// The light, or all of the lamp, is behind the surface.
    Behind,
    /// The surface has no colour here that answers to a lamp.
    Colorless,
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
    /// This of a lamp; without a ray if all of it is known to pass, or nothing.
    Lamp {
        /// What arrives, shadows included: by how much it lights white chalk.
        color: Rgb,
        /// The share of the lamp's light that passes what stands in its way.
        passed: Rgb,
    },
}

/// Someone who is told what the tracer does. `()` does not listen and costs nothing.
pub trait Probe {
    /// A ray sets out; of what it brings back, its surface passes this share on.
    fn ray(&mut self, _kind: RayKind, _share: Rgb) {}
    /// A ray does not set out.
    fn not_followed(&mut self, _kind: RayKind, _why: Unfollowed) {}
    /// Whether it has to be told how far off hits may be; it costs a little to know.
    fn follows_errors(&self) -> bool {
        false
    }
    /// Whether all that it hears are counts; then many rays may be told of at once.
    fn only_counts(&self) -> bool {
        false
    }
    /// The ray that set out last and has not come back yet meets the surface with this place in the
    /// list, and how far off that may be.
    fn met(&mut self, _surface: usize, _hit: &Hit, _errors: Errors) {}
    /// What arrives where that ray has met a surface from one of the scene's lights, or of its lamps,
    /// which are counted on from the lights.
    fn light(&mut self, _light: usize, _arrival: Arrival) {}
    /// What the surface itself sends back to the eye, faded: its ambient colour, and that of all
    /// lights and lamps; and what of it the lamps give, or the lamp that the surface is.
    fn own_color(&mut self, _color: Rgb, _of_lamps: Rgb) {}
    /// Only this share of that counts, since the surface mirrors the rest of the light or lets it
    /// through.
    fn own_share(&mut self, _share: f64) {}
    /// That ray comes back with this colour, before its surface takes its share.
    fn came_back(&mut self, _color: Rgb) {}
    /// Surfaces that were asked whether a ray meets them.
    fn hit_tests(&mut self, _count: u64) {}
    /// Surfaces that were asked whether they hide one of the scene's lights, or a point of one of its
    /// lamps, which are counted on from the lights.
    fn occlusion_tests(&mut self, _light: usize, _count: u64) {}
    /// What of that rounded values could not decide.
    fn decisions(&mut self, _decisions: Decisions) {}
    /// Texels that were fetched from images, for surfaces that are seen, panes that tint a light, and
    /// slides.
    fn texel_fetches(&mut self, _count: u64) {}
}

impl Probe for () {
    fn only_counts(&self) -> bool {
        true
    }
}

/// An onlooker that somebody else keeps.
impl<P: Probe + ?Sized> Probe for &mut P {
    fn ray(&mut self, kind: RayKind, share: Rgb) {
        (**self).ray(kind, share);
    }

    fn not_followed(&mut self, kind: RayKind, why: Unfollowed) {
        (**self).not_followed(kind, why);
    }

    fn follows_errors(&self) -> bool {
        (**self).follows_errors()
    }

    fn only_counts(&self) -> bool {
        (**self).only_counts()
    }

    fn met(&mut self, surface: usize, hit: &Hit, errors: Errors) {
        (**self).met(surface, hit, errors);
    }

    fn light(&mut self, light: usize, arrival: Arrival) {
        (**self).light(light, arrival);
    }

    fn own_color(&mut self, color: Rgb, of_lamps: Rgb) {
        (**self).own_color(color, of_lamps);
    }

    fn own_share(&mut self, share: f64) {
        (**self).own_share(share);
    }

    fn came_back(&mut self, color: Rgb) {
        (**self).came_back(color);
    }

    fn hit_tests(&mut self, count: u64) {
        (**self).hit_tests(count);
    }

    fn occlusion_tests(&mut self, light: usize, count: u64) {
        (**self).occlusion_tests(light, count);
    }

    fn decisions(&mut self, decisions: Decisions) {
        (**self).decisions(decisions);
    }

    fn texel_fetches(&mut self, count: u64) {
        (**self).texel_fetches(count);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::{Both, Certificate, Counts};

    #[test]
    fn what_an_onlooker_asks_for_does_not_depend_on_who_keeps_it() {
        /// As the tracer asks, of what somebody lends it.
        fn asks_for(probe: &mut impl Probe) -> [bool; 2] {
            [probe.only_counts(), probe.follows_errors()]
        }
        let (mut counts, mut certificate) = (Counts::default(), Certificate::default());
        assert_eq!(asks_for(&mut counts), [true, false]);
        assert_eq!(asks_for(&mut &mut counts), [true, false]);
        assert_eq!(asks_for(&mut Both(&mut counts, ())), [true, false]);
        assert_eq!(asks_for(&mut certificate), [false, true]);
        assert_eq!(asks_for(&mut Both(counts, certificate)), [false, true]);
    }
}
