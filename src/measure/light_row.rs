//! Surfaces that a light reaches, and those that can block it.

use serde::Serialize;

use super::scene_item::SceneItem;
use crate::math::Side;
use crate::plan::{Cause, Plan, PlannedLight, Unlit};
use crate::surface::Surface;
use crate::visibility::MOST_LISTS;

/// Surfaces that a light or lamp reaches, and those that can block it.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct LightRow {
    pub(crate) light: SceneItem,
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
        let lights = plan.scene.lights.iter().map(Cause::of_light);
        let lights = lights.zip(&plan.lights);
        let lights = lights.map(|(cause, planned)| Self::new(plan, planned, &cause));
        let lamps = plan.lamps.iter().filter_map(|planned| {
            let cause = Cause::of_surface(planned.view.lamp()?);
            Some(Self::new(plan, planned, &cause))
        });
        lights.chain(lamps).collect()
    }

    fn new(plan: &Plan<'_>, planned: &PlannedLight<'_>, cause: &Cause) -> Self {
        let reasons = planned.unlit.iter().enumerate();
        let unlit = reasons.filter_map(|(surface, why)| Some((surface, (*why)?)));
        let (casters, casts_nothing) = casters(plan, planned).unzip();
        Self {
            light: SceneItem::of(cause, &plan.scene.sources),
            is_lamp: planned.view.lamp().is_some(),
            lights: planned.unlit.iter().filter(|why| why.is_none()).count(),
            unlit: unlit.collect(),
            casters,
            casts_nothing,
        }
    }
}

/// Surfaces by their places in the file that can cast a shadow, and those that cannot.
type Casters = (Vec<(usize, Vec<usize>)>, Vec<(usize, NoShadow)>);

/// The surfaces that can cast a shadow in a light and those that cannot; `None` if there are more
/// than [`MOST_LISTS`].
fn casters(plan: &Plan<'_>, planned: &PlannedLight<'_>) -> Option<Casters> {
    let surfaces = &plan.scene.surfaces;
    if surfaces.len() > MOST_LISTS {
        return None;
    }
    let mut onto = vec![Vec::new(); surfaces.len()];
    for (receiver, surface) in surfaces.iter().enumerate() {
        if surface.common().shadows.receive {
            for caster in planned.view.occluders_of(receiver) {
                onto[caster].push(receiver);
            }
        }
    }
    let is_own = |surface: &dyn Surface| match (surface.lamp(), planned.view.lamp()) {
        (Some(one), Some(other)) => std::ptr::eq(one, other),
        _ => false,
    };
    let (mut casters, mut others) = (Vec::new(), Vec::new());
    for (caster, onto) in onto.into_iter().enumerate() {
        if !onto.is_empty() {
            casters.push((caster, onto));
        } else if !is_own(&*surfaces[caster]) {
            others.push((caster, no_shadow(surfaces, planned, caster)));
        }
    }
    Some((casters, others))
}

/// Reason why a surface casts no shadow in a light.
fn no_shadow(surfaces: &[Box<dyn Surface>], planned: &PlannedLight<'_>, caster: usize) -> NoShadow {
    let surface = &surfaces[caster];
    if !surface.common().shadows.cast {
        return NoShadow::Told;
    }
    let carrier = surface.shape().carrier();
    let (Some(plane), Some(side)) = (carrier, planned.view.side_of(caster)) else {
        return NoShadow::FallsBeside;
    };
    let is_behind = |other: &dyn Surface| match other.shape().hull() {
        Some(hull) => hull
            .iter()
            .any(|point| Some(Side::of(plane.exact_height(point).sign())) == side.opposite()),
        None => true,
    };
    let numbered = surfaces.iter().zip(&planned.unlit).enumerate();
    let mut lit = numbered.filter(|(index, (_, unlit))| *index != caster && unlit.is_none());
    if lit.any(|(_, (surface, _))| is_behind(&**surface)) {
        NoShadow::FallsBeside
    } else {
        NoShadow::NothingBehind
    }
}
