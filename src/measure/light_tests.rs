//! Occlusion tests of each light.

use serde::Serialize;

use super::scene_item::SceneItem;
use crate::plan::Cause;
use crate::render::Counts;
use crate::scene::Scene;

/// Occlusion tests of a light or lamp.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct LightTests {
    /// The light, or the lamp.
    pub(crate) light: SceneItem,
    /// Surfaces tested for hiding it, or a point of it.
    pub(crate) occlusion_tests: u64,
}

impl LightTests {
    /// Tests of all lights in file order, then of all lamps.
    pub(crate) fn all(scene: &Scene, counts: &Counts) -> Vec<Self> {
        let lights = scene.lights.iter().map(Cause::of_light);
        let lamps = scene.surfaces.iter().filter(|it| it.lamp().is_some());
        let all = lights.chain(lamps.map(|lamp| Cause::of_surface(&**lamp)));
        all.enumerate()
            .map(|(number, cause)| Self {
                light: SceneItem::of(&cause, &scene.sources),
                occlusion_tests: counts.occlusion_tests_of(number),
            })
            .collect()
    }
}
