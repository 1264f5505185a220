//! The bounding volume hierarchy of surfaces.

use std::ops::ControlFlow;

use glam::DVec3;

use super::light_cone::LightCone;
use super::node::{Content, Node};
use super::padded_bounds::PaddedBounds;
use super::primitive::Primitive;
use super::ray_slabs::RaySlabs;
use super::split::{self, Item};
use crate::math::{Bounds, Ray};

/// A hierarchy of the surfaces with [`PaddedBounds`], and a list of the others.
///
/// Surfaces are numbered by their indices in the scene's list.
#[derive(Debug)]
pub(super) struct Tree {
    nodes: Vec<Node>,
    /// The surfaces of all leaves.
    inside: Vec<u32>,
    /// The surfaces without a box: unbounded ones, and slivers.
    unboxed: Vec<u32>,
    /// The origin of the boxes' coordinates.
    center: DVec3,
    /// The largest distance of a face from there, summed over the axes.
    extent: f64,
    /// The largest [`PaddedBounds::sharpness`].
    sharpness: f64,
}

impl Tree {
    /// The tree of some surfaces.
    pub(super) fn new(primitives: &[Primitive<'_>]) -> Self {
        let padded: Vec<_> = primitives.iter().map(PaddedBounds::of).collect();
        let numbered = || (0u32..).zip(&padded);
        let bounded = || numbered().filter_map(|(index, padded)| Some((index, (*padded)?)));
        let corners = bounded().flat_map(|(_, padded)| [padded.bounds.min, padded.bounds.max]);
        let all = Bounds::around(corners);
        let center = all.min.midpoint(all.max);
        let mut items: Vec<_> = bounded()
            .map(|(index, PaddedBounds { bounds, .. })| {
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
            unboxed: numbered()
                .filter(|(_, padded)| padded.is_none())
                .map(|(index, _)| index)
                .collect(),
            center,
            extent: (all.max - center)
                .abs()
                .max((all.min - center).abs())
                .element_sum(),
            sharpness: bounded()
                .map(|(_, padded)| padded.sharpness)
                .fold(1.0, f64::max),
        }
    }

    /// Visits all surfaces that rays from a ray's origin to a lamp may hit.
    ///
    /// The lamp is given by a ball around it.
    ///
    /// `visit` returns whether the walk goes on.
    pub(super) fn walk_toward(
        &self,
        ray: &Ray,
        lamp: (DVec3, f64),
        mut visit: impl FnMut(usize) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let cone = LightCone::new(ray, lamp, self.center, self.extent, self.sharpness);
        let mut visit_all = |indices: &[u32]| {
            let mut indices = indices.iter();
            indices.try_for_each(|index| visit(*index as usize))
        };
        visit_all(&self.unboxed)?;
        let mut stack = Vec::from_iter((!self.nodes.is_empty()).then_some(0));
        while let Some(node) = stack.pop() {
            let Node { bounds, content } = &self.nodes[node as usize];
            if cone.misses(bounds) {
                continue;
            }
            match *content {
                Content::Surfaces(first, end) => {
                    visit_all(&self.inside[first as usize..end as usize])?;
                }
                Content::Boxes(first) => stack.extend([first + 1, first]),
            }
        }
        ControlFlow::Continue(())
    }

    /// Visits all surfaces that a ray may hit up to a distance, nearer boxes first.
    ///
    /// `visit` takes a surface and the distance. It returns the distance up to which the walk goes
    /// on, or a break to end it.
    #[inline(always)]
    pub(super) fn walk(
        &self,
        ray: &Ray,
        mut until: f64,
        mut visit: impl FnMut(usize, f64) -> ControlFlow<(), f64>,
    ) {
        for index in &self.unboxed {
            match visit(*index as usize, until) {
                ControlFlow::Continue(nearer) => until = nearer,
                ControlFlow::Break(()) => return,
            }
        }
        let slabs = RaySlabs::new(ray, self.center, self.extent, self.sharpness);
        let enters = |node: u32| slabs.entry(&self.nodes[node as usize].bounds);
        let mut stack = [(0, 0.0); split::MAX_DEPTH + 1];
        let mut count = 0;
        if !self.nodes.is_empty()
            && let Some(distance) = enters(0)
        {
            stack[0] = (0, distance);
            count = 1;
        }
        while count > 0 {
            count -= 1;
            let (node, distance) = stack[count];
            if distance > until {
                continue;
            }
            match self.nodes[node as usize].content {
                Content::Surfaces(first, end) => {
                    for index in &self.inside[first as usize..end as usize] {
                        match visit(*index as usize, until) {
                            ControlFlow::Continue(nearer) => until = nearer,
                            ControlFlow::Break(()) => return,
                        }
                    }
                }
                Content::Boxes(first) => {
                    let mut push = |node, distance: Option<f64>| {
                        if let Some(distance) = distance.filter(|distance| *distance <= until) {
                            stack[count] = (node, distance);
                            count += 1;
                        }
                    };
                    let (one, other) = (enters(first), enters(first + 1));
                    // The node that is pushed last is visited first.
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
