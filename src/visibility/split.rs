//! How a tree of boxes is built.

use std::ops::Range;

use glam::DVec3;

use super::node::{Content, Node};
use crate::math::Bounds;

/// A surface with its box.
#[derive(Debug, Clone, Copy)]
pub(super) struct Item {
    pub(super) index: u32,
    pub(super) bounds: Bounds,
}

/// The most boxes around a surface: those before halving begins, and those in which 2³² surfaces are
/// halved until each is alone.
pub(super) const DEEPEST: usize = HALVED_FROM + 33;

/// From this depth on boxes are cut into two with equally many surfaces. Smaller, and scenes with
/// much detail in one place get bad trees; larger, and a walk needs more memory.
const HALVED_FROM: usize = 32;

/// The most surfaces for which cutting a box further is not considered.
const FEW: usize = 2;

/// The most surfaces in a leaf, but for those in one place.
const MOST: usize = 8;

/// How many equal parts of an axis a cut may lie between. Fewer, and trees get worse; more, and building
/// takes longer.
const BINS: usize = 16;

/// What passing a box costs, in units of asking a surface.
const COST_OF_BOX: f64 = 0.7;

/// A box that may be cut: the place of its node, its items, and its depth.
type Task = (usize, Range<usize>, usize);

/// The nodes of a tree, the root first; the items are put into the order of the leaves, and in a leaf they
/// keep their own.
///
/// Cuts are chosen by the surface area heuristic, in bins along each axis (Wald 2007, "On fast
/// Construction of SAH-based Bounding Volume Hierarchies").
pub(super) fn nodes(items: &mut [Item]) -> Vec<Node> {
    let mut nodes = Vec::with_capacity(items.len());
    if items.is_empty() {
        return nodes;
    }
    nodes.push(leaf(items, 0..items.len()));
    let mut tasks: Vec<Task> = vec![(0, 0..items.len(), 0)];
    while let Some((place, range, depth)) = tasks.pop() {
        let bounds = nodes[place].bounds;
        let Some(left) = cut(&mut items[range.clone()], &bounds, depth) else {
            items[range].sort_unstable_by_key(|item| item.index);
            continue;
        };
        let middle = range.start + left;
        let first = nodes.len();
        for (next, part) in [range.start..middle, middle..range.end]
            .into_iter()
            .enumerate()
        {
            nodes.push(leaf(items, part.clone()));
            tasks.push((first + next, part, depth + 1));
        }
        nodes[place].content = Content::Boxes(small(first));
    }
    nodes
}

fn leaf(items: &[Item], range: Range<usize>) -> Node {
    Node {
        bounds: around(&items[range.clone()]),
        content: Content::Surfaces(small(range.start), small(range.end)),
    }
}

fn around(items: &[Item]) -> Bounds {
    Bounds::around(
        items
            .iter()
            .flat_map(|item| [item.bounds.min, item.bounds.max]),
    )
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "no scene has 2^32 surfaces"
)]
fn small(place: usize) -> u32 {
    place as u32
}

/// Cuts items into two parts and puts those of the first part in front; gives their number, or `None`
/// if they are better left in one leaf.
fn cut(items: &mut [Item], bounds: &Bounds, depth: usize) -> Option<usize> {
    if items.len() <= FEW {
        return None;
    }
    let centers = Bounds::around(items.iter().map(Item::center));
    let size = centers.max - centers.min;
    // What lies in one place cannot be told apart by boxes.
    if size.max_element() <= 0.0 {
        return None;
    }
    if depth >= HALVED_FROM {
        let axis = size.max_position();
        let by_center = |a: &Item, b: &Item| {
            let order = a.center()[axis].total_cmp(&b.center()[axis]);
            order.then(a.index.cmp(&b.index))
        };
        let half = items.len() / 2;
        items.select_nth_unstable_by(half, by_center);
        return Some(half);
    }
    let (cost, axis, bin) = (0..3)
        .filter(|axis| size[*axis] > 0.0)
        .flat_map(|axis| costs(items, &centers, bounds, axis))
        .min_by(|a, b| a.0.total_cmp(&b.0))?;
    let uncut = area(bounds, bounds) * (count(items.len()) - COST_OF_BOX);
    if cost >= uncut && items.len() <= MOST {
        return None;
    }
    let mut left = 0;
    for index in 0..items.len() {
        if items[index].bin(&centers, axis) < bin {
            items.swap(left, index);
            left += 1;
        }
    }
    Some(left)
}

/// What asking the two parts costs, with the axis of the cut and the bin that the second part begins
/// with, for each bin that it can begin with.
fn costs(
    items: &[Item],
    centers: &Bounds,
    whole: &Bounds,
    axis: usize,
) -> Vec<(f64, usize, usize)> {
    let mut bins: [(usize, Option<Bounds>); BINS] = [(0, None); BINS];
    for item in items {
        let (number, bounds) = &mut bins[item.bin(centers, axis)];
        *number += 1;
        *bounds = Some(join(*bounds, item.bounds));
    }
    let below = sums(bins.iter(), whole);
    let mut above = sums(bins.iter().rev(), whole);
    above.reverse();
    let parts = (1..BINS).filter(|bin| (1..items.len()).contains(&below[bin - 1].0));
    parts
        .map(|bin| (below[bin - 1].1 + above[bin].1, axis, bin))
        .collect()
}

/// Of everything up to each bin: the number, and the area times the number.
fn sums<'b>(
    bins: impl Iterator<Item = &'b (usize, Option<Bounds>)>,
    whole: &Bounds,
) -> Vec<(usize, f64)> {
    let mut sum: (usize, Option<Bounds>) = (0, None);
    bins.map(|(number, bounds)| {
        sum.0 += number;
        sum.1 = bounds.map_or(sum.1, |bounds| Some(join(sum.1, bounds)));
        let area = sum.1.map_or(0.0, |bounds| area(&bounds, whole));
        (sum.0, area * count(sum.0))
    })
    .collect()
}

fn join(one: Option<Bounds>, other: Bounds) -> Bounds {
    one.map_or(other, |one| Bounds {
        min: one.min.min(other.min),
        max: one.max.max(other.max),
    })
}

/// Half of the surface of a box, in units of the longest side of the whole, squared.
fn area(bounds: &Bounds, whole: &Bounds) -> f64 {
    let unit = (whole.max - whole.min).max_element();
    let DVec3 { x, y, z } = (bounds.max - bounds.min) / unit;
    x * y + y * z + z * x
}

#[expect(
    clippy::cast_precision_loss,
    reason = "numbers of surfaces are far below 2^53"
)]
fn count(number: usize) -> f64 {
    number as f64
}

impl Item {
    fn center(&self) -> DVec3 {
        self.bounds.min.midpoint(self.bounds.max)
    }

    /// Which of the equal parts of an axis its centre lies in.
    fn bin(&self, centers: &Bounds, axis: usize) -> usize {
        let place = self.center()[axis] - centers.min[axis];
        let share = place / (centers.max[axis] - centers.min[axis]);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_precision_loss,
            clippy::cast_sign_loss,
            reason = "a share from 0 to 1 of a few bins"
        )]
        let bin = (share * BINS as f64) as usize;
        bin.min(BINS - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The deepest leaf of a tree of these points and the largest, once each point is found in one leaf.
    fn deepest_and_largest(places: &[DVec3]) -> (usize, usize) {
        let bounds = |place: &DVec3| Bounds {
            min: *place,
            max: *place,
        };
        let numbered = (0..).zip(places.iter().map(bounds));
        let mut items: Vec<_> = numbered
            .map(|(index, bounds)| Item { index, bounds })
            .collect();
        let nodes = nodes(&mut items);
        let mut found = vec![false; places.len()];
        let (mut deepest, mut largest) = (0, 0);
        let mut waiting = vec![(0, 0)];
        while let Some((node, depth)) = waiting.pop() {
            match nodes[node as usize].content {
                Content::Boxes(first) => {
                    waiting.extend([(first, depth + 1), (first + 1, depth + 1)]);
                }
                Content::Surfaces(first, end) => {
                    for item in &items[first as usize..end as usize] {
                        assert!(!std::mem::replace(&mut found[item.index as usize], true));
                    }
                    deepest = deepest.max(depth);
                    largest = largest.max((end - first) as usize);
                }
            }
        }
        assert!(found.into_iter().all(|found| found));
        (deepest, largest)
    }

    const MANY: usize = 100_000;

    /// So crowded towards the origin that every cut in bins takes off few points only.
    fn crowded() -> impl Iterator<Item = DVec3> {
        (0..MANY).map(|number| DVec3::splat(libm::exp2(count(number) / -100.0)))
    }

    #[test]
    fn what_lies_in_one_place_is_one_leaf() {
        let places = vec![DVec3::new(3.0, -2.0, 0.1); MANY];
        assert_eq!(deepest_and_largest(&places), (0, MANY));
    }

    #[test]
    fn no_crowd_makes_a_tree_deeper_than_a_walk_has_room_for() {
        let places: Vec<_> = crowded().collect();
        let (deepest, largest) = deepest_and_largest(&places);
        assert!((HALVED_FROM + 10..=DEEPEST).contains(&deepest), "{deepest}");
        assert!(largest <= MOST, "{largest}");
    }

    #[test]
    fn a_pile_in_a_crowd_is_one_leaf_no_deeper_than_others() {
        let places: Vec<_> = crowded().chain(vec![DVec3::ZERO; MANY]).collect();
        let (deepest, largest) = deepest_and_largest(&places);
        assert!((HALVED_FROM..=DEEPEST).contains(&deepest), "{deepest}");
        assert!(largest <= MANY, "{largest}");
    }
}
