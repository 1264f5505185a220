//! What stands in the way of a lamp.

use std::collections::HashSet;
use std::ops::ControlFlow;

use glam::DVec3;

use super::caster_tree::{CasterTree, passed};
use super::receivers::Body;
use super::shields::{Shield, Stand};
use super::{Entry, MOST_LISTS, SurfaceList};
use crate::math::{Ray, Rgb, Segment, Side};
use crate::surface::{Lamp, Surface};

/// A scene's surfaces as one lamp has them before it.
#[derive(Debug)]
pub struct LampView<'a> {
    /// The lamp.
    pub lamp: &'a Lamp,
    body: Body,
    /// Everything that can cast a shadow, in file order.
    casters: Vec<Caster<'a>>,
    /// Lists of them, by their places, of which each serves one surface or more.
    lists: Vec<Vec<usize>>,
    /// For every surface which of the lists counts for it; `None` if nothing of the lamp is before
    /// its plane, or nothing of it before the lamp's.
    list_of: Vec<Option<usize>>,
    /// What finds the casters if all surfaces share one list.
    tree: Option<CasterTree>,
    /// The middle of the lamp, and how far it reaches from there.
    ball: (DVec3, f64),
    /// Whether places are asked where the answer is known.
    asks_all: bool,
}

/// A surface that can cast a shadow.
#[derive(Debug)]
struct Caster<'a> {
    entry: Entry<'a>,
    /// The side of the surface that all of the lamp is on, but for what touches it.
    side: Option<Side>,
    shield: Shield,
    /// Whether nothing passes where it stands.
    is_opaque: bool,
}

/// What may stand between a lamp and a place.
#[derive(Debug)]
pub enum Between<'v, 'a> {
    /// Nothing.
    Nothing,
    /// Something that hides all of it.
    Wall,
    /// Some of these.
    Some(Casters<'v, 'a>),
}

/// The surfaces that may stand between a lamp and a place.
#[derive(Debug)]
pub struct Casters<'v, 'a> {
    lamp: &'v Body,
    from: &'v Entry<'a>,
    /// Those that are asked one by one, in file order.
    few: Vec<&'v Caster<'a>>,
    /// All casters of a lamp and what finds them, if there are more.
    many: Option<(&'v [Caster<'a>], &'v CasterTree)>,
}

/// The most surfaces that are asked one by one for each ray to a lamp if there is a tree. Smaller, and few
/// are searched for as if they were many; larger, and each ray asks more than it meets.
const FEW: usize = 8;

impl<'a> LampView<'a> {
    /// What the lamps of a scene have before them; `scene` are the surfaces as they were read, which
    /// the list may have in another form.
    ///
    /// With `asks_all` nothing is left out that is known to hide nothing, or all: the answers are the
    /// same, and take longer.
    #[must_use]
    pub fn all(
        surfaces: &SurfaceList<'a>,
        scene: &'a [Box<dyn Surface>],
        asks_all: bool,
    ) -> Vec<Self> {
        let lamps = surfaces.entries().iter().zip(scene);
        let mut lamps = lamps
            .filter_map(|(entry, surface)| Some((entry, surface.lamp()?)))
            .peekable();
        if lamps.peek().is_none() {
            return Vec::new();
        }
        let bodies: Vec<_> = surfaces.entries().iter().map(Body::of).collect();
        lamps
            .map(|(entry, lamp)| Self::new(surfaces, &bodies, (entry, lamp), asks_all))
            .collect()
    }

    fn new(
        surfaces: &SurfaceList<'a>,
        bodies: &[Body],
        (own, lamp): (&Entry<'a>, &'a Lamp),
        asks_all: bool,
    ) -> Self {
        let body = Body::of_surface(lamp, own.support);
        let others = surfaces.entries().iter().filter(|entry| {
            entry.index != own.index && !entry.lies_on(own.support) && entry.common.shadows.cast
        });
        let mut panes = HashSet::new();
        let casters = others.map(|entry| {
            let is_opaque = entry.common.material.transparency == 0.0;
            // Behind a pane on the same sheet a wall does not count.
            let is_first = !entry
                .support
                .is_some_and(|support| panes.contains(&support));
            panes.extend(entry.support.filter(|_| !is_opaque));
            let shield = Shield::new(entry.surface, &bodies[entry.index], lamp, &body);
            Caster {
                entry: *entry,
                side: shield.side_of_lamp(),
                shield,
                is_opaque: is_opaque && is_first,
            }
        });
        let casters: Vec<_> = casters.collect();
        let shares_list = bodies.len() > MOST_LISTS;
        let tree = surfaces.tree.as_ref().filter(|_| shares_list && !asks_all);
        let mut view = Self {
            lamp,
            body,
            lists: vec![(0..casters.len()).collect()],
            list_of: vec![None; bodies.len()],
            tree: tree.map(|tree| {
                let entries = casters.iter().map(|caster| &caster.entry);
                CasterTree::new(tree, bodies.len(), entries)
            }),
            casters,
            ball: (lamp.center().world(), lamp.reach()),
            asks_all,
        };
        for (index, receiver) in bodies.iter().enumerate() {
            if !(view.body.is_before(receiver) && receiver.is_before(&view.body)) {
                continue;
            }
            view.list_of[index] = Some(0);
            if !asks_all && !shares_list {
                view.list_of[index] = Some(view.lists.len());
                let can_hide = |caster: &usize| {
                    let Caster { entry, shield, .. } = &view.casters[*caster];
                    bodies[entry.index].can_hide_lamp(&view.body, receiver)
                        && !shield.hides_nothing_from(receiver)
                };
                let list = view.lists[0].iter().copied().filter(can_hide).collect();
                view.lists.push(list);
            }
        }
        view
    }

    /// Forgets the surfaces, by their places in the list, that the lamp is not to light.
    pub fn retain(&mut self, lights: impl Fn(usize) -> bool) {
        for (surface, list) in self.list_of.iter_mut().enumerate() {
            *list = list.filter(|_| lights(surface));
        }
    }

    /// Whether some of the lamp lies strictly before a surface's plane, or the surface is not flat.
    #[must_use]
    pub fn is_before(&self, surface: &dyn Surface) -> bool {
        self.body.is_before(&Body::of_surface(surface, None))
    }

    /// The surfaces, by their places in the list, that can stand between the lamp and this one.
    #[must_use]
    pub fn casters_of(&self, surface: usize) -> Vec<usize> {
        let list = self.list_of[surface].map_or(&[][..], |list| &self.lists[list]);
        let casters = list.iter().map(|caster| &self.casters[*caster]);
        casters.map(|caster| caster.entry.index).collect()
    }

    /// The side of a surface, by its place in the list, that all of the lamp is on, but for what
    /// touches it; `None` if there is none, or if the surface lies in the lamp's own plane.
    #[must_use]
    pub fn side_of(&self, surface: usize) -> Option<Side> {
        let caster = self.casters.iter().find(|it| it.entry.index == surface);
        caster?.side
    }

    /// Whether light from here can reach the front of a surface at all.
    #[must_use]
    pub fn lights(&self, entry: &Entry<'_>) -> bool {
        self.list_of[entry.index].is_some()
    }

    /// Whether anything can stand between the lamp and some part of a surface, by its place in the
    /// list.
    #[must_use]
    pub fn can_be_hidden_from(&self, surface: usize) -> bool {
        self.list_of[surface].is_some_and(|list| !self.lists[list].is_empty())
    }

    /// What may stand between the lamp and a hit of a surface, from which `ray` starts.
    ///
    /// `is_open` says that nothing but surfaces ends a ray to the lamp.
    #[must_use]
    pub fn between<'v>(
        &'v self,
        entry: &'v Entry<'a>,
        ray: &Ray,
        is_open: bool,
    ) -> Between<'v, 'a> {
        let list = self.list_of[entry.index].map_or(&[][..], |list| &self.lists[list]);
        let left = ray.leaves();
        let (mut few, mut are_many, mut is_hidden) = (Vec::new(), false, false);
        let mut ask = |caster: &'v Caster<'a>| {
            if caster.entry.lies_on(left) {
                return ControlFlow::Continue(());
            }
            if self.asks_all {
                few.push(caster);
                return ControlFlow::Continue(());
            }
            match caster.shield.stands(ray) {
                Stand::Beside => {}
                Stand::Before if caster.is_opaque && is_open => {
                    is_hidden = true;
                    return ControlFlow::Break(());
                }
                Stand::Before | Stand::Doubtful => few.push(caster),
            }
            are_many = self.tree.is_some() && few.len() > FEW;
            if are_many {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        // Whether all were asked does not matter.
        let _ = match &self.tree {
            Some(tree) if !list.is_empty() => {
                tree.ask_toward(ray, self.ball, |place| ask(&self.casters[place]))
            }
            _ => list.iter().try_for_each(|place| ask(&self.casters[*place])),
        };
        if is_hidden {
            return Between::Wall;
        }
        if few.is_empty() && !self.asks_all {
            return Between::Nothing;
        }
        few.sort_unstable_by_key(|caster| caster.entry.index);
        let tree = self.tree.as_ref().filter(|_| are_many);
        Between::Some(Casters {
            lamp: &self.body,
            from: entry,
            few,
            many: tree.map(|tree| (&self.casters[..], tree)),
        })
    }
}

impl Casters<'_, '_> {
    /// The share of light that passes along a segment to one place of the lamp; as
    /// [`Blockers::transmittance`](super::Blockers::transmittance).
    #[must_use]
    pub fn transmittance(&self, segment: &Segment, tests: &mut u64) -> Rgb {
        let mut hides = |Caster { entry, side, .. }: &Caster<'_>| {
            *tests += 1;
            let side = side.unwrap_or_else(|| entry.surface.side(&segment.end));
            let can_hide = || Body::of(entry).can_hide_lamp(self.lamp, &Body::of(self.from));
            entry.hides(segment, side, can_hide)
        };
        let Some((casters, tree)) = self.many else {
            let all = self.few.iter().filter(|caster| hides(caster));
            return passed(all.map(|caster| &caster.entry), segment);
        };
        let left = segment.ray.leaves();
        // A place on a surface's plane may be met beyond the lamp, but for rounding.
        tree.transmittance(segment, f64::MAX, |place| {
            let caster = &casters[place];
            let is_met = !caster.entry.lies_on(left) && hides(caster);
            is_met.then_some((&caster.entry, caster.is_opaque))
        })
    }
}
