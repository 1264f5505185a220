//! Construction of a bounding volume hierarchy by the surface area heuristic.

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

/// The largest depth of a leaf.
///
/// [`HALVING_DEPTH`] levels, and those in which 2³² surfaces are halved until each has its own
/// leaf.
pub(super) const MAX_DEPTH: usize = HALVING_DEPTH + 33;

/// The depth from which nodes are split at the median.
///
/// With a smaller value, scenes with dense detail in one place get bad trees. With a larger one, a
/// traversal needs more memory.
const HALVING_DEPTH: usize = 32;

/// The largest number of surfaces that are never split.
const MAX_UNSPLIT: usize = 2;

/// The largest number of surfaces in a leaf, unless their centres coincide.
const MAX_LEAF: usize = 8;

/// The number of bins along an axis; splits lie between bins.
///
/// Fewer bins make worse trees. More bins take longer to build.
const BINS: usize = 16;

/// The cost of a box test, in units of a surface test.
const BOX_COST: f64 = 0.7;

/// A node that may be split: its index, its items, and its depth.
type Task = (usize, Range<usize>, usize);

/// The nodes of a tree, the root first.
///
/// The items are reordered by leaf; in a leaf they are sorted by index. Splits are chosen by the
/// surface area heuristic, in bins along each axis (Wald 2007, "On fast Construction of SAH-based
/// Bounding Volume Hierarchies").
pub(super) fn nodes(items: &mut [Item]) -> Vec<Node> {
    let mut nodes = Vec::with_capacity(items.len());
    if items.is_empty() {
        return nodes;
    }
    nodes.push(leaf(items, 0..items.len()));
    let mut tasks: Vec<Task> = vec![(0, 0..items.len(), 0)];
    while let Some((node, range, depth)) = tasks.pop() {
        let bounds = nodes[node].bounds;
        let Some(left) = partition(&mut items[range.clone()], &bounds, depth) else {
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
        nodes[node].content = Content::Boxes(to_u32(first));
    }
    nodes
}

fn leaf(items: &[Item], range: Range<usize>) -> Node {
    Node {
        bounds: around(&items[range.clone()]),
        content: Content::Surfaces(to_u32(range.start), to_u32(range.end)),
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
fn to_u32(number: usize) -> u32 {
    number as u32
}

/// Partitions items in two, and returns the size of the first part.
///
/// `None` if they stay in one leaf.
fn partition(items: &mut [Item], bounds: &Bounds, depth: usize) -> Option<usize> {
    if items.len() <= MAX_UNSPLIT {
        return None;
    }
    let centers = Bounds::around(items.iter().map(Item::center));
    let size = centers.max - centers.min;
    // Boxes do not separate items whose centres coincide.
    if size.max_element() <= 0.0 {
        return None;
    }
    if depth >= HALVING_DEPTH {
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
    let unsplit = area(bounds, bounds) * (count(items.len()) - BOX_COST);
    if cost >= unsplit && items.len() <= MAX_LEAF {
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

/// The cost of each split along an axis, with the axis and the split's upper bin.
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

/// Prefix sums over bins: the number of items, and that number times their area.
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

/// Half of the surface area of a box, in units of the whole's longest side squared.
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

    /// The bin that its centre lies in.
    fn bin(&self, centers: &Bounds, axis: usize) -> usize {
        let offset = self.center()[axis] - centers.min[axis];
        let share = offset / (centers.max[axis] - centers.min[axis]);
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

    /// The depth of the deepest leaf and the size of the largest in a tree of points.
    ///
    /// Asserts that each point is in exactly one leaf.
    fn deepest_and_largest(points: &[DVec3]) -> (usize, usize) {
        let bounds = |point: &DVec3| Bounds {
            min: *point,
            max: *point,
        };
        let numbered = (0..).zip(points.iter().map(bounds));
        let mut items: Vec<_> = numbered
            .map(|(index, bounds)| Item { index, bounds })
            .collect();
        let nodes = nodes(&mut items);
        let mut found = vec![false; points.len()];
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

    /// Points so dense near the origin that every binned split separates only a few.
    fn crowded() -> impl Iterator<Item = DVec3> {
        (0..MANY).map(|number| DVec3::splat(libm::exp2(count(number) / -100.0)))
    }

    #[test]
    fn what_lies_in_one_place_is_one_leaf() {
        let points = vec![DVec3::new(3.0, -2.0, 0.1); MANY];
        assert_eq!(deepest_and_largest(&points), (0, MANY));
    }

    #[test]
    fn no_crowd_makes_a_tree_deeper_than_a_walk_has_room_for() {
        let points: Vec<_> = crowded().collect();
        let (deepest, largest) = deepest_and_largest(&points);
        assert!(
            (HALVING_DEPTH + 10..=MAX_DEPTH).contains(&deepest),
            "{deepest}"
        );
        assert!(largest <= MAX_LEAF, "{largest}");
    }

    #[test]
    fn a_pile_in_a_crowd_is_one_leaf_no_deeper_than_others() {
        let points: Vec<_> = crowded().chain(vec![DVec3::ZERO; MANY]).collect();
        let (deepest, largest) = deepest_and_largest(&points);
        assert!((HALVING_DEPTH..=MAX_DEPTH).contains(&deepest), "{deepest}");
        assert!(largest <= MANY, "{largest}");
    }
}
