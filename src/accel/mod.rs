//! Which surface is nearest, and which stand in the way of a light.

mod lamps;
mod receivers;
mod shade;
mod shadows;
mod shields;
mod sight;
mod supports;

pub use lamps::{Between, Casters, LampView};
pub use shadows::LightView;
pub use sight::Sight;
pub use supports::supports;

use std::cmp::Ordering;

use crate::math::{Decisions, Flat, Ray, Span, Support};
use crate::surface::{Hit, Surface};

/// The surfaces of a scene in file order: every one is asked.
#[derive(Debug)]
pub struct SurfaceList<'a> {
    entries: Vec<Entry<'a>>,
}

/// A surface of a list.
#[derive(Debug, Clone, Copy)]
pub struct Entry<'a> {
    /// The surface.
    pub surface: &'a dyn Surface,
    /// The sheet that it lies on; `None` if rays may meet it again where they leave it.
    pub support: Option<Support>,
    /// Its plane, if it is flat.
    pub flat: Option<&'a Flat>,
    /// Its place in the list.
    pub index: usize,
}

impl<'a> SurfaceList<'a> {
    /// A list of these surfaces, which rays do not meet again where they leave them.
    #[must_use]
    pub fn new(surfaces: &'a [Box<dyn Surface>]) -> Self {
        let supports = supports(surfaces).into_iter().map(Some);
        Self::of(surfaces, supports)
    }

    /// A list of surfaces that rays may meet again where they leave them; they have to see to it
    /// themselves.
    #[must_use]
    pub fn without_sheets(surfaces: &'a [Box<dyn Surface + 'a>]) -> Self {
        Self::of(surfaces, std::iter::repeat(None))
    }

    fn of(
        surfaces: &'a [Box<dyn Surface + 'a>],
        supports: impl Iterator<Item = Option<Support>>,
    ) -> Self {
        let surfaces = surfaces.iter().map(AsRef::as_ref).enumerate();
        let entries = surfaces.zip(supports);
        Self {
            entries: entries
                .map(|((index, surface), support)| Entry {
                    surface,
                    support,
                    flat: surface.flat(),
                    index,
                })
                .collect(),
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
    pub fn nearest(&self, ray: &Ray, span: Span, tests: &mut u64) -> Option<(&Entry<'a>, Hit)> {
        nearest(self.entries.iter(), ray, span, tests)
    }
}

/// The one of some surfaces, in file order, that a ray meets first.
#[inline]
fn nearest<'e, 'a>(
    entries: impl Iterator<Item = &'e Entry<'a>>,
    ray: &Ray,
    mut span: Span,
    tests: &mut u64,
) -> Option<(&'e Entry<'a>, Hit)> {
    let mut best: Option<(&Entry<'a>, Hit)> = None;
    let left = ray.leaves();
    for entry in entries {
        if entry.lies_on(left) {
            continue;
        }
        *tests += 1;
        let Some(hit) = entry.surface.hits(ray, span) else {
            continue;
        };
        if best.is_some_and(|(first, first_hit)| !entry.is_before(&hit, first, &first_hit, ray)) {
            continue;
        }
        span = span.until(hit.t + hit.error);
        best = Some((entry, hit));
    }
    best.map(|(entry, hit)| (entry, entry.surface.settle(hit, ray)))
}

impl<'a> Entry<'a> {
    /// What rays that leave the surface know of it.
    #[must_use]
    pub fn sheet(&self) -> (Option<Support>, Option<&'a Flat>) {
        (self.support, self.flat)
    }

    /// Whether the surface lies on a sheet, if it is known to lie on one.
    fn lies_on(&self, sheet: Option<Support>) -> bool {
        sheet.is_some() && self.support == sheet
    }

    /// Whether a hit of this surface is nearer than that of one before it in the file.
    fn is_before(&self, hit: &Hit, first: &Entry<'_>, first_hit: &Hit, ray: &Ray) -> bool {
        if self.support.is_some() && self.support == first.support {
            return false;
        }
        let error = hit.error + first_hit.error;
        let nearer = first_hit.t - hit.t;
        if nearer.abs() > error {
            return nearer > 0.0;
        }
        let distance = self.surface.exact_distance(ray);
        match distance.zip(first.surface.exact_distance(ray)) {
            Some((distance, first_distance)) => {
                let order = distance.compare(&first_distance);
                Decisions::note(order == Ordering::Equal);
                order == Ordering::Less
            }
            None => nearer > 0.0,
        }
    }
}
