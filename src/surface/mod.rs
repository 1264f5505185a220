//! What a ray can hit. **The heart**: [`Surface`] is what the tracer calls on the boxed objects.

mod anatomy;
mod chord;
pub mod classic;
mod common;
mod globe;
mod inside;
mod lamp_form;
mod lamp_light;
mod shared;

use std::fmt;

use glam::{DVec2, DVec3};

use crate::language::{Node, Schema};
use crate::math::error_bounds::{FLAT_SLIP, ROUND_SLIP};
use crate::math::exact::{Distance, ExactVector};
use crate::math::{Beam, Bounds, ExactGeometry, Flat, Line, Point, Ray, Rgb, Segment, Side, Span};
use crate::texture::{Filter, Texture};

pub use anatomy::{Anatomy, Cover, Shape};
pub use common::{Common, Shadows};
pub use procedural_plane::Shader;
pub use shared::{Shared, SharedKind, share};
pub use tiled_plane::TileStart;

/// The list of surface kinds: a line here makes the module, its name, and its word known.
macro_rules! surfaces {
    ($($file:ident: $kind:ident,)*) => {
        $(mod $file; pub use $file::$kind;)*

        /// The nodes of the scene language that make surfaces.
        pub const SCHEMAS: &[&Schema] = &[$(&$kind::SCHEMA),*];
    };
}

surfaces! {
    plane: Plane,
    finite_plane: FinitePlane,
    tiled_plane: TiledPlane,
    texture_plane: TexturePlane,
    procedural_plane: ProceduralPlane,
    sphere: Sphere,
    ellipsoid: Ellipsoid,
    triangle: Triangle,
    lamp: Lamp,
}

/// Something a ray can hit, with the colours it shows there.
///
/// A new kind of surface writes [`hits`](Self::hits), [`common`](Self::common) and
/// [`describe`](Self::describe), and whichever of the others its effects need.
pub trait Surface: Send + Sync + fmt::Debug {
    /// The first hit of a ray, if there is one in the span.
    ///
    /// The caller does not ask a surface whose sheet the ray leaves.
    #[doc(alias = "intersect")]
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit>;

    /// What every surface has: its name, its material, its part in shadows.
    fn common(&self) -> &Common;

    /// The surface as a node of the scene language: the chapter's `dump_obj`.
    ///
    /// Without what [`Common`] adds.
    fn describe(&self) -> Node;

    /// The unbounded plane that the surface lies in, if it is flat.
    fn flat(&self) -> Option<&Flat> {
        None
    }

    /// The centre and the half axes of a round surface.
    fn round(&self) -> Option<[DVec3; 2]> {
        None
    }

    /// How far at most the distance of a hit is from the exact one, as close as it can be told.
    ///
    /// The hit's own bound takes less time, but grows with the coordinates of both ends; this one knows only
    /// the way between them.
    fn error(&self, ray: &Ray, hit: &Hit) -> f64 {
        let own = self.flat().map(|flat| flat.error(ray, hit.t));
        own.map_or(hit.error, |own| hit.error.min(own))
    }

    /// How far at most a hit point may lie from where it ought to because its distance is off, in units of
    /// the error of that.
    ///
    /// Where something round is met too far along the ray, the point is pushed back towards the centre, and so it
    /// slides along the surface, by 1 / cos of the angle between the normal and the way from the centre: for half
    /// axes `a ≥ b` never more than `(a/b + b/a) / 2`.
    fn slip(&self) -> f64 {
        self.round().map_or(FLAT_SLIP, |[_, axes]| {
            let ratio = axes.max_element() / axes.min_element();
            ROUND_SLIP * 0.5 * (ratio + ratio.recip())
        })
    }

    /// The corners of a flat surface that has an end, in order around it; empty for others.
    fn outline(&self) -> Vec<DVec3> {
        Vec::new()
    }

    /// Points whose convex hull holds the surface, exactly; `None` if it has no end.
    fn hull(&self) -> Option<Vec<ExactVector>> {
        None
    }

    /// The box around the surface, if it is bounded.
    fn bounds(&self) -> Option<Bounds> {
        let outline = self.outline();
        (!outline.is_empty()).then(|| Bounds::around(outline))
    }

    /// The side that a point is on; behind a closed surface is inside.
    fn side(&self, point: &Point) -> Side {
        self.flat().map_or(Side::Front, |flat| flat.side(point))
    }

    /// The lamp that the surface is, if it shines.
    fn lamp(&self) -> Option<&Lamp> {
        None
    }

    /// The surface in plain numbers, from which [`classic`] makes it anew; a surface without one
    /// is always asked itself.
    fn anatomy(&self) -> Option<Anatomy<'_>> {
        None
    }

    /// Whether the surface stands between the ends of a segment; `end` is the side of the surface
    /// that the segment's end is on.
    fn occludes(&self, segment: &Segment, _end: Side) -> bool {
        // A light on the surface itself is not hidden by it.
        let hit = self.hits(&segment.ray, segment.limits().span());
        hit.is_some_and(|hit| {
            hit.t < segment.length && segment.admits(hit.t, || hit.error, self.flat())
        })
    }

    /// The distance at which a ray meets the surface, exactly: for hits whose order is in doubt.
    ///
    /// `None` if the surface has no exact arithmetic; such hits are ordered as computed, and the
    /// surface must have no [`bounds`](Self::bounds).
    fn exact_distance(&self, _ray: &Ray) -> Option<Distance> {
        None
    }

    /// The plane and the borders as the scene file has them, if the surface is flat.
    fn exact_geometry(&self) -> Option<ExactGeometry> {
        None
    }

    /// The lines that decide the borders of a flat surface, in the order of its blueprint.
    fn borders(&self) -> Vec<Line> {
        Vec::new()
    }

    /// How far at most the lines that decide its borders lie from those between its corners, and from
    /// its plane.
    fn slack(&self) -> f64 {
        0.0
    }

    /// Takes over the plane and the border lines that a flat surface shares with others.
    fn weld(&mut self, _plane: &Flat, _borders: &[Option<Line>]) {}

    /// Completes the hit of a ray that is seen with the colour of the surface's texture, and moves it
    /// by no more than it is off so that it lies on the surface, and on the texel or tile that the ray meets
    /// exactly.
    fn settle(&self, _hit: &mut Hit, _ray: &Ray) {}

    /// Where rays first meet the surface, which all start in free space and can meet no other: a
    /// settled hit anywhere ahead for each ray that does, in place of `None`.
    ///
    /// The same as asking for each; but many that do not wait for each other are found faster.
    fn meetings(&self, rays: &[Ray], met: &mut [Option<Hit>]) {
        for (ray, met) in rays.iter().zip(&mut *met) {
            *met = self.hits(ray, Span::AHEAD);
        }
        self.settle_all(rays, met);
    }

    /// Settles the hits of these rays.
    fn settle_all(&self, rays: &[Ray], met: &mut [Option<Hit>]) {
        for (ray, met) in rays.iter().zip(met) {
            if let Some(hit) = met {
                self.settle(hit, ray);
            }
        }
    }

    /// The colour of the surface's texture in what a beam covers of it around a settled hit.
    fn texel_over(&self, hit: &Hit, _beam: &Beam, _filter: Filter) -> Rgb {
        hit.texel
    }

    /// The ambient reflectivity at a hit.
    #[doc(alias = "ambient")]
    fn getamb(&self, hit: &Hit) -> Rgb {
        self.common().material.ambient * hit.texel
    }

    /// The ambient reflectivity, if it is known to be the same at every hit.
    fn plain_ambient(&self) -> Option<Rgb> {
        None
    }

    /// The diffuse reflectivity at a hit.
    #[doc(alias = "diffuse")]
    fn getdiff(&self, hit: &Hit) -> Rgb {
        self.common().material.diffuse * hit.texel
    }

    /// The image that the surface wears.
    fn texture(&self) -> Option<&Texture> {
        None
    }

    /// The largest channels that [`getamb`](Self::getamb) and [`getdiff`](Self::getdiff) can have
    /// at any hit, whichever sign they have.
    fn brightest(&self) -> [f64; 2] {
        // No texel is brighter than white.
        let material = &self.common().material;
        [material.ambient.largest(), material.diffuse.largest()]
    }

    /// The share of light that goes straight through at a hit, with its colour.
    #[doc(alias = "transmittance")]
    fn transmits(&self, hit: &Hit) -> Rgb {
        let material = &self.common().material;
        material.tint() * material.transparency * hit.texel
    }
}

/// Where a ray met a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Distance along the ray; above zero.
    pub t: f64,
    /// How far at most `t` is from the exact distance.
    pub error: f64,
    /// The place, anchored at the surface's own point.
    pub point: Point,
    /// The unit normal as the surface has it, on whichever side the ray came.
    pub normal: DVec3,
    /// The surface's own coordinates: on a rectangle the chapter's `lasthit`, the offset from its
    /// corner along x and y in world units; zero on surfaces without such coordinates.
    pub uv: DVec2,
    /// The colour of the surface's texture, once the hit is [settled](Surface::settle); white
    /// before, and without a texture.
    pub texel: Rgb,
}
