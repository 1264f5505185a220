//! Probes: observers of the tracer's events.

use super::Errors;
use crate::geometry::Hit;
use crate::math::{Decisions, Rgb};

/// The type of a ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RayKind {
    /// From the camera.
    Camera,
    /// From a surface to a light.
    Shadow,
    /// From a surface to a point of a lamp.
    Lamp,
    /// Reflected by a surface.
    Mirror,
    /// Through a surface, straight on or refracted.
    Transmitted,
}

/// The reason for which a ray is not followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Unfollowed {
    /// The path from the camera is longer than the scene's `reach`.
    BeyondReach,
    /// It could add at most this to its pixel, which is within the `cut-off`.
    TooFaint(f64),
    /// Its camera ray has no rays left; it could have added this much.
    Capped(f64),
}

/// The light that arrives at a surface from a light or a lamp.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Arrival {
    /// None: the plan has proven that the light cannot light the surface.
    Unplanned,
    /// None: the light is at the hit point, so no direction leads to it.
    Here,
    /// None: the light, or all of the lamp, is behind the surface.
    Behind,
    /// None: the surface has no diffuse colour here for a lamp to light.
    Colorless,
    /// None: the point is outside of the light's beam.
    OutsideBeam,
    /// None: an occluder blocks it.
    Hidden,
    /// The light of a point light.
    Light {
        /// The colour that arrives.
        color: Rgb,
        /// True if it is proven that no occluder blocks it, so that no ray was sent.
        unasked: bool,
    },
    /// The light of a lamp.
    Lamp {
        /// The irradiance, shadows included: the light on a white diffuse surface.
        color: Rgb,
        /// The transmittance from the lamp.
        passed: Rgb,
    },
}

/// An event of the tracer.
///
/// Surfaces are numbered as in the scene's list. Lamps are numbered after the lights.
#[derive(Debug, Clone, Copy)]
pub enum Event<'e> {
    /// A ray starts; its surface passes on this share of its colour.
    Ray(RayKind, Rgb),
    /// A ray does not start.
    NotFollowed(RayKind, Unfollowed),
    /// The last ray that has not returned hits a surface, with these errors.
    Hit(usize, &'e Hit, Errors),
    /// Light arrives there from a light or a lamp.
    Light(usize, Arrival),
    /// The surface's own colour there, faded: ambient and lit.
    OwnColor {
        /// The whole colour.
        color: Rgb,
        /// The part of it that comes from lamps.
        of_lamps: Rgb,
    },
    /// The share of the own colour that counts; the rest is reflected or transmitted.
    OwnShare(f64),
    /// That ray returns with this colour.
    Returned(Rgb),
    /// The number of surfaces that were tested for hits.
    HitTests(u64),
    /// A light or a lamp, and the number of its occluders that were tested.
    OcclusionTests(usize, u64),
    /// Some tests were not decided by rounded values.
    Decisions(Decisions),
    /// The number of texels that were fetched from images.
    TexelFetches(u64),
}

/// An observer of the tracer; `()` ignores all events and costs nothing.
pub trait Probe {
    /// Observes an event.
    fn on(&mut self, event: Event<'_>);

    /// Returns whether the tracer computes the errors of hits, at a small cost.
    fn follows_errors(&self) -> bool {
        false
    }
}

impl Probe for () {
    fn on(&mut self, _event: Event<'_>) {}
}

impl<P: Probe + ?Sized> Probe for &mut P {
    #[inline(always)]
    fn on(&mut self, event: Event<'_>) {
        (**self).on(event);
    }

    fn follows_errors(&self) -> bool {
        (**self).follows_errors()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::{Both, Certificate, Counts};

    #[test]
    fn a_borrowed_probe_asks_for_the_same() {
        fn follows(probe: &mut impl Probe) -> bool {
            probe.follows_errors()
        }
        let (mut counts, mut certificate) = (Counts::default(), Certificate::default());
        assert!(!follows(&mut counts));
        assert!(!follows(&mut &mut counts));
        assert!(!follows(&mut Both(&mut counts, ())));
        assert!(follows(&mut certificate));
        assert!(follows(&mut Both(counts, certificate)));
    }
}
