//! The search for occluders among very many surfaces.

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::DVec3;

use super::tree::Tree;
use crate::math::Ray;

/// A tree of surfaces, some of which are occluders of a light.
#[derive(Debug)]
pub(super) struct OccluderTree {
    tree: Arc<Tree>,
    /// For every surface its place in the list of occluders.
    occluders: Vec<Option<u32>>,
}

impl OccluderTree {
    /// A tree of so many surfaces, whose occluders are these.
    pub(super) fn new(
        tree: &Arc<Tree>,
        count: usize,
        occluders: impl Iterator<Item = usize>,
    ) -> Self {
        let mut places = vec![None; count];
        for (place, surface) in (0..).zip(occluders) {
            places[surface] = Some(place);
        }
        Self {
            tree: tree.clone(),
            occluders: places,
        }
    }

    /// Visits the occluders, by their places, that a ray may hit up to a distance.
    ///
    /// `visit` says whether the others matter.
    pub(super) fn walk(
        &self,
        ray: &Ray,
        until: f64,
        mut visit: impl FnMut(usize) -> ControlFlow<()>,
    ) {
        self.tree.walk(ray, until, |surface, until| {
            if let Some(place) = self.occluders[surface] {
                visit(place as usize)?;
            }
            ControlFlow::Continue(until)
        });
    }

    /// Visits the occluders, by their places, that rays to a ball around a lamp may hit.
    ///
    /// `visit` says whether the others matter.
    pub(super) fn walk_toward(
        &self,
        ray: &Ray,
        lamp: (DVec3, f64),
        mut visit: impl FnMut(usize) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        self.tree.walk_toward(ray, lamp, |surface| {
            self.occluders[surface].map_or(ControlFlow::Continue(()), |place| visit(place as usize))
        })
    }
}
