//! The occluders between a hit and a light.

use std::ops::ControlFlow;

use glam::DVec2;

use super::light_view::{Candidate, Emitter, Occluder, Receiver};
use super::occluder_bound::HiddenPart;
use super::occluder_tree::OccluderTree;
use super::shadow_rect::ShadowRect;
use super::transmittance::transmittance;
use crate::geometry::Hit;
use crate::math::{Ray, Rgb, Segment};
use crate::surface::Lamp;

/// The part of a light that is hidden from a hit.
#[derive(Debug)]
pub enum Occlusion<'v, 'a> {
    /// Nothing of it.
    None,
    /// Possibly some of it; shadow rays decide.
    Partial(Occluders<'v, 'a>),
    /// All of it.
    Full,
}

/// The occluders that may lie between a hit and a light.
#[derive(Debug)]
pub struct Occluders<'v, 'a> {
    receiver: Receiver<'v, 'a>,
    /// The coordinates of the hit, which shadow rectangles are compared with.
    uv: DVec2,
    choice: Choice<'v>,
}

/// The occluders that are tested for each shadow ray.
#[derive(Debug)]
enum Choice<'v> {
    /// Candidates, of which the first has passed the quick tests.
    Candidates(&'v [Candidate]),
    /// Occluders by index, in file order.
    Indices(Vec<usize>),
    /// The occluders that a tree finds.
    Tree(&'v OccluderTree),
}

/// The largest number of a lamp's occluders that are tested without the tree.
///
/// With a smaller limit, trees are walked for few occluders. With a larger one, each ray tests many
/// occluders that it misses.
const FEW: usize = 8;

impl<'v, 'a> Receiver<'v, 'a> {
    /// Returns whether shadows fall on the surface: the chapter's `light_visible` test.
    #[must_use]
    #[inline(always)]
    pub fn is_shadowed(&self) -> bool {
        self.primitive.common.shadows.receive
    }

    /// The part of the light that is hidden from a hit, from which a ray starts.
    ///
    #[must_use]
    #[inline(always)]
    pub fn occlusion(self, hit: &Hit, ray: &Ray) -> Occlusion<'v, 'a> {
        let choice = match self.view.emitter {
            Emitter::Point(_) => self.before_point(hit.uv, ray),
            Emitter::Lamp(lamp, ..) => match self.before_lamp(lamp, ray) {
                ControlFlow::Continue(choice) => choice,
                ControlFlow::Break(()) => return Occlusion::Full,
            },
        };
        choice.map_or(Occlusion::None, |choice| {
            Occlusion::Partial(Occluders {
                receiver: self,
                uv: hit.uv,
                choice,
            })
        })
    }

    /// The occluders between a hit and a point light; `None` if there are none.
    #[inline(always)]
    fn before_point(self, uv: DVec2, ray: &Ray) -> Option<Choice<'v>> {
        let mut candidates = self.candidates;
        if candidates.is_empty() {
            return None;
        }
        if let Some(tree) = &self.view.tree {
            // A walk tests less than the whole list.
            return Some(Choice::Tree(tree));
        }
        while let [first, others @ ..] = candidates {
            if first.is_in_question(uv, ray) {
                return Some(Choice::Candidates(candidates));
            }
            candidates = others;
        }
        None
    }

    /// The occluders between a hit and a lamp.
    ///
    /// `None` if there are none; a break if the whole lamp is hidden.
    // Never inlined, because the code of point lights is hot.
    #[inline(never)]
    fn before_lamp(self, lamp: &Lamp, ray: &Ray) -> ControlFlow<(), Option<Choice<'v>>> {
        let view = self.view;
        let left = ray.leaves();
        let (mut few, mut are_many, mut is_hidden) = (Vec::new(), false, false);
        let mut visit = |place: usize| {
            let occluder = &view.occluders[place];
            if occluder.primitive.lies_on(left) {
                return ControlFlow::Continue(());
            }
            if view.tests_all {
                few.push(place);
                return ControlFlow::Continue(());
            }
            match occluder.bound.hidden_part(ray) {
                HiddenPart::None => {}
                HiddenPart::Full if occluder.is_opaque && view.is_open => {
                    is_hidden = true;
                    return ControlFlow::Break(());
                }
                HiddenPart::Full | HiddenPart::Partial => few.push(place),
            }
            are_many = view.tree.is_some() && few.len() > FEW;
            if are_many {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        let walked = match &view.tree {
            Some(tree) if !self.candidates.is_empty() => {
                let ball = (lamp.center().world(), lamp.radius());
                tree.walk_toward(ray, ball, visit)
            }
            _ => self.candidates.iter().try_for_each(|it| visit(it.occluder)),
        };
        if is_hidden {
            return ControlFlow::Break(());
        }
        // A walk that stopped early has found many.
        debug_assert!(walked.is_continue() || are_many, "a break has a reason");
        if few.is_empty() && !view.tests_all {
            return ControlFlow::Continue(None);
        }
        if let Some(tree) = view.tree.as_ref().filter(|_| are_many) {
            return ControlFlow::Continue(Some(Choice::Tree(tree)));
        }
        few.sort_unstable();
        ControlFlow::Continue(Some(Choice::Indices(few)))
    }
}

impl Candidate {
    /// Returns whether a ray from these coordinates to the light can hit the occluder.
    #[inline(always)]
    fn is_in_question(&self, uv: DVec2, ray: &Ray) -> bool {
        let is_missed = |shadow: &ShadowRect| shadow.is_missed(uv, ray);
        let left = ray.leaves();
        let is_left = left.is_some() && self.carrier == left;
        !is_left && !self.shadow.as_ref().is_some_and(is_missed)
    }
}

impl<'a> Occluders<'_, 'a> {
    /// The share of light that passes along a segment to a point of the light.
    ///
    /// Opaque surfaces block it. Transparent ones tint it, each once. On each carrier, only the
    /// first surface in the file counts. `tests` grows by the number of surfaces that are tested.
    #[must_use]
    pub fn transmittance(&self, segment: &Segment, tests: &mut u64) -> Rgb {
        let mut hides = |occluder: &Occluder<'a>| {
            *tests += 1;
            self.hides(occluder, segment)
        };
        let occluders = &self.receiver.view.occluders;
        match &self.choice {
            Choice::Candidates(candidates) => {
                let (first, others) = candidates.split_at(1);
                let others = others
                    .iter()
                    .filter(|it| it.is_in_question(self.uv, &segment.ray));
                let all = first.iter().chain(others).map(|it| &occluders[it.occluder]);
                let hiding = all.filter(|occluder| hides(occluder));
                transmittance(hiding.map(|occluder| &occluder.primitive), segment)
            }
            Choice::Indices(places) => {
                let all = places.iter().map(|place| &occluders[*place]);
                let hiding = all.filter(|occluder| hides(occluder));
                transmittance(hiding.map(|occluder| &occluder.primitive), segment)
            }
            Choice::Tree(tree) => self.transmittance_of(tree, segment, hides),
        }
    }

    /// The share of light that passes the occluders that a tree finds along a segment.
    fn transmittance_of(
        &self,
        tree: &OccluderTree,
        segment: &Segment,
        mut hides: impl FnMut(&Occluder<'a>) -> bool,
    ) -> Rgb {
        // A point of a lamp can lie on an occluder's plane; rounding can put the hit beyond it.
        let distance = self.receiver.view.distance;
        let until = distance.map_or(f64::MAX, |distance| distance.until(segment));
        let left = segment.ray.leaves();
        let mut hiding = Vec::new();
        let mut is_blocked = false;
        tree.walk(&segment.ray, until, |place| {
            let occluder = &self.receiver.view.occluders[place];
            if occluder.primitive.lies_on(left) || !hides(occluder) {
                return ControlFlow::Continue(());
            }
            hiding.push(&occluder.primitive);
            is_blocked = occluder.is_opaque;
            if is_blocked {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        if is_blocked {
            return Rgb::BLACK;
        }
        hiding.sort_unstable_by_key(|primitive| primitive.index);
        transmittance(hiding.into_iter(), segment)
    }

    /// Returns whether an occluder hides one end of a segment from the other.
    #[inline]
    fn hides(&self, occluder: &Occluder<'a>, segment: &Segment) -> bool {
        let primitive = &occluder.primitive;
        let side = occluder
            .side
            .unwrap_or_else(|| primitive.side(&segment.end));
        let view = self.receiver.view;
        primitive.hides(segment, side, || {
            let receiver = view.silhouettes.of(self.receiver.primitive);
            let silhouette = view.silhouettes.of(primitive);
            silhouette.can_hide(&view.silhouette, receiver)
        })
    }
}
