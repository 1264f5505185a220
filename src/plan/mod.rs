//! What of a scene is simulated, and why.

mod scope;
mod tail;

pub use scope::Scope;
pub use tail::Tail;

use crate::accel::{LampView, LightView, Sight, SurfaceList};
use crate::camera::Camera;
use crate::language::Refusal;
use crate::scene::Scene;
use crate::surface::Surface;

/// A scene made ready for tracing: what will be simulated of it.
#[derive(Debug)]
pub struct Plan<'a> {
    /// What is drawn.
    pub scene: &'a Scene,
    /// Where it is seen from.
    pub camera: Camera,
    /// The surfaces that rays can meet.
    pub surfaces: SurfaceList<'a>,
    /// What the camera sees where; `None` if everything is looked for everywhere.
    pub sight: Option<Sight<'a>>,
    /// What each light has before it, in the order of the scene's lights.
    pub light_views: Vec<LightView<'a>>,
    /// What each lamp has before it, in the order of the scene's surfaces.
    pub lamp_views: Vec<LampView<'a>>,
    /// What a ray that is not followed could still have brought.
    pub tail: Tail,
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
    ) -> Result<Self, Refusal> {
        let camera = scene
            .view
            .camera(scene.picture.width, scene.picture.height)?;
        let surfaces = match classic {
            None => SurfaceList::new(&scene.surfaces),
            Some(classic) => SurfaceList::without_sheets(classic),
        };
        // Rounded numerics prove nothing, so they leave nothing out.
        let elides = scope == Scope::CalledFor && classic.is_none();
        let lights = scene.lights.iter().map(|light| light.location);
        Ok(Self {
            scene,
            sight: elides.then(|| Sight::new(&surfaces, &camera)),
            light_views: LightView::all(&surfaces, lights, elides),
            lamp_views: LampView::all(&surfaces, &scene.surfaces, !elides),
            surfaces,
            camera,
            tail: Tail::new(scene),
            scope,
        })
    }
}
