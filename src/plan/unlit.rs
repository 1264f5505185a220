//! Why the light of a light never arrives at a surface.

use serde::Serialize;

use super::{Reachability, beam};
use crate::accel::{Entry, LampView};
use crate::light::{Beam, Light};
use crate::math::{Point, Side};
use crate::scene::Scene;
use crate::surface::Surface;

/// Why the light of a light never arrives at a surface, so that no ray asks for it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Unlit {
    /// The light, or all of the lamp, is behind the surface's plane or in it.
    Behind,
    /// The light has no emissivity.
    Dark,
    /// The surface has neither a diffuse colour nor glints.
    Colorless,
    /// The surface lets all light through.
    Clear,
    /// The surface is outside of the light's cone or slide, or not before the lamp.
    OutsideBeam,
    /// Nobody sees the surface.
    Unseen,
}

impl Unlit {
    /// What keeps each light from each surface. Unless savings are wanted, only the rules of the
    /// picture are named.
    pub(super) fn by_lights(
        scene: &Scene,
        seen: &[Reachability],
        saves: bool,
    ) -> Vec<Vec<Option<Self>>> {
        let of_light = |light| {
            let surfaces = scene.surfaces.iter().zip(seen);
            surfaces
                .map(|(surface, seen)| Self::reason(light, &**surface, seen.is_seen()))
                .map(|why| why.filter(|why| saves || why.is_rule()))
                .collect()
        };
        scene.lights.iter().map(of_light).collect()
    }

    /// What keeps each lamp from each surface, as [`by_lights`](Self::by_lights).
    pub(super) fn by_lamps(
        views: &[LampView<'_>],
        entries: &[Entry<'_>],
        seen: &[Reachability],
        saves: bool,
    ) -> Vec<Vec<Option<Self>>> {
        let of_lamp = |view| {
            let surfaces = entries.iter().zip(seen);
            surfaces
                .map(|(entry, seen)| Self::by_lamp(view, entry, seen.is_seen()))
                .map(|why| why.filter(|why| saves || why.is_rule()))
                .collect()
        };
        views.iter().map(of_lamp).collect()
    }

    /// The reason that keeps a light from a surface; `None` if it may light it. `is_seen` tells
    /// whether any ray can meet the surface.
    fn reason(light: &Light, surface: &dyn Surface, is_seen: bool) -> Option<Self> {
        if Self::is_behind(light, surface) {
            return Some(Self::Behind);
        }
        let passes_by = || match (&light.beam, surface.bounds()) {
            (Beam::Everywhere, _) | (_, None) => false,
            (Beam::Cone(cone), Some(bounds)) => beam::cone_passes_by(light.location, cone, &bounds),
            (Beam::Slide(slide), Some(bounds)) => {
                beam::slide_passes_by(light.location, &slide.rectangle, &bounds)
            }
        };
        match Self::by_itself(surface) {
            _ if light.emissivity.is_black() => Some(Self::Dark),
            Some(own) => Some(own),
            None if !is_seen => Some(Self::Unseen),
            None if passes_by() => Some(Self::OutsideBeam),
            None => None,
        }
    }

    /// The reason that keeps the light of all lights from a surface: nothing could be seen of it.
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

    /// The reason that keeps the light of a lamp from a surface, as [`reason`](Self::reason).
    fn by_lamp(view: &LampView<'_>, entry: &Entry<'_>, is_seen: bool) -> Option<Self> {
        let surface = entry.surface;
        let [_, diffuse] = surface.brightest();
        // Lamps make no glints.
        let answers = diffuse > 0.0;
        match () {
            () if !view.lights(entry) && view.is_before(surface) => Some(Self::OutsideBeam),
            () if !view.lights(entry) => Some(Self::Behind),
            () if view.lamp.emissivity().is_black() => Some(Self::Dark),
            () if !answers => Some(Self::Colorless),
            () if entry.common.material.transparency == 1.0 => Some(Self::Clear),
            () if !is_seen => Some(Self::Unseen),
            () => None,
        }
    }

    /// Whether this is a rule of the picture, not only a saving.
    fn is_rule(self) -> bool {
        self == Self::Behind
    }

    /// Whether a light is not before a flat surface: a rule of the picture, not only a saving, since
    /// for a light in the plane itself rounding could say otherwise.
    fn is_behind(light: &Light, surface: &dyn Surface) -> bool {
        surface.flat().is_some() && surface.side(&Point::exact(light.location)) != Side::Front
    }
}
