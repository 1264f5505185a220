//! Which surface is nearest, and which stand in the way of a light.

mod accelerator;
mod caster_tree;
mod clearance;
mod divide;
mod funnel;
mod lamps;
mod overlaps;
mod passage;
mod reach;
mod receivers;
mod screen_bounds;
mod shade;
mod shadows;
mod shields;
mod slabs;
mod split;
mod supports;
mod tree;

pub use accelerator::Accelerator;
pub use lamps::{Between, Casters, LampView};
pub use overlaps::Overlaps;
pub use reach::overhang;
pub use screen_bounds::{Ahead, ScreenBounds};
pub use shadows::{Before, Blockers, LightView};
pub use supports::supports;

use std::cmp::Ordering;
use std::ops::ControlFlow;
use std::sync::Arc;

use crate::math::{
    CarrierId, Curve, Decisions, Flat, Limits, Ray, RayOrigin, Rgb, Segment, Side, Span,
};
use crate::surface::{Common, Hit, Surface};
use tree::Tree;

/// The most surfaces of which each has its own lists of what can stand between it and a light; of more,
/// all share one list of everything that casts.
///
/// The lists take the square of the number of surfaces to make. Smaller, and scenes of a few dozen
/// surfaces test shadows in vain; larger, and making the lists takes longer than it saves.
pub const MOST_LISTS: usize = 128;

/// The surfaces of a scene in file order, and what finds those that a ray may meet.
#[derive(Debug)]
pub struct SurfaceList<'a> {
    entries: Vec<Entry<'a>>,
    /// `None` if every surface is asked.
    tree: Option<Arc<Tree>>,
}

/// A surface of a list.
#[derive(Debug, Clone, Copy)]
pub struct Entry<'a> {
    /// The surface.
    pub surface: &'a dyn Surface,
    /// The sheet that it lies on; `None` if rays may meet it again where they leave it.
    pub support: Option<CarrierId>,
    /// Its plane, if it is flat.
    pub flat: Option<&'a Flat>,
    /// Whether a ray that leaves it to its inside meets it again: it is round, and of glass.
    pub is_entered: bool,
    /// How far a hit point may be off, in units of the error of its distance.
    slip: f64,
    /// Whether rays that meet it cause others.
    pub sends_on: bool,
    /// All that can be seen of it without light, if that is the same wherever rays cross its plane: it
    /// has no end and no texture, and sends no rays on.
    pub plain: Option<Rgb>,
    /// What it has like every surface.
    pub common: &'a Common,
    /// Its place in the list.
    pub index: usize,
}

impl<'a> SurfaceList<'a> {
    /// A list of these surfaces, which rays do not meet again where they leave them.
    #[must_use]
    pub fn new(surfaces: &'a [Box<dyn Surface>]) -> Self {
        Self::with(surfaces, Accelerator::for_count(surfaces.len()))
    }

    /// The same list, found in this way; what is found does not depend on it.
    #[must_use]
    pub fn with(surfaces: &'a [Box<dyn Surface>], accelerator: Accelerator) -> Self {
        let entries = entries(surfaces, supports(surfaces).into_iter().map(Some));
        let tree = match accelerator {
            Accelerator::List => None,
            Accelerator::Tree => Some(Arc::new(Tree::new(&entries))),
        };
        Self { entries, tree }
    }

    /// A list of surfaces that rays may meet again where they leave them; they have to see to it
    /// themselves.
    ///
    /// Every one is asked: nothing proves where numerics other than their own meet them.
    #[must_use]
    pub fn without_sheets(surfaces: &'a [Box<dyn Surface + 'a>]) -> Self {
        Self {
            entries: entries(surfaces, std::iter::repeat(None)),
            tree: None,
        }
    }

    /// How the surfaces are found.
    #[must_use]
    pub fn accelerator(&self) -> Accelerator {
        match self.tree {
            None => Accelerator::List,
            Some(_) => Accelerator::Tree,
        }
    }

    /// The surfaces with their sheets.
    #[must_use]
    pub fn entries(&self) -> &[Entry<'a>] {
        &self.entries
    }

    /// The surface that a ray meets first.
    ///
    /// Of equally near ones the first in the file wins. `tests` is raised by the number of surfaces
    /// that are asked.
    #[must_use]
    pub fn nearest<'r>(
        &self,
        ray: &'r Ray<'r>,
        span: impl Into<Limits<'r>>,
        tests: &mut u64,
    ) -> Option<(&Entry<'a>, Hit)> {
        let span = span.into();
        let Some(tree) = &self.tree else {
            return nearest(self.entries.iter(), ray, span, tests);
        };
        found(ray, &span, |search| {
            tree.walk(ray, search.span.max(), |index, _| {
                search.ask(&self.entries[index], tests);
                ControlFlow::Continue(search.span.max())
            });
        })
    }
}

fn entries<'a>(
    surfaces: &'a [Box<dyn Surface + 'a>],
    supports: impl Iterator<Item = Option<CarrierId>>,
) -> Vec<Entry<'a>> {
    let surfaces = surfaces.iter().map(AsRef::as_ref).enumerate();
    let entries = surfaces.zip(supports);
    entries
        .map(|((index, surface), support)| Entry {
            surface,
            support,
            flat: surface.flat(),
            common: surface.common(),
            is_entered: surface.round().is_some()
                && surface.common().material.is_entered()
                // A sheet has the number of the first surface on it.
                && support.is_some_and(|CarrierId(first)| first as usize == index),
            slip: surface.slip(),
            sends_on: surface.common().material.spawns_rays(),
            plain: surface.plain_ambient().filter(|_| {
                let is_endless = surface.flat().is_some() && surface.outline().is_empty();
                is_endless && !surface.common().material.spawns_rays()
            }),
            index,
        })
        .collect()
}

/// The one of some surfaces that a ray meets first.
#[inline]
fn nearest<'e, 'a>(
    entries: impl Iterator<Item = &'e Entry<'a>> + Clone,
    ray: &Ray,
    span: Limits<'_>,
    tests: &mut u64,
) -> Option<(&'e Entry<'a>, Hit)> {
    found(ray, &span, |search| {
        for entry in entries.clone() {
            search.ask(entry, tests);
        }
    })
}

/// What a search finds that asks the surfaces that may be met.
///
/// Only if what it finds is nearest does not count, though it nearly does, each of the others is asked
/// for that, too.
#[inline(always)]
fn found<'e, 'a, 'r>(
    ray: &'r Ray<'r>,
    limits: &'r Limits<'r>,
    mut ask: impl FnMut(&mut Search<'e, 'a, 'r, '_>),
) -> Option<(&'e Entry<'a>, Hit)> {
    let mut best = None;
    ask(&mut Search::new(ray, limits.span(), None, &mut best));
    let does_not_count = |(entry, hit): &(&Entry<'_>, Hit)| {
        let is_held = limits.hold(hit.t, hit.error, entry.flat);
        !is_held
    };
    if best.as_ref().is_some_and(does_not_count) {
        best = None;
        ask(&mut Search::new(
            ray,
            limits.span(),
            Some(limits),
            &mut best,
        ));
    }
    if let Some((entry, hit)) = &mut best {
        entry.surface.settle(hit, ray);
    }
    best
}

/// The search for the surface that a ray meets first; what it finds does not depend on the order in
/// which surfaces are asked.
struct Search<'e, 'a, 'r, 'b> {
    ray: &'r Ray<'r>,
    left: Option<CarrierId>,
    /// What each hit is asked for whether it counts.
    limits: Option<&'r Limits<'r>>,
    /// The distances that still may.
    span: Span,
    best: &'b mut Option<(&'e Entry<'a>, Hit)>,
}

impl<'e, 'a, 'r, 'b> Search<'e, 'a, 'r, 'b> {
    fn new(
        ray: &'r Ray<'r>,
        span: Span,
        limits: Option<&'r Limits<'r>>,
        best: &'b mut Option<(&'e Entry<'a>, Hit)>,
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
    fn ask(&mut self, entry: &'e Entry<'a>, tests: &mut u64) {
        if entry.lies_on(self.left) && !entry.is_entered {
            return;
        }
        *tests += 1;
        let met = entry.surface.hits(self.ray, self.span);
        let Some(hit) = &met else {
            return;
        };
        if let Some(limits) = self.limits
            && !limits.hold(hit.t, hit.error, entry.flat)
        {
            return;
        }
        if let Some((best, best_hit)) = &*self.best
            && !entry.is_before(hit, best, best_hit, self.ray)
        {
            return;
        }
        self.span = self.span.until(hit.t + hit.error);
        *self.best = Some((entry, *hit));
    }
}

impl<'a> Entry<'a> {
    /// What rays that leave the surface know of it.
    #[must_use]
    pub fn sheet(&self) -> (Option<CarrierId>, Option<&'a Flat>) {
        (self.support, self.flat)
    }

    /// What rays that leave the surface where another met it know of it.
    #[must_use]
    #[inline(always)]
    pub fn ray_origin<'b>(&self, arriving: &'b Ray<'b>, hit: &Hit) -> RayOrigin<'b>
    where
        'a: 'b,
    {
        let mut ray_origin =
            RayOrigin::new(self.sheet(), arriving, hit.point, self.slip * hit.error);
        if self.is_entered {
            let normal = hit.normal;
            ray_origin.curve = self.surface.round().map(|round| Curve { round, normal });
        }
        ray_origin
    }

    /// Whether the surface lies on a sheet, if it is known to lie on one.
    fn lies_on(&self, sheet: Option<CarrierId>) -> bool {
        sheet.is_some() && self.support == sheet
    }

    /// Whether the surface stands between the ends of a segment; `end` is the side of the surface that the
    /// segment's end is on. `can_hide` tells whether it can hide the light there from some part of what
    /// the segment starts on.
    ///
    /// A start next to the surface's plane inherits its side of it, so it is that of the rays that came
    /// here, which need not be one on which what it lies on has any part. What is proven to hide nothing
    /// hides nothing, asked or not.
    fn hides(&self, segment: &Segment, end: Side, can_hide: impl FnOnce() -> bool) -> bool {
        let is_doubtful = |flat: &Flat| flat.is_next_to_start(&segment.ray);
        self.surface.occludes(segment, end) && (!self.flat.is_some_and(is_doubtful) || can_hide())
    }

    /// Whether a hit of this surface comes before that of another: if it is nearer, or as near and
    /// before it in the file.
    ///
    /// A computed distance is off by its error at most, or it is next to zero for one that is exactly
    /// below; so distances that are further apart than both errors have the order of the exact
    /// ones, and this is that order.
    fn is_before(&self, hit: &Hit, other: &Entry<'_>, other_hit: &Hit, ray: &Ray) -> bool {
        let first_in_file = self.index < other.index;
        if self.support.is_some() && self.support == other.support {
            return first_in_file;
        }
        let error = hit.error + other_hit.error;
        let nearer = other_hit.t - hit.t;
        if nearer.abs() > error {
            return nearer > 0.0;
        }
        let distance = self.surface.exact_distance(ray);
        let order = match distance.zip(other.surface.exact_distance(ray)) {
            Some((distance, other_distance)) => {
                let order = distance.compare(&other_distance);
                Decisions::note(order == Ordering::Equal);
                order
            }
            None => hit.t.total_cmp(&other_hit.t),
        };
        order == Ordering::Less || order == Ordering::Equal && first_in_file
    }
}
