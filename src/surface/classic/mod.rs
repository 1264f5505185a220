//! The chapter's own algorithm, in `f64` and in `f32`: the baseline of tests and costs.
//!
//! Everything happens in world coordinates. A ray is `P = o + t d`; a plane is met at
//! `t = n·(q − o) / n·d`; a finite plane subtracts its corner from the hit, rotates what is left
//! into its own axes and compares it with its width and height; a sphere is a quadratic; a triangle
//! has barycentric coordinates; a texel's number is truncated as in C. No ray knows which surface
//! it leaves: hits nearer than [`Scalar::OFFSET`] do not count.
//!
//! That is what ray tracers do, written with care, and good in most pictures. Where it is not,
//! `tests/weaknesses.rs` says so.

mod flat;
mod lookup;
mod other;
mod paint;
mod round;
mod scalar;
mod solid;
mod triangle;
mod vector;

pub use scalar::Scalar;

use glam::DVec3;

use super::{Anatomy, Common, Hit, Shape, Surface};
use crate::language::Node;
use crate::math::{Beam, Bounds, Numerics, Ray, Rgb, Segment, Side, Span};
use crate::texture::Filter;
use other::Other;
use paint::Paint;
use solid::Solid;
use vector::Line;

/// The same surfaces in the same order, made for these numerics; `None` if they are so already.
#[must_use]
pub fn surfaces(
    surfaces: &[Box<dyn Surface>],
    numerics: Numerics,
) -> Option<Vec<Box<dyn Surface + '_>>> {
    let all = surfaces.iter().map(AsRef::as_ref);
    match numerics {
        Numerics::Robust => None,
        Numerics::Classic => Some(all.map(surface::<f64>).collect()),
        Numerics::ClassicF32 => Some(all.map(surface::<f32>).collect()),
    }
}

/// The classic form of one surface.
fn surface<T: Scalar>(surface: &dyn Surface) -> Box<dyn Surface + '_> {
    let Some(anatomy) = surface.anatomy() else {
        return Box::new(Other::<T>::of(surface));
    };
    let entered = surface.common().material.is_entered();
    match anatomy.shape {
        Shape::Plane { point, normal } => {
            Classic::boxed(surface, &anatomy, flat::Plane::<T>::of(point, normal))
        }
        Shape::Rectangle { corner, axes, size } => {
            let rectangle = flat::Rectangle::<T>::of(corner, axes, size);
            Classic::boxed(surface, &anatomy, rectangle)
        }
        Shape::Triangle { vertices, normal } => {
            let triangle = triangle::Triangle::<T>::of(vertices, normal);
            Classic::boxed(surface, &anatomy, triangle)
        }
        Shape::Sphere { center, radius } => Classic::boxed(
            surface,
            &anatomy,
            round::Sphere::<T>::of(center, radius, entered),
        ),
        Shape::Ellipsoid { center, axes } => {
            let ellipsoid = round::Ellipsoid::<T>::of(center, axes, entered);
            Classic::boxed(surface, &anatomy, ellipsoid)
        }
    }
}

/// A surface that is asked in the classic way; what only robust numerics ask it does not answer.
#[derive(Debug)]
struct Classic<'a, T, S> {
    surface: &'a dyn Surface,
    common: &'a Common,
    solid: S,
    paint: Paint<'a, T>,
    /// The surface's own point.
    anchor: DVec3,
}

impl<'a, T: Scalar, S: Solid<T> + 'a> Classic<'a, T, S> {
    fn boxed(surface: &'a dyn Surface, anatomy: &Anatomy<'a>, solid: S) -> Box<dyn Surface + 'a> {
        Box::new(Self {
            surface,
            common: surface.common(),
            solid,
            paint: Paint::of(&anatomy.cover, &anatomy.shape),
            anchor: anatomy.shape.anchor(),
        })
    }
}

/// A hit as a surface of its own numerics expects it: as an offset from the surface's own point.
fn anchored(hit: &Hit, anchor: DVec3) -> Hit {
    let point = hit.point.about(anchor);
    Hit { point, ..*hit }
}

impl<T: Scalar, S: Solid<T>> Surface for Classic<'_, T, S> {
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        let counts = |t: T| t > T::OFFSET && span.contains(t.wide());
        let meeting = self.solid.meets(&Line::of(ray), counts)?;
        Some(meeting.hit())
    }

    fn common(&self) -> &Common {
        self.common
    }

    fn describe(&self) -> Node {
        self.surface.describe()
    }

    fn bounds(&self) -> Option<Bounds> {
        self.surface.bounds()
    }

    fn occludes(&self, segment: &Segment, _end: Side) -> bool {
        let end = T::of(segment.length) - T::OFFSET;
        let counts = |t: T| t > T::OFFSET && t < end && segment.limits().span().contains(t.wide());
        self.solid.meets(&Line::of(&segment.ray), counts).is_some()
    }

    fn settle(&self, hit: &mut Hit, ray: &Ray) {
        hit.texel = match &self.paint {
            Paint::Own(anchor) => {
                let mut own = anchored(hit, *anchor);
                self.surface.settle(&mut own, ray);
                own.texel
            }
            paint => paint.texel(hit),
        };
    }

    fn texel_over(&self, hit: &Hit, beam: &Beam, filter: Filter) -> Rgb {
        let own = anchored(hit, self.anchor);
        self.surface.texel_over(&own, beam, filter)
    }

    fn getamb(&self, hit: &Hit) -> Rgb {
        match &self.paint {
            Paint::Tiles(tiles) => tiles.material_at(hit, &self.common.material).ambient,
            Paint::Own(anchor) => self.surface.getamb(&anchored(hit, *anchor)),
            _ => self.common.material.ambient * hit.texel,
        }
    }

    fn getdiff(&self, hit: &Hit) -> Rgb {
        match &self.paint {
            Paint::Tiles(tiles) => tiles.material_at(hit, &self.common.material).diffuse,
            Paint::Own(anchor) => self.surface.getdiff(&anchored(hit, *anchor)),
            _ => self.common.material.diffuse * hit.texel,
        }
    }

    fn transmits(&self, hit: &Hit) -> Rgb {
        match &self.paint {
            Paint::Own(anchor) => self.surface.transmits(&anchored(hit, *anchor)),
            _ => {
                let material = &self.common.material;
                material.tint() * material.transparency * hit.texel
            }
        }
    }
}

#[cfg(test)]
mod tests;
