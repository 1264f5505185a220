//! What stands in the way of a lamp.

use super::passage::Passage;
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
    all: Vec<&'v Caster<'a>>,
}

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
        let mut panes = Vec::new();
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
        let mut view = Self {
            lamp,
            body,
            lists: vec![(0..casters.len()).collect()],
            list_of: vec![None; bodies.len()],
            casters,
            asks_all,
        };
        for (index, receiver) in bodies.iter().enumerate() {
            if !(view.body.is_before(receiver) && receiver.is_before(&view.body)) {
                continue;
            }
            view.list_of[index] = Some(0);
            if !asks_all && bodies.len() <= MOST_LISTS {
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
        let casters = list.iter().map(|index| &self.casters[*index]);
        let mut doubtful = Vec::new();
        for caster in casters.filter(|caster| !caster.entry.lies_on(left)) {
            if self.asks_all {
                doubtful.push(caster);
                continue;
            }
            match caster.shield.stands(ray) {
                Stand::Beside => {}
                Stand::Before if caster.is_opaque && is_open => return Between::Wall,
                Stand::Before | Stand::Doubtful => doubtful.push(caster),
            }
        }
        if doubtful.is_empty() && !self.asks_all {
            Between::Nothing
        } else {
            Between::Some(Casters {
                lamp: &self.body,
                from: entry,
                all: doubtful,
            })
        }
    }
}

impl Casters<'_, '_> {
    /// The share of light that passes along a segment to one place of the lamp; as
    /// [`Blockers::transmittance`](super::Blockers::transmittance).
    #[must_use]
    pub fn transmittance(&self, segment: &Segment, tests: &mut u64) -> Rgb {
        let mut passage = Passage::new(segment);
        for Caster { entry, side, .. } in &self.all {
            *tests += 1;
            let side = side.unwrap_or_else(|| entry.surface.side(&segment.end));
            let can_hide = || Body::of(entry).can_hide_lamp(self.lamp, &Body::of(self.from));
            let is_in_the_way =
                !passage.has_crossed(entry.support) && entry.hides(segment, side, can_hide);
            if is_in_the_way && passage.cross(entry).is_break() {
                break;
            }
        }
        passage.share
    }
}
