//! What of a scene is simulated, and why.

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

use crate::accel::{Accelerator, LampView, LightView, ScreenBounds, SurfaceList};
use crate::camera::Camera;
use crate::language::ValueError;
use crate::scene::{RenderSettings, Scene};
use crate::surface::Surface;
use crate::texture::Filter;

/// A scene made ready for tracing: what will be simulated of it.
#[derive(Debug)]
pub struct Plan<'a> {
    /// What is drawn.
    pub scene: &'a Scene,
    /// Where it is seen from.
    pub camera: Camera,
    /// The surfaces that rays can meet.
    pub surfaces: SurfaceList<'a>,
    /// What the camera sees where; `None` if everything is looked for everywhere, or a
    /// tree knows better.
    pub sight: Option<ScreenBounds<'a>>,
    /// What each light has before it, in the order of the scene's lights.
    pub light_views: Vec<LightView<'a>>,
    /// What each lamp has before it, in the order of the scene's surfaces.
    pub lamp_views: Vec<LampView<'a>>,
    /// How rays can meet a surface, for each of them.
    pub seen: Vec<Reachability>,
    /// Why the light of a light never arrives at a surface, if so: for each light, each surface.
    pub unlit: Vec<Vec<Option<Unlit>>>,
    /// The same for each lamp.
    pub unlit_by_lamp: Vec<Vec<Option<Unlit>>>,
    /// Where the outlines of surfaces run through the picture; `None` if nobody asks.
    pub outlines: Option<Outlines>,
    /// What a ray that is not followed could still have brought.
    pub tail: Tail,
    /// How textures are looked at, if beams are followed for it; `None` if the texel that a ray meets
    /// is all that is wanted.
    pub filter: Option<Filter>,
    /// Whether anything is left out.
    pub scope: Scope,
}

impl<'a> Plan<'a> {
    /// A plan for this scene; `classic` are its surfaces made for other numerics than their own,
    /// if the scene asks for that ([`crate::surface::classic::surfaces`]).
    ///
    /// # Errors
    /// Refuses a camera that cannot exist.
    pub fn new(
        scene: &'a Scene,
        classic: Option<&'a [Box<dyn Surface + 'a>]>,
        scope: Scope,
    ) -> Result<Self, ValueError> {
        let accelerator = match scope {
            Scope::CalledFor => Accelerator::for_count(scene.surfaces.len()),
            Scope::Everything => Accelerator::List,
        };
        Self::with(scene, classic, scope, accelerator)
    }

    /// The same plan with surfaces found in this way. Classic ones are always in a list.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with(
        scene: &'a Scene,
        classic: Option<&'a [Box<dyn Surface + 'a>]>,
        scope: Scope,
        accelerator: Accelerator,
    ) -> Result<Self, ValueError> {
        let camera = scene
            .view
            .camera(scene.settings.width, scene.settings.height)?;
        let surfaces = match classic {
            None => SurfaceList::with(&scene.surfaces, accelerator),
            Some(classic) => SurfaceList::without_sheets(classic),
        };
        // Rounded numerics prove nothing, so they leave nothing out.
        let elides = scope == Scope::CalledFor && classic.is_none();
        let sight = elides.then(|| ScreenBounds::new(&surfaces, &camera));
        let seen = Reachability::all(scene, sight.as_ref(), &camera);
        let unlit = Unlit::by_lights(scene, &seen, elides);
        let places = scene.lights.iter().map(|light| light.location);
        let lights = |light: usize, surface: usize| unlit[light][surface].is_none();
        let light_views = LightView::all(&surfaces, places, elides, lights);
        let mut lamp_views = LampView::all(&surfaces, &scene.surfaces, !elides);
        let unlit_by_lamp = Unlit::by_lamps(&lamp_views, surfaces.entries(), &seen, elides);
        for (view, unlit) in lamp_views.iter_mut().zip(&unlit_by_lamp) {
            view.retain(|surface| unlit[surface].is_none());
        }
        let outlines = outlines(scene, &camera);
        let all_asked = surfaces.accelerator() == Accelerator::List;
        Ok(Self {
            scene,
            camera,
            surfaces,
            sight: sight.filter(|_| all_asked),
            light_views,
            lamp_views,
            seen,
            unlit,
            unlit_by_lamp,
            outlines,
            tail: Tail::new(scene),
            filter: filter(scene, scope),
            scope,
        })
    }

    /// Whether there is neither a light nor a lamp.
    #[must_use]
    #[inline]
    pub fn is_unlit(&self) -> bool {
        self.light_views.is_empty() && self.lamp_views.is_empty()
    }

    /// Whether each effect is simulated, and why.
    #[must_use]
    pub fn decisions(&self) -> Vec<Decision> {
        decide::all(self)
    }
}

/// The outlines in a picture that sends more rays through some pixels than through others.
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

/// The filter of a scene whose textures it makes a difference to.
fn filter(scene: &Scene, scope: Scope) -> Option<Filter> {
    (scene.is_filtered() || scope == Scope::Everything).then_some(scene.settings.texture_filter)
}
