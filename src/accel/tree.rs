//! A tree of boxes around surfaces.

use std::ops::ControlFlow;

use glam::DVec3;

use super::Entry;
use super::funnel::Funnel;
use super::reach::Reach;
use super::slabs::Slabs;
use super::split::{self, Item};
use crate::math::{Bounds, Ray};

/// Boxes in boxes around the surfaces that have a [`Reach`]; beside them are those that have none.
///
/// Surfaces go by their places in the list.
#[derive(Debug)]
pub(super) struct Tree {
    nodes: Vec<Node>,
    /// The surfaces of all leaves.
    inside: Vec<u32>,
    /// The surfaces that have no reach: those without end, and slivers.
    beside: Vec<u32>,
    /// Where the coordinates of the boxes start.
    center: DVec3,
    /// How far at most a face is from there, summed over the axes.
    extent: f64,
    /// The largest [`Reach::sharpness`].
    sharpness: f64,
}

/// A box with what is in it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    pub(super) bounds: Bounds,
    pub(super) content: Content,
}

/// What is in a box.
#[derive(Debug, Clone, Copy)]
pub(super) enum Content {
    /// Two boxes, this one and the next.
    Boxes(u32),
    /// Surfaces: from the first up to but not the second.
    Surfaces(u32, u32),
}

impl Tree {
    /// The tree of these surfaces; the same for the same surfaces.
    pub(super) fn new(entries: &[Entry<'_>]) -> Self {
        let reaches: Vec<_> = entries.iter().map(Reach::of).collect();
        let numbered = || (0u32..).zip(&reaches);
        let bounded = || numbered().filter_map(|(index, reach)| Some((index, (*reach)?)));
        let corners = bounded().flat_map(|(_, reach)| [reach.bounds.min, reach.bounds.max]);
        let all = Bounds::around(corners);
        let center = all.min.midpoint(all.max);
        let mut items: Vec<_> = bounded()
            .map(|(index, Reach { bounds, .. })| {
                let bounds = Bounds {
                    min: bounds.min - center,
                    max: bounds.max - center,
                };
                Item { index, bounds }
            })
            .collect();
        let nodes = split::nodes(&mut items);
        Self {
            nodes,
            inside: items.iter().map(|item| item.index).collect(),
            beside: numbered()
                .filter(|(_, reach)| reach.is_none())
                .map(|(index, _)| index)
                .collect(),
            center,
            extent: (all.max - center)
                .abs()
                .max((all.min - center).abs())
                .element_sum(),
            sharpness: bounded()
                .map(|(_, reach)| reach.sharpness)
                .fold(1.0, f64::max),
        }
    }

    /// Asks all surfaces that rays from where a ray starts to a ball around a lamp may meet; `ask` says
    /// whether the others matter.
    pub(super) fn walk_toward(
        &self,
        ray: &Ray,
        lamp: (DVec3, f64),
        mut ask: impl FnMut(usize) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let funnel = Funnel::new(ray, lamp, self.center, self.extent, self.sharpness);
        let mut ask_all = |indices: &[u32]| {
            let mut indices = indices.iter();
            indices.try_for_each(|index| ask(*index as usize))
        };
        ask_all(&self.beside)?;
        let mut waiting = Vec::from_iter((!self.nodes.is_empty()).then_some(0));
        while let Some(node) = waiting.pop() {
            let Node { bounds, content } = &self.nodes[node as usize];
            if funnel.misses(bounds) {
                continue;
            }
            match *content {
                Content::Surfaces(first, end) => {
                    ask_all(&self.inside[first as usize..end as usize])?;
                }
                Content::Boxes(first) => waiting.extend([first + 1, first]),
            }
        }
        ControlFlow::Continue(())
    }

    /// Asks all surfaces that a ray may meet up to a distance, the nearer boxes first.
    ///
    /// `ask` takes a surface and the distance, and says up to where the others matter, or that none
    /// does.
    #[inline(always)]
    pub(super) fn walk(
        &self,
        ray: &Ray,
        mut until: f64,
        mut ask: impl FnMut(usize, f64) -> ControlFlow<(), f64>,
    ) {
        for index in &self.beside {
            match ask(*index as usize, until) {
                ControlFlow::Continue(nearer) => until = nearer,
                ControlFlow::Break(()) => return,
            }
        }
        let slabs = Slabs::new(ray, self.center, self.extent, self.sharpness);
        let enters = |node: u32| slabs.entry(&self.nodes[node as usize].bounds);
        let mut waiting = [(0, 0.0); split::DEEPEST + 1];
        let mut count = 0;
        if !self.nodes.is_empty()
            && let Some(distance) = enters(0)
        {
            waiting[0] = (0, distance);
            count = 1;
        }
        while count > 0 {
            count -= 1;
            let (node, distance) = waiting[count];
            if distance > until {
                continue;
            }
            match self.nodes[node as usize].content {
                Content::Surfaces(first, end) => {
                    for index in &self.inside[first as usize..end as usize] {
                        match ask(*index as usize, until) {
                            ControlFlow::Continue(nearer) => until = nearer,
                            ControlFlow::Break(()) => return,
                        }
                    }
                }
                Content::Boxes(first) => {
                    let mut push = |node, distance: Option<f64>| {
                        if let Some(distance) = distance.filter(|distance| *distance <= until) {
                            waiting[count] = (node, distance);
                            count += 1;
                        }
                    };
                    let (one, other) = (enters(first), enters(first + 1));
                    // What is pushed last is asked first.
                    if one.unwrap_or(f64::MAX) < other.unwrap_or(f64::MAX) {
                        push(first + 1, other);
                        push(first, one);
                    } else {
                        push(first, one);
                        push(first + 1, other);
                    }
                }
            }
        }
    }
}
