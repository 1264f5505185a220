//! Surfaces: a shape, a material and a cover; the trait [`Surface`].

mod common;
mod globe;
mod lamp;
mod lamp_light;
mod plain;
mod procedural_plane;
mod textured;
mod tiled_plane;

pub use crate::geometry::{Hit, Resolved};
pub use common::{Common, Shadows};
pub use lamp::Lamp;
pub use plain::Plain;
pub use procedural_plane::{ProceduralPlane, Shader};
pub use textured::Textured;
pub use tiled_plane::{TileStart, TiledPlane};

use std::fmt;

use crate::geometry::{self, Shape, Shared};
use crate::language::{Node, Schema};
use crate::math::{Beam, Numerics, Ray, Rgb, Span};
use crate::texture::{Filter, Texture};

/// The nodes of the scene language that make surfaces.
pub const SCHEMAS: &[&Schema] = &[
    &Plain::PLANE,
    &Plain::FINITE_PLANE,
    &TiledPlane::SCHEMA,
    &Textured::PLANE,
    &ProceduralPlane::SCHEMA,
    &Plain::SPHERE,
    &Plain::ELLIPSOID,
    &Plain::TRIANGLE,
    &Lamp::SCHEMA,
];

/// An object of the scene that rays can hit: the chapter's `object_t`.
///
/// A new cover writes [`shape`](Self::shape), [`shape_mut`](Self::shape_mut),
/// [`common`](Self::common) and [`describe`](Self::describe), and those of the others that it
/// changes.
pub trait Surface: Send + Sync + fmt::Debug {
    /// The geometry.
    fn shape(&self) -> &Shape;

    /// The geometry, to be changed when planes and borders are shared.
    fn shape_mut(&mut self) -> &mut Shape;

    /// The properties of every surface: name, material, part in shadows.
    fn common(&self) -> &Common;

    /// The surface as a node of the scene language: the chapter's `dump_obj`.
    ///
    /// The node lacks the properties in [`Common`].
    fn describe(&self) -> Node;

    /// The nearest hit of a ray in a span of distances.
    #[doc(alias = "intersect")]
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        self.shape().intersect(ray, span)
    }

    /// The exact texel or tile at a hit, and the texel's colour.
    ///
    /// The tracer resolves only the hits that it shows.
    fn resolve(&self, hit: &Hit, _ray: &Ray, _numerics: Numerics) -> Resolved {
        Resolved {
            uv: hit.uv,
            texel: Rgb::WHITE,
        }
    }

    /// The ambient reflectivity at a resolved hit.
    #[doc(alias = "ambient")]
    fn getamb(&self, hit: &Hit) -> Rgb {
        self.common().material.ambient * hit.texel
    }

    /// The diffuse reflectivity at a resolved hit.
    #[doc(alias = "diffuse")]
    fn getdiff(&self, hit: &Hit) -> Rgb {
        self.common().material.diffuse * hit.texel
    }

    /// The image on the surface.
    fn texture(&self) -> Option<&Texture> {
        None
    }

    /// The colour of the image over the footprint of a beam around a resolved hit.
    fn texel_over(&self, hit: &Hit, _beam: &Beam, _filter: Filter) -> Rgb {
        hit.texel
    }

    /// The largest absolute channels of all ambient and diffuse reflectivities.
    ///
    /// They bound [`getamb`](Self::getamb) and [`getdiff`](Self::getdiff).
    fn brightest(&self) -> [f64; 2] {
        // No texel is brighter than white.
        let material = &self.common().material;
        [material.ambient.largest(), material.diffuse.largest()]
    }

    /// The surface as a lamp, if it emits light.
    fn lamp(&self) -> Option<&Lamp> {
        None
    }
}

/// Lets surfaces in one plane, and neighbours along a border, decide alike.
///
/// Returns the planes and borders that surfaces share; see [`geometry::share`].
pub fn share(surfaces: &mut [Box<dyn Surface>]) -> Vec<Shared> {
    let shapes = surfaces.iter_mut().map(|surface| surface.shape_mut());
    geometry::share(&mut shapes.collect::<Vec<_>>())
}
