//! What a light lights, and what stands in its way.

use serde::Serialize;

use super::Thing;
use crate::math::Side;
use crate::plan::{Cause, Plan, PlannedLight, Unlit};
use crate::surface::Surface;
use crate::visibility::MOST_LISTS;

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
        let lights = plan.scene.lights.iter().zip(&plan.lights);
        let lights =
            lights.map(|(light, planned)| Self::new(plan, planned, &Cause::of_light(light)));
        let lamps = plan.lamps.iter().filter_map(|planned| {
            let lamp = planned.view.lamp()?;
            let mut row = Self::new(plan, planned, &Cause::of_surface(lamp));
            row.is_lamp = true;
            // That a lamp does not hide itself need not be told.
            let is_other = |index: usize| {
                let other = plan.scene.surfaces[index].lamp();
                !other.is_some_and(|other| std::ptr::eq(other, lamp))
            };
            if let Some(casts_nothing) = &mut row.casts_nothing {
                casts_nothing.retain(|(index, _)| is_other(*index));
            }
            Some(row)
        });
        lights.chain(lamps).collect()
    }

    fn new(plan: &Plan<'_>, planned: &PlannedLight<'_>, cause: &Cause) -> Self {
        let reasons = planned.unlit.iter().enumerate();
        let mut row = Self {
            light: Thing::of(cause, &plan.scene.sources),
            is_lamp: false,
            lights: planned.unlit.iter().filter(|why| why.is_none()).count(),
            unlit: reasons
                .filter_map(|(surface, why)| Some((surface, (*why)?)))
                .collect(),
            casters: None,
            casts_nothing: None,
        };
        row.tell_casters(plan, planned);
        row
    }

    /// Adds what can cast a shadow and what cannot, if that was worked out.
    fn tell_casters(&mut self, plan: &Plan<'_>, planned: &PlannedLight<'_>) {
        let view = &planned.view;
        let surfaces = &plan.scene.surfaces;
        if surfaces.len() > MOST_LISTS {
            return;
        }
        let mut onto = vec![Vec::new(); surfaces.len()];
        for (receiver, surface) in surfaces.iter().enumerate() {
            if !surface.common().shadows.receive {
                continue;
            }
            for caster in view.occluders_of(receiver) {
                onto[caster].push(receiver);
            }
        }
        let (mut casters, mut casts_nothing) = (Vec::new(), Vec::new());
        for (caster, onto) in onto.into_iter().enumerate() {
            if onto.is_empty() {
                casts_nothing.push((
                    caster,
                    self.no_shadow(surfaces, caster, view.side_of(caster)),
                ));
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
        let (Some(flat), Some(side)) = (surface.shape().carrier(), side) else {
            return NoShadow::FallsBeside;
        };
        let behind = side.opposite();
        let is_behind = |other: &dyn Surface| match other.shape().hull() {
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
