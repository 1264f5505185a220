//! What finds the surfaces that stand in the way of a light among very many.

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::DVec3;

use super::Entry;
use super::passage::Passage;
use super::tree::Tree;
use crate::math::{Ray, Rgb, Segment};

/// A tree of surfaces of which some cast shadows.
#[derive(Debug)]
pub(super) struct CasterTree {
    tree: Arc<Tree>,
    /// For every surface its place in the list of casters.
    casters: Vec<Option<u32>>,
}

impl CasterTree {
    /// A tree of so many surfaces, of which these cast shadows.
    pub(super) fn new<'e, 'a: 'e>(
        tree: &Arc<Tree>,
        count: usize,
        entries: impl Iterator<Item = &'e Entry<'a>>,
    ) -> Self {
        let mut casters = vec![None; count];
        for (place, caster) in (0..).zip(entries) {
            casters[caster.index] = Some(place);
        }
        Self {
            tree: tree.clone(),
            casters,
        }
    }

    /// The share of light that passes along a segment, of which the part up to a distance counts.
    ///
    /// `hides` takes the place of a caster, and gives it, if it stands in the way, and whether
    /// nothing passes it.
    pub(super) fn transmittance<'e, 'a: 'e>(
        &self,
        segment: &Segment,
        until: f64,
        mut hides: impl FnMut(usize) -> Option<(&'e Entry<'a>, bool)>,
    ) -> Rgb {
        let mut in_the_way = Vec::new();
        let mut is_blocked = false;
        self.tree.walk(&segment.ray, until, |index, until| {
            let hiding = self.casters[index].and_then(|place| hides(place as usize));
            let Some((entry, blocks)) = hiding else {
                return ControlFlow::Continue(until);
            };
            in_the_way.push(entry);
            is_blocked = blocks;
            if blocks {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(until)
            }
        });
        if is_blocked {
            return Rgb::BLACK;
        }
        in_the_way.sort_unstable_by_key(|entry| entry.index);
        passed(in_the_way.into_iter(), segment)
    }

    /// Asks the casters, by their places, that rays from where a ray starts to a ball around a lamp may
    /// meet; `ask` says whether the others matter.
    pub(super) fn ask_toward(
        &self,
        ray: &Ray,
        lamp: (DVec3, f64),
        mut ask: impl FnMut(usize) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        self.tree
            .walk_toward(ray, lamp, |index| match self.casters[index] {
                Some(place) => ask(place as usize),
                None => ControlFlow::Continue(()),
            })
    }
}

/// The share of light along a segment that passes all of these, which are in file order.
pub(super) fn passed<'e, 'a: 'e>(
    in_the_way: impl Iterator<Item = &'e Entry<'a>>,
    segment: &Segment,
) -> Rgb {
    let mut passage = Passage::new(segment);
    for entry in in_the_way {
        if !passage.has_crossed(entry.support) && passage.cross(entry).is_break() {
            break;
        }
    }
    passage.share
}
