//! The plan of a scene: the effects that are simulated, with reasons.

mod beam;
mod decide;
mod effect;
mod outlines;
mod reachability;
mod scope;
mod tail;
mod unlit;

pub use effect::{Cause, Decision, Effect};
pub use outlines::{OutlineDepths, Outlines};
pub use reachability::Reachability;
pub use scope::Scope;
pub use tail::Tail;
pub use unlit::Unlit;

use std::sync::Arc;

use crate::camera::Camera;
use crate::language::ValueError;
use crate::math::Numerics;
use crate::scene::{RenderSettings, Scene};
use crate::surface::Surface;
use crate::texture::Filter;
use crate::visibility::{Accelerator, Emitter, LightView, ScreenBounds, Silhouettes, SurfaceList};

/// A scene prepared for tracing, with all decisions about its effects.
#[derive(Debug)]
pub struct Plan<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The camera.
    pub camera: Camera,
    /// The surfaces that rays can hit.
    pub surfaces: SurfaceList<'a>,
    /// The screen bounds of surfaces.
    ///
    /// `None` if every surface is tested for every camera ray, or if a tree finds them.
    pub screen_bounds: Option<ScreenBounds<'a>>,
    /// The reachability of each surface.
    pub reachability: Vec<Reachability>,
    /// The lights, in the order of the scene.
    pub lights: Vec<PlannedLight<'a>>,
    /// The lamps, in the order of the scene's surfaces.
    pub lamps: Vec<PlannedLight<'a>>,
    /// The outlines of surfaces in the picture; `None` without adaptive sampling.
    pub outlines: Option<Outlines>,
    /// A bound of the light that a ray can add.
    pub tail: Tail,
    /// The texture filter; `None` if footprints are not needed.
    pub filter: Option<Filter>,
    /// The scope of the simulation.
    pub scope: Scope,
}

/// A light or a lamp, with the surfaces that it lights.
#[derive(Debug)]
pub struct PlannedLight<'a> {
    /// Its receivers and occluders.
    pub view: LightView<'a>,
    /// The reason for which each surface gets no light; `None` if it may get some.
    pub unlit: Vec<Option<Unlit>>,
}

impl<'a> Plan<'a> {
    /// A plan for this scene.
    ///
    /// # Errors
    /// Returns an error for a camera that cannot exist.
    pub fn new(scene: &'a Scene, scope: Scope) -> Result<Self, ValueError> {
        let accelerator = match scope {
            Scope::CalledFor => Accelerator::for_count(scene.surfaces.len()),
            Scope::Everything => Accelerator::List,
        };
        Self::with(scene, scope, accelerator)
    }

    /// A plan with this accelerator; classic numerics always use a list.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with(
        scene: &'a Scene,
        scope: Scope,
        accelerator: Accelerator,
    ) -> Result<Self, ValueError> {
        let settings = &scene.settings;
        let camera = scene.view.camera(settings.width, settings.height)?;
        let surfaces = match settings.numerics {
            Numerics::Robust => SurfaceList::with(&scene.surfaces, accelerator),
            numerics => SurfaceList::classic(&scene.surfaces, numerics),
        };
        // Rounded values have no proven bounds, so they permit no shortcuts.
        let saves = scope == Scope::CalledFor && settings.numerics == Numerics::Robust;
        let screen_bounds = saves.then(|| ScreenBounds::new(&surfaces, &camera));
        let reachability = Reachability::all(scene, screen_bounds.as_ref(), &camera);
        let is_open = camera.screen().is_none();
        let (lights, lamps) = planned_lights(scene, &surfaces, &reachability, is_open, saves);
        let all_tested = surfaces.accelerator() == Accelerator::List;
        Ok(Self {
            scene,
            outlines: outlines(scene, &camera),
            camera,
            surfaces,
            screen_bounds: screen_bounds.filter(|_| all_tested),
            reachability,
            lights,
            lamps,
            tail: Tail::new(scene),
            filter: filter(scene, scope),
            scope,
        })
    }

    /// Returns whether there is neither a light nor a lamp.
    #[must_use]
    #[inline]
    pub fn is_unlit(&self) -> bool {
        self.lights.is_empty() && self.lamps.is_empty()
    }

    /// The decision about each effect, with its reason.
    #[must_use]
    pub fn decisions(&self) -> Vec<Decision> {
        decide::all(self)
    }
}

/// The lights and the lamps of a scene.
fn planned_lights<'a>(
    scene: &'a Scene,
    surfaces: &SurfaceList<'a>,
    reachability: &[Reachability],
    is_open: bool,
    saves: bool,
) -> (Vec<PlannedLight<'a>>, Vec<PlannedLight<'a>>) {
    let silhouettes = Arc::new(Silhouettes::new(scene.surfaces.len()));
    let planned = |emitter, unlit: &dyn Fn(usize, &dyn Surface, bool) -> Option<Unlit>| {
        let reached = scene.surfaces.iter().zip(reachability).enumerate();
        let unlit = reached.map(|(index, (surface, it))| unlit(index, &**surface, it.is_reached()));
        let unlit: Vec<_> = unlit.collect();
        let lights = |index: usize| unlit[index].is_none();
        let view = LightView::new(surfaces, &silhouettes, emitter, !saves, lights);
        let view = view.open(is_open);
        PlannedLight { view, unlit }
    };
    let lights = scene.lights.iter().map(|light| {
        planned(Emitter::Point(light.location), &|_, surface, is_reached| {
            Unlit::by_light(light, surface, is_reached, saves)
        })
    });
    let lamps = Emitter::lamps(surfaces).map(|emitter| {
        let silhouette = emitter.silhouette();
        planned(emitter, &|index, surface, is_reached| {
            let lamp = (emitter.lamp()?, &silhouette);
            let receiver = silhouettes.of(&surfaces.primitives()[index]);
            Unlit::by_lamp(lamp, (surface, receiver), is_reached, saves)
        })
    });
    (lights.collect(), lamps.collect())
}

/// The outlines for adaptive sampling; `None` for a fixed number of rays per pixel.
fn outlines(scene: &Scene, camera: &Camera) -> Option<Outlines> {
    let RenderSettings {
        width,
        height,
        max_error,
        ..
    } = scene.settings;
    (max_error > 0.0).then(|| {
        let surfaces = scene.surfaces.iter().map(AsRef::as_ref);
        Outlines::new(surfaces, camera, [width, height])
    })
}

/// The texture filter; `None` if it cannot change the picture.
fn filter(scene: &Scene, scope: Scope) -> Option<Filter> {
    (scene.is_filtered() || scope == Scope::Everything).then_some(scene.settings.texture_filter)
}
