//! What a light lights, and what stands in its way.

use serde::Serialize;

use super::Thing;
use crate::accel::MOST_LISTS;
use crate::math::{Point, Side};
use crate::plan::{Cause, Plan, Unlit};
use crate::surface::Surface;

/// What a light or a lamp does.
#[derive(Debug, Clone, Serialize)]
pub struct LightRow {
    /// The light, or the lamp.
    pub light: Thing,
    /// Whether it is a lamp.
    pub is_lamp: bool,
    /// How many surfaces it may light.
    pub lights: usize,
    /// The others, by their places in the file, from 0, and why not.
    pub unlit: Vec<(usize, Unlit)>,
    /// What can cast a shadow, and on which of the surfaces; `None` if there are more than
    /// [`MOST_LISTS`], so that it is not worked out.
    pub casters: Option<Vec<(usize, Vec<usize>)>>,
    /// What casts none, and why; `None` as before.
    pub casts_nothing: Option<Vec<(usize, NoShadow)>>,
}

/// Why a surface casts no shadow in the light of a light.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum NoShadow {
    /// The scene says so.
    Told,
    /// All that the light lights is on the light's own side of it.
    NothingBehind,
    /// Its shadow falls beside all that the light lights.
    FallsBeside,
}

impl LightRow {
    /// The rows of all lights of a scene in file order, and after them of all its lamps.
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
        // That a lamp does not hide itself need not be told.
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
            light: Thing::of(cause, &plan.scene.sources),
            is_lamp: false,
            lights: unlit.iter().filter(|why| why.is_none()).count(),
            unlit: reasons
                .filter_map(|(surface, why)| Some((surface, (*why)?)))
                .collect(),
            casters: None,
            casts_nothing: None,
        }
    }

    /// Adds what can cast a shadow and what cannot, if that was worked out; `side_of` is the side of a surface that the light
    /// is on, if all of it is on one.
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

    /// Why a surface casts no shadow, if it does not.
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
