//! How much asking each light takes.

use serde::Serialize;

use super::Thing;
use crate::plan::Cause;
use crate::render::Counts;
use crate::scene::Scene;

/// How many surfaces were asked because of one light or lamp.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LightTests {
    /// The light, or the lamp.
    pub light: Thing,
    /// Surfaces that were asked whether they hide it, or a point of it.
    pub occlusion_tests: u64,
}

impl LightTests {
    /// Those of all lights of a scene in file order, and after them of all its lamps.
    #[must_use]
    pub fn all(scene: &Scene, counts: &Counts) -> Vec<Self> {
        let lights = scene.lights.iter().map(Cause::of_light);
        let lamps = scene.surfaces.iter().filter(|it| it.lamp().is_some());
        let all = lights.chain(lamps.map(|lamp| Cause::of_surface(&**lamp)));
        all.enumerate()
            .map(|(number, cause)| Self {
                light: Thing::of(&cause, &scene.sources),
                occlusion_tests: counts.occlusion_tests_of(number),
            })
            .collect()
    }
}
