//! Which surface is nearest, and which stand in the way of a light.

mod supports;

pub use supports::supports;

use crate::math::{Ray, Rgb, Segment, Span, Support};
use crate::surface::{Hit, Surface};

/// The surfaces of a scene in file order: every one is asked.
#[derive(Debug)]
pub struct SurfaceList<'a> {
    /// Each surface with the sheet that it lies on; without one, a ray that leaves the surface asks
    /// it again.
    entries: Vec<(&'a dyn Surface, Option<Support>)>,
}

impl<'a> SurfaceList<'a> {
    /// A list of these surfaces.
    #[must_use]
    pub fn new(surfaces: &'a [Box<dyn Surface>]) -> Self {
        let all = surfaces.iter().map(AsRef::as_ref);
        Self {
            entries: all.zip(supports(surfaces).into_iter().map(Some)).collect(),
        }
    }

    /// A list of surfaces that themselves keep a ray from meeting the one that it leaves.
    #[must_use]
    pub fn without_sheets(surfaces: &'a [Box<dyn Surface + 'a>]) -> Self {
        let all = surfaces.iter().map(AsRef::as_ref);
        Self {
            entries: all.map(|surface| (surface, None)).collect(),
        }
    }

    /// The surface that a ray meets first, with the sheet that it lies on.
    ///
    /// Of surfaces on the same sheet the first in the file wins.
    #[must_use]
    pub fn nearest(
        &self,
        ray: &Ray,
        span: Span,
    ) -> Option<(&'a dyn Surface, Option<Support>, Hit)> {
        let mut best: Option<(&'a dyn Surface, Option<Support>, Hit)> = None;
        let mut span = span;
        for &(surface, support) in &self.entries {
            if support.is_some() && ray.leaves == support {
                continue;
            }
            let Some(hit) = surface.hits(ray, span) else {
                continue;
            };
            if best.as_ref().is_some_and(|(_, best_support, best_hit)| {
                hit.t >= best_hit.t || (support.is_some() && support == *best_support)
            }) {
                continue;
            }
            span = span.until(hit.t);
            best = Some((surface, support, hit));
        }
        best
    }

    /// The share of a light's colour that passes along a segment to it.
    ///
    /// Opaque surfaces block it, transparent ones tint it, each once. Of surfaces on the same sheet
    /// the first in the file counts.
    #[must_use]
    pub fn transmittance(&self, segment: &Segment) -> Rgb {
        let mut passed = Rgb::WHITE;
        let mut crossed: Vec<Support> = Vec::new();
        for &(surface, support) in &self.entries {
            let leaves = support.is_some() && segment.ray.leaves == support;
            if leaves || !surface.occludes(segment) {
                continue;
            }
            if support.is_some_and(|support| crossed.contains(&support)) {
                continue;
            }
            let common = surface.common();
            if !common.shadows.cast {
                continue;
            }
            if common.material.transparency == 0.0 {
                return Rgb::BLACK;
            }
            crossed.extend(support);
            if let Some(hit) = surface.hits(&segment.ray, segment.span) {
                passed = passed * surface.transmits(&hit);
            }
        }
        passed
    }
}
