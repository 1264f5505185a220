//! The surfaces of a scene, and the search for the one that a ray hits first.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::Accelerator;
use super::carriers::carriers;
use super::primitive::Primitive;
use super::tree::Tree;
use crate::geometry::Hit;
use crate::math::{CarrierId, Limits, Numerics, Ray, Span};
use crate::surface::Surface;

/// The surfaces of a scene in file order, and their tree.
#[derive(Debug)]
pub struct SurfaceList<'a> {
    primitives: Vec<Primitive<'a>>,
    /// `None` if every surface is tested.
    tree: Option<Arc<Tree>>,
}

impl<'a> SurfaceList<'a> {
    /// The surfaces, with the accelerator for their number.
    #[must_use]
    pub fn new(surfaces: &'a [Box<dyn Surface>]) -> Self {
        Self::with(surfaces, Accelerator::for_count(surfaces.len()))
    }

    /// The surfaces with this accelerator; hits do not depend on it.
    #[must_use]
    pub fn with(surfaces: &'a [Box<dyn Surface>], accelerator: Accelerator) -> Self {
        let numbered = surfaces.iter().enumerate().zip(carriers(surfaces));
        let primitives = numbered
            .map(|((index, surface), carrier)| Primitive::robust(index, &**surface, carrier));
        let primitives: Vec<_> = primitives.collect();
        let tree = match accelerator {
            Accelerator::List => None,
            Accelerator::Tree => Some(Arc::new(Tree::new(&primitives))),
        };
        Self { primitives, tree }
    }

    /// The surfaces, tested with classic numerics.
    ///
    /// Every surface is tested, because rounded hits have no proven bounds.
    #[must_use]
    pub fn classic(surfaces: &'a [Box<dyn Surface>], numerics: Numerics) -> Self {
        let numbered = surfaces.iter().enumerate();
        let primitives =
            numbered.map(|(index, surface)| Primitive::classic(index, &**surface, numerics));
        Self {
            primitives: primitives.collect(),
            tree: None,
        }
    }

    /// The surfaces in file order.
    #[must_use]
    pub fn primitives(&self) -> &[Primitive<'a>] {
        &self.primitives
    }

    /// The search structure in use.
    #[must_use]
    pub fn accelerator(&self) -> Accelerator {
        match self.tree {
            None => Accelerator::List,
            Some(_) => Accelerator::Tree,
        }
    }

    /// The tree, if there is one.
    pub(super) fn tree(&self) -> Option<&Arc<Tree>> {
        self.tree.as_ref()
    }

    /// The surface that a ray hits first, and the hit, which is not resolved yet.
    ///
    /// Among equally near surfaces, the first in the file wins. `tests` grows by the number of
    /// surfaces that are tested.
    #[must_use]
    pub fn nearest<'r>(
        &self,
        ray: &'r Ray<'r>,
        span: impl Into<Limits<'r>>,
        tests: &mut u64,
    ) -> Option<(&Primitive<'a>, Hit)> {
        let span = span.into();
        let Some(tree) = &self.tree else {
            return nearest(self.primitives.iter(), ray, span, tests);
        };
        search(ray, &span, |search| {
            tree.walk(ray, search.span.max(), |index, _| {
                search.test(&self.primitives[index], tests);
                ControlFlow::Continue(search.span.max())
            });
        })
    }
}

/// The first of some surfaces that a ray hits.
#[inline]
pub(super) fn nearest<'e, 'a>(
    primitives: impl Iterator<Item = &'e Primitive<'a>> + Clone,
    ray: &Ray,
    span: Limits<'_>,
    tests: &mut u64,
) -> Option<(&'e Primitive<'a>, Hit)> {
    search(ray, &span, |search| {
        for primitive in primitives.clone() {
            search.test(primitive, tests);
        }
    })
}

/// The result of a search; `test_all` tests the surfaces that the ray may hit.
#[inline(always)]
fn search<'e, 'a, 'r>(
    ray: &'r Ray<'r>,
    limits: &'r Limits<'r>,
    mut test_all: impl FnMut(&mut Search<'e, 'a, 'r, '_>),
) -> Option<(&'e Primitive<'a>, Hit)> {
    let mut best = None;
    test_all(&mut Search::new(ray, limits.span(), None, &mut best));
    // The limits are decided exactly only if the nearest hit lies next to one of them.
    let is_outside = |(primitive, hit): &(&Primitive<'_>, Hit)| {
        let is_held = limits.hold(hit.t, hit.error, primitive.plane);
        !is_held
    };
    if best.as_ref().is_some_and(is_outside) {
        best = None;
        test_all(&mut Search::new(
            ray,
            limits.span(),
            Some(limits),
            &mut best,
        ));
    }
    best
}

/// A search for the first hit of a ray; the order of the tests does not matter.
struct Search<'e, 'a, 'r, 'b> {
    ray: &'r Ray<'r>,
    left: Option<CarrierId>,
    /// Limits that each hit is tested against.
    limits: Option<&'r Limits<'r>>,
    /// The distances at which a hit would be nearer.
    span: Span,
    best: &'b mut Option<(&'e Primitive<'a>, Hit)>,
}

impl<'e, 'a, 'r, 'b> Search<'e, 'a, 'r, 'b> {
    fn new(
        ray: &'r Ray<'r>,
        span: Span,
        limits: Option<&'r Limits<'r>>,
        best: &'b mut Option<(&'e Primitive<'a>, Hit)>,
    ) -> Self {
        Self {
            ray,
            left: ray.leaves(),
            limits,
            span,
            best,
        }
    }

    #[inline(always)]
    fn test(&mut self, primitive: &'e Primitive<'a>, tests: &mut u64) {
        if primitive.lies_on(self.left) && !primitive.is_entered {
            return;
        }
        *tests += 1;
        let hits = primitive.hits(self.ray, self.span);
        let Some(hit) = &hits else {
            return;
        };
        if let Some(limits) = self.limits
            && !limits.hold(hit.t, hit.error, primitive.plane)
        {
            return;
        }
        if let Some((best, best_hit)) = &*self.best
            && !primitive.is_before(hit, best, best_hit, self.ray)
        {
            return;
        }
        self.span = self.span.until(hit.t + hit.error);
        *self.best = Some((primitive, *hit));
    }
}
