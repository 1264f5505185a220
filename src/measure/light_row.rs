//! Surfaces that a light reaches, and those that can block it.

use serde::Serialize;

use super::scene_item::SceneItem;
use crate::accel::MOST_LISTS;
use crate::math::{Point, Side};
use crate::plan::{Cause, Plan, Unlit};
use crate::surface::Surface;

/// Surfaces that a light or lamp reaches, and those that can block it.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct LightRow {
    /// The light, or the lamp.
    pub(crate) light: SceneItem,
    /// True if it is a lamp.
    pub(crate) is_lamp: bool,
    /// Number of surfaces that it may light.
    pub(crate) lights: usize,
    /// The others by their places in the file, from 0, with the reason.
    pub(crate) unlit: Vec<(usize, Unlit)>,
    /// Surfaces that can cast a shadow, and on which; `None` if there are more than [`MOST_LISTS`]
    /// surfaces.
    pub(crate) casters: Option<Vec<(usize, Vec<usize>)>>,
    /// Surfaces that cast none, with the reason; `None` likewise.
    pub(crate) casts_nothing: Option<Vec<(usize, NoShadow)>>,
}

/// Reason why a surface casts no shadow in a light.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum NoShadow {
    /// The scene says so.
    Told,
    /// All surfaces that the light reaches are on the light's side of it.
    NothingBehind,
    /// Its shadow falls beside all surfaces that the light reaches.
    FallsBeside,
}

impl LightRow {
    /// Rows of all lights in file order, then of all lamps.
    pub(super) fn all(plan: &Plan<'_>) -> Vec<Self> {
        let lights = (0..plan.light_views.len()).map(|light| Self::of_light(plan, light));
        let lamps = (0..plan.lamp_views.len()).map(|lamp| Self::of_lamp(plan, lamp));
        lights.chain(lamps).collect()
    }

    fn of_light(plan: &Plan<'_>, number: usize) -> Self {
        let (light, view) = (&plan.scene.lights[number], &plan.light_views[number]);
        let place = Point::exact(light.location);
        let mut row = Self::new(plan, &Cause::of_light(light), &plan.unlit[number]);
        row.tell_casters(
            plan,
            |receiver| view.casters_of(receiver),
            |caster| Some(plan.scene.surfaces[caster].side(&place)),
        );
        row
    }

    fn of_lamp(plan: &Plan<'_>, number: usize) -> Self {
        let view = &plan.lamp_views[number];
        let unlit = &plan.unlit_by_lamp[number];
        let mut row = Self::new(plan, &Cause::of_surface(view.lamp), unlit);
        row.is_lamp = true;
        row.tell_casters(
            plan,
            |receiver| view.casters_of(receiver),
            |caster| view.side_of(caster),
        );
        // That a lamp does not hide itself needs no mention.
        let is_other = |index: usize| {
            let lamp = plan.scene.surfaces[index].lamp();
            !lamp.is_some_and(|lamp| std::ptr::eq(lamp, view.lamp))
        };
        if let Some(casts_nothing) = &mut row.casts_nothing {
            casts_nothing.retain(|(index, _)| is_other(*index));
        }
        row
    }

    fn new(plan: &Plan<'_>, cause: &Cause, unlit: &[Option<Unlit>]) -> Self {
        let reasons = unlit.iter().enumerate();
        Self {
            light: SceneItem::of(cause, &plan.scene.sources),
            is_lamp: false,
            lights: unlit.iter().filter(|why| why.is_none()).count(),
            unlit: reasons
                .filter_map(|(surface, why)| Some((surface, (*why)?)))
                .collect(),
            casters: None,
            casts_nothing: None,
        }
    }

    /// Adds the surfaces that can cast a shadow and those that cannot, unless there are too many;
    /// `side_of` is the side of a surface that the light is on, if all of it is on one.
    fn tell_casters(
        &mut self,
        plan: &Plan<'_>,
        casters_of: impl Fn(usize) -> Vec<usize>,
        side_of: impl Fn(usize) -> Option<Side>,
    ) {
        let surfaces = &plan.scene.surfaces;
        if surfaces.len() > MOST_LISTS {
            return;
        }
        let mut onto = vec![Vec::new(); surfaces.len()];
        for (receiver, surface) in surfaces.iter().enumerate() {
            if !surface.common().shadows.receive {
                continue;
            }
            for caster in casters_of(receiver) {
                onto[caster].push(receiver);
            }
        }
        let (mut casters, mut casts_nothing) = (Vec::new(), Vec::new());
        for (caster, onto) in onto.into_iter().enumerate() {
            if onto.is_empty() {
                casts_nothing.push((caster, self.no_shadow(surfaces, caster, side_of(caster))));
            } else {
                casters.push((caster, onto));
            }
        }
        (self.casters, self.casts_nothing) = (Some(casters), Some(casts_nothing));
    }

    /// Reason why a surface casts no shadow.
    fn no_shadow(
        &self,
        surfaces: &[Box<dyn Surface>],
        caster: usize,
        side: Option<Side>,
    ) -> NoShadow {
        let surface = &surfaces[caster];
        if !surface.common().shadows.cast {
            return NoShadow::Told;
        }
        let (Some(flat), Some(side)) = (surface.flat(), side) else {
            return NoShadow::FallsBeside;
        };
        let behind = side.opposite();
        let is_behind = |other: &dyn Surface| match other.hull() {
            Some(hull) => hull
                .iter()
                .any(|point| Some(Side::of(flat.exact_height(point).sign())) == behind),
            None => true,
        };
        let is_lit = |index: &usize| !self.unlit.iter().any(|(unlit, _)| unlit == index);
        let mut lit = (0..surfaces.len()).filter(|index| *index != caster && is_lit(index));
        if lit.any(|index| is_behind(&*surfaces[index])) {
            NoShadow::FallsBeside
        } else {
            NoShadow::NothingBehind
        }
    }
}
