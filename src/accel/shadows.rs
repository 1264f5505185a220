//! What stands in the way of a light.

use glam::DVec3;

use super::receivers::{Receiver, anything_on};
use super::{Entry, SurfaceList};
use crate::math::{Point, Rgb, Segment, Side, Support};

/// A scene's surfaces as one light has them before it.
#[derive(Debug)]
pub struct LightView<'a> {
    /// The surfaces that can cast a shadow, each with its side that the light is on.
    casters: Vec<(Entry<'a>, Side)>,
    /// For every surface of the list, whether the light is behind its plane or in it.
    unlit: Vec<bool>,
}

impl<'a> LightView<'a> {
    /// What lights at these places have before them.
    #[must_use]
    pub fn all(surfaces: &SurfaceList<'a>, lights: impl Iterator<Item = DVec3>) -> Vec<Self> {
        let receivers = Receiver::all(surfaces.entries());
        let view = |light| Self::new(surfaces, &receivers, light);
        lights.map(view).collect()
    }

    /// What a light at this place has before it.
    ///
    /// A plane can only stand between the light and what is strictly on its other side. If nothing
    /// is there, as behind the floor and the walls of a room, it is no caster.
    fn new(surfaces: &SurfaceList<'a>, receivers: &[Receiver], location: DVec3) -> Self {
        let casts = |entry: &Entry<'_>, side: Side| {
            let Some(flat) = entry.surface.flat() else {
                return true;
            };
            // A plane hides nothing from a light in it.
            side.opposite()
                .is_some_and(|other| anything_on(other, &flat, entry.support, receivers))
        };
        let location = Point::exact(location);
        let sides = surfaces
            .entries()
            .iter()
            .map(|entry| (*entry, entry.surface.side(&location)));
        let unlit = sides
            .clone()
            .map(|(entry, side)| entry.surface.flat().is_some() && side != Side::Front);
        Self {
            unlit: unlit.collect(),
            casters: sides
                .filter(|(entry, _)| entry.surface.common().shadows.cast)
                .filter(|(entry, side)| casts(entry, *side))
                .collect(),
        }
    }

    /// Whether light from here can reach the front of a surface at all.
    #[must_use]
    pub fn lights(&self, entry: &Entry<'_>) -> bool {
        !self.unlit[entry.index]
    }

    /// The share of the light's colour that passes along a segment to it.
    ///
    /// Opaque surfaces block it, transparent ones tint it, each once. Of surfaces on the same sheet
    /// the first in the file counts.
    #[must_use]
    pub fn transmittance(&self, segment: &Segment) -> Rgb {
        let mut passed = Rgb::WHITE;
        let mut crossed: Vec<Support> = Vec::new();
        let left = segment.ray.leaves();
        for (entry, side) in &self.casters {
            if entry.lies_on(left) || !entry.surface.occludes(segment, *side) {
                continue;
            }
            if entry
                .support
                .is_some_and(|support| crossed.contains(&support))
            {
                continue;
            }
            if entry.surface.common().material.transparency == 0.0 {
                return Rgb::BLACK;
            }
            crossed.extend(entry.support);
            if let Some(hit) = entry.surface.hits(&segment.ray, segment.span) {
                passed = passed * entry.surface.transmits(&hit);
            }
        }
        passed
    }
}
