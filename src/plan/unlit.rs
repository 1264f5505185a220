//! Reasons for which the light of a light never arrives at a surface.

use serde::Serialize;

use super::beam;
use crate::light::{Beam, Light};
use crate::math::{Point, Side};
use crate::surface::{Lamp, Surface};
use crate::visibility::Silhouette;

/// The reason for which a light never arrives at a surface.
///
/// No shadow ray is traced then.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Unlit {
    /// The light, or all of the lamp, is behind the surface's plane or in it.
    Behind,
    /// The light has no emissivity.
    Dark,
    /// The surface has neither a diffuse colour nor specular highlights.
    Colorless,
    /// The surface lets all light through.
    Clear,
    /// The surface is outside of the light's cone or slide, or behind the lamp.
    OutsideBeam,
    /// No ray can hit the surface.
    Unseen,
}

impl Unlit {
    /// The reason that keeps a point light from a surface; `None` if it may arrive.
    ///
    /// `is_reached` is true if any ray can hit the surface. Unless `saves`, only rules that define
    /// the picture count, and shortcuts do not.
    pub(super) fn by_light(
        light: &Light,
        surface: &dyn Surface,
        is_reached: bool,
        saves: bool,
    ) -> Option<Self> {
        let shape = surface.shape();
        let location = Point::exact(light.location);
        // A rule, because for a light in the plane rounding could decide otherwise.
        if shape.carrier().is_some() && shape.side(&location) != Side::Front {
            return Some(Self::Behind);
        }
        let misses = || match (&light.beam, shape.bounds()) {
            (Beam::Everywhere, _) | (_, None) => false,
            (Beam::Cone(cone), Some(bounds)) => beam::cone_misses(light.location, cone, &bounds),
            (Beam::Slide(slide), Some(bounds)) => {
                beam::slide_misses(light.location, &slide.rectangle, &bounds)
            }
        };
        match Self::by_itself(surface) {
            _ if !saves => None,
            _ if light.emissivity.is_black() => Some(Self::Dark),
            Some(own) => Some(own),
            None if !is_reached => Some(Self::Unseen),
            None if misses() => Some(Self::OutsideBeam),
            None => None,
        }
    }

    /// The reason that keeps a lamp from a surface, as [`by_light`](Self::by_light).
    ///
    /// Both are given with their silhouettes.
    pub(super) fn by_lamp(
        (lamp, emitter): (&Lamp, &Silhouette),
        (surface, receiver): (&dyn Surface, &Silhouette),
        is_reached: bool,
        saves: bool,
    ) -> Option<Self> {
        let [_, diffuse] = surface.brightest();
        match () {
            () if !emitter.is_in_front_of(receiver) => Some(Self::Behind),
            () if !receiver.is_in_front_of(emitter) => Some(Self::OutsideBeam),
            () if !saves => None,
            () if lamp.emissivity().is_black() => Some(Self::Dark),
            // Lamps make no specular highlights.
            () if diffuse <= 0.0 => Some(Self::Colorless),
            () if surface.common().material.transparency == 1.0 => Some(Self::Clear),
            () if !is_reached => Some(Self::Unseen),
            () => None,
        }
    }

    /// The reason for which no point light is visible on a surface.
    #[must_use]
    pub fn by_itself(surface: &dyn Surface) -> Option<Self> {
        let [_, diffuse] = surface.brightest();
        let material = &surface.common().material;
        match () {
            () if diffuse <= 0.0 && !material.has_highlights() => Some(Self::Colorless),
            () if material.transparency == 1.0 => Some(Self::Clear),
            () => None,
        }
    }
}
