//! What is left of light on its way through surfaces.

use std::ops::ControlFlow;

use super::Entry;
use crate::math::{CarrierId, Rgb, Segment};

/// The light along a segment, as it passes what stands in the way.
///
/// Opaque surfaces block it, transparent ones tint it, each once; of surfaces on the same sheet the
/// first one counts.
#[derive(Debug)]
pub(super) struct Passage<'s> {
    segment: &'s Segment<'s>,
    /// The share of its colour that is left.
    pub(super) share: Rgb,
    /// The sheets that it has passed.
    crossed: Vec<CarrierId>,
}

impl<'s> Passage<'s> {
    /// All of the light.
    pub(super) fn new(segment: &'s Segment<'s>) -> Self {
        Self {
            segment,
            share: Rgb::WHITE,
            crossed: Vec::new(),
        }
    }

    /// Whether it has passed this sheet, where no other surface counts any more.
    pub(super) fn has_crossed(&self, sheet: Option<CarrierId>) -> bool {
        sheet.is_some_and(|sheet| self.crossed.contains(&sheet))
    }

    /// Goes on through a surface that stands in the way, or ends there.
    pub(super) fn cross(&mut self, entry: &Entry<'_>) -> ControlFlow<()> {
        if entry.common.material.transparency == 0.0 {
            self.share = Rgb::BLACK;
            return ControlFlow::Break(());
        }
        self.crossed.extend(entry.support);
        let span = self.segment.limits().span();
        if let Some(mut hit) = entry.surface.hits(&self.segment.ray, span) {
            entry.surface.settle(&mut hit, &self.segment.ray);
            self.share = self.share * entry.surface.transmits(&hit);
        }
        ControlFlow::Continue(())
    }
}
