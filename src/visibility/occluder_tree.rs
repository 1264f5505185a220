//! The search for occluders in large scenes.

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::DVec3;

use super::tree::Tree;
use crate::math::Ray;

/// A tree of surfaces, some of which are occluders of a light.
#[derive(Debug)]
pub(super) struct OccluderTree {
    tree: Arc<Tree>,
    /// The index of each surface in the list of occluders; `None` if it is not one.
    occluders: Vec<Option<u32>>,
}

impl OccluderTree {
    /// A tree of `count` surfaces, of which these are occluders.
    pub(super) fn new(
        tree: &Arc<Tree>,
        count: usize,
        occluders: impl Iterator<Item = usize>,
    ) -> Self {
        let mut indices = vec![None; count];
        for (index, surface) in (0..).zip(occluders) {
            indices[surface] = Some(index);
        }
        Self {
            tree: tree.clone(),
            occluders: indices,
        }
    }

    /// Visits the occluders, by index, that a ray may hit up to a distance.
    ///
    /// `visit` returns whether the walk goes on.
    pub(super) fn walk(
        &self,
        ray: &Ray,
        until: f64,
        mut visit: impl FnMut(usize) -> ControlFlow<()>,
    ) {
        self.tree.walk(ray, until, |surface, until| {
            if let Some(index) = self.occluders[surface] {
                visit(index as usize)?;
            }
            ControlFlow::Continue(until)
        });
    }

    /// Visits the occluders, by index, that rays to a ball around a lamp may hit.
    ///
    /// `visit` returns whether the walk goes on.
    pub(super) fn walk_toward(
        &self,
        ray: &Ray,
        lamp: (DVec3, f64),
        mut visit: impl FnMut(usize) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        self.tree.walk_toward(ray, lamp, |surface| {
            self.occluders[surface].map_or(ControlFlow::Continue(()), |index| visit(index as usize))
        })
    }
}
