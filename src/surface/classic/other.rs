//! Surfaces that give no anatomy.

use std::marker::PhantomData;

use super::Scalar;
use crate::language::Node;
use crate::math::{Beam, Bounds, Ray, Rgb, Segment, Side, Span};
use crate::surface::{Common, Hit, Surface};
use crate::texture::Filter;

/// A surface that keeps its own way to find hits; only the offset is the classic one.
#[derive(Debug)]
pub(super) struct Other<'a, T> {
    surface: &'a dyn Surface,
    numbers: PhantomData<T>,
}

impl<'a, T: Scalar> Other<'a, T> {
    pub(super) fn of(surface: &'a dyn Surface) -> Self {
        Self {
            surface,
            numbers: PhantomData,
        }
    }
}

impl<T: Scalar> Surface for Other<'_, T> {
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        self.surface.hits(ray, span.since(T::OFFSET.wide()))
    }

    fn common(&self) -> &Common {
        self.surface.common()
    }

    fn describe(&self) -> Node {
        self.surface.describe()
    }

    fn bounds(&self) -> Option<Bounds> {
        self.surface.bounds()
    }

    fn occludes(&self, segment: &Segment, _end: Side) -> bool {
        let before = segment
            .limits()
            .span()
            .until(segment.length - T::OFFSET.wide());
        self.hits(&segment.ray, before).is_some()
    }

    fn settle(&self, hit: &mut Hit, ray: &Ray) {
        self.surface.settle(hit, ray);
    }

    fn texel_over(&self, hit: &Hit, beam: &Beam, filter: Filter) -> Rgb {
        self.surface.texel_over(hit, beam, filter)
    }

    fn getamb(&self, hit: &Hit) -> Rgb {
        self.surface.getamb(hit)
    }

    fn getdiff(&self, hit: &Hit) -> Rgb {
        self.surface.getdiff(hit)
    }

    fn transmits(&self, hit: &Hit) -> Rgb {
        self.surface.transmits(hit)
    }
}
