//! Overlap queries among many boxes.

use super::node::{Content, Node};
use super::split::{self, Item};
use crate::math::Bounds;

/// A hierarchy of boxes that answers overlap queries.
#[derive(Debug)]
pub struct Overlaps {
    nodes: Vec<Node>,
    /// The lowest index of the boxes in each node.
    firsts: Vec<u32>,
    items: Vec<Item>,
}

impl Overlaps {
    /// The hierarchy of a list; entries without a box overlap nothing.
    #[must_use]
    pub fn new(boxes: &[Option<Bounds>]) -> Self {
        let numbered = (0u32..).zip(boxes);
        let mut items: Vec<_> = numbered
            .filter_map(|(index, bounds)| {
                Some(Item {
                    index,
                    bounds: (*bounds)?,
                })
            })
            .collect();
        let nodes = split::nodes(&mut items);
        let mut firsts = vec![u32::MAX; nodes.len()];
        // Children are stored after their parent.
        for (index, node) in nodes.iter().enumerate().rev() {
            firsts[index] = match node.content {
                Content::Boxes(inner) => firsts[inner as usize].min(firsts[inner as usize + 1]),
                Content::Surfaces(first, _) => items[first as usize].index,
            };
        }
        Self {
            nodes,
            firsts,
            items,
        }
    }

    /// The first index below `index` that satisfies `is_true`, and whose box touches.
    ///
    /// `None` if there is none.
    pub fn first_before(
        &self,
        index: usize,
        bounds: &Bounds,
        is_true: impl Fn(usize) -> bool,
    ) -> Option<usize> {
        let mut best = index;
        let mut waiting = Vec::from_iter((!self.nodes.is_empty()).then_some(0));
        while let Some(node) = waiting.pop() {
            let first = self.firsts[node] as usize;
            if first >= best || !self.nodes[node].bounds.touches(bounds) {
                continue;
            }
            match self.nodes[node].content {
                Content::Boxes(inner) => {
                    let inner = inner as usize;
                    let mut both = [inner, inner + 1];
                    // The node that is pushed last is visited first.
                    both.sort_unstable_by_key(|node| std::cmp::Reverse(self.firsts[*node]));
                    waiting.extend(both);
                }
                Content::Surfaces(first, end) => {
                    let here = self.items[first as usize..end as usize].iter();
                    let earlier = here.take_while(|item| (item.index as usize) < best);
                    let mut touching = earlier.filter(|item| item.bounds.touches(bounds));
                    let found = touching.find(|item| is_true(item.index as usize));
                    best = found.map_or(best, |item| item.index as usize);
                }
            }
        }
        (best < index).then_some(best)
    }
}
