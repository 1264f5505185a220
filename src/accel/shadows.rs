//! What stands in the way of a light.

use std::collections::HashSet;

use glam::DVec3;

use super::caster_tree::{CasterTree, passed};
use super::clearance::Clearance;
use super::receivers::Body;
use super::shade::Shade;
use super::{Entry, MOST_LISTS, SurfaceList};
use crate::math::{Point, Ray, Rgb, Segment, Side};
use crate::surface::Hit;

/// A scene's surfaces as one light has them before it.
#[derive(Debug)]
pub struct LightView<'a> {
    /// What can cast a shadow, in lists of which each serves one surface or more.
    casters: Vec<Vec<Caster<'a>>>,
    /// For every surface which of the lists counts for it; `None` if the light is not to light it.
    list_of: Vec<Option<usize>>,
    /// What finds the casters if all surfaces share one list, and how clear of the light they are.
    tree: Option<(CasterTree, Clearance)>,
}

/// What a light has before one of the surfaces that it can light.
#[derive(Debug, Clone, Copy)]
pub struct Before<'v, 'a> {
    from: &'v Entry<'a>,
    casters: &'v [Caster<'a>],
    tree: Option<&'v (CasterTree, Clearance)>,
}

/// What can stand between a light and a hit of a surface.
#[derive(Debug, Clone, Copy)]
pub struct Blockers<'v, 'a> {
    before: Before<'v, 'a>,
    hit: &'v Hit,
    /// The first one of the casters that can.
    first: usize,
}

/// A surface that can cast a shadow.
#[derive(Debug, Clone, Copy)]
struct Caster<'a> {
    /// Where alone its shadow can fall on the surface that the list is for; `None` if anywhere.
    shade: Option<Shade>,
    entry: Entry<'a>,
    /// The side of the surface that the light is on.
    side: Side,
    /// Whether nothing passes where it stands in the way: it is opaque, and on its sheet there is no
    /// transparent one before it, which would count instead.
    blocks: bool,
}

impl Caster<'_> {
    /// Whether it can stand in the way of a ray from a hit to the light.
    #[inline(always)]
    fn can_meet(&self, ray: &Ray, from: &Hit) -> bool {
        let shade = self.shade.as_ref();
        !shade.is_some_and(|shade| shade.is_beside(from.uv, ray))
            && !self.entry.lies_on(ray.leaves())
    }
}

impl<'a> LightView<'a> {
    /// What lights at these places have before them; `lights` tells whether a light, by its number, is
    /// to light a surface, by its place in the list. Without `elides` every surface is asked for every
    /// shadow, even if it is proven to cast none.
    #[must_use]
    pub fn all(
        surfaces: &SurfaceList<'a>,
        places: impl Iterator<Item = DVec3>,
        elides: bool,
        lights: impl Fn(usize, usize) -> bool,
    ) -> Vec<Self> {
        let each = elides && surfaces.entries().len() <= MOST_LISTS;
        let bodies = surfaces.entries().iter().filter(|_| each).map(Body::of);
        let bodies: Vec<_> = bodies.collect();
        let view = |(number, place)| {
            let lights = |surface| lights(number, surface);
            Self::new(surfaces, each.then_some(&bodies), place, &lights)
        };
        places.enumerate().map(view).collect()
    }

    /// What a light at this place has before it.
    fn new(
        surfaces: &SurfaceList<'a>,
        bodies: Option<&Vec<Body>>,
        light: DVec3,
        lights: &dyn Fn(usize) -> bool,
    ) -> Self {
        let casters = casters(surfaces, &Point::exact(light));
        let lit = surfaces.entries().iter();
        let lit = lit.filter(|entry| lights(entry.index));
        let mut view = Self {
            casters: Vec::new(),
            list_of: vec![None; surfaces.entries().len()],
            tree: None,
        };
        let Some(bodies) = bodies else {
            for entry in lit {
                view.list_of[entry.index] = Some(0);
            }
            view.tree = surfaces.tree.as_ref().map(|tree| {
                let entries = || casters.iter().map(|caster| &caster.entry);
                let bounded = entries().filter(|entry| entry.surface.bounds().is_some());
                let clearance = Clearance::new(light, bounded);
                let count = surfaces.entries().len();
                (CasterTree::new(tree, count, entries()), clearance)
            });
            view.casters.push(casters);
            return view;
        };
        let shading = |caster: &Caster<'a>, from: &Entry<'_>| {
            let (body, receiver) = (&bodies[caster.entry.index], &bodies[from.index]);
            let hides = body.can_hide(light, caster.side, receiver);
            hides.then(|| Caster {
                shade: Shade::of(light, body, receiver),
                ..*caster
            })
        };
        for entry in lit {
            view.list_of[entry.index] = Some(view.casters.len());
            let own = casters.iter().filter_map(|caster| shading(caster, entry));
            view.casters.push(own.collect());
        }
        view
    }

    /// The surfaces, by their places in the list, that can stand between the light and this one.
    #[must_use]
    pub fn casters_of(&self, surface: usize) -> Vec<usize> {
        let list = self.list_of[surface].map_or(&[][..], |list| &self.casters[list]);
        list.iter().map(|caster| caster.entry.index).collect()
    }

    /// Whether light from here is to light a surface at all.
    #[must_use]
    pub fn lights(&self, entry: &Entry<'_>) -> bool {
        self.list_of[entry.index].is_some()
    }

    /// What can stand between the light and a surface; `None` if it is not to light the surface at all.
    #[must_use]
    #[inline(always)]
    pub fn before<'v>(&'v self, entry: &'v Entry<'a>) -> Option<Before<'v, 'a>> {
        Some(Before {
            from: entry,
            casters: &self.casters[self.list_of[entry.index]?],
            tree: self.tree.as_ref(),
        })
    }
}

/// All that can cast a shadow in the light from a place, in file order.
fn casters<'a>(surfaces: &SurfaceList<'a>, light: &Point) -> Vec<Caster<'a>> {
    let mut clear_sheets = HashSet::new();
    let casts = |entry: &&Entry<'_>| entry.common.shadows.cast;
    let casting = surfaces.entries().iter().filter(casts);
    let caster = |entry: &Entry<'a>| {
        let opaque = entry.common.material.transparency == 0.0;
        if !opaque {
            clear_sheets.extend(entry.support);
        }
        let counts = entry
            .support
            .is_none_or(|support| !clear_sheets.contains(&support));
        Caster {
            shade: None,
            entry: *entry,
            side: entry.surface.side(light),
            blocks: opaque && counts,
        }
    };
    casting.map(caster).collect()
}

impl<'v, 'a> Before<'v, 'a> {
    /// What can stand between the light and a hit of the surface from which a ray goes to the light;
    /// `None` if nothing can.
    #[must_use]
    #[inline(always)]
    pub fn blockers(&self, hit: &'v Hit, ray: &Ray) -> Option<Blockers<'v, 'a>> {
        let mut casters = self.casters.iter();
        let first = match self.tree {
            // It asks for less than going through all of them.
            Some(_) => (!self.casters.is_empty()).then_some(0),
            None => casters.position(|caster| caster.can_meet(ray, hit)),
        };
        Some(Blockers {
            before: *self,
            hit,
            first: first?,
        })
    }
}

impl Blockers<'_, '_> {
    /// The share of the light's colour that passes along a segment to it.
    ///
    /// Opaque surfaces block it, transparent ones tint it, each once. Of surfaces on the same sheet
    /// the first in the file counts. `tests` is raised by the number of surfaces that are asked.
    #[must_use]
    pub fn transmittance(&self, segment: &Segment, tests: &mut u64) -> Rgb {
        let Before {
            from,
            casters,
            tree,
        } = self.before;
        let mut hides = |caster: &Caster<'_>| {
            *tests += 1;
            let Caster { entry, side, .. } = caster;
            entry.hides(segment, *side, || {
                Body::of(entry).can_hide(segment.end.world(), *side, &Body::of(from))
            })
        };
        let can_meet = |caster: &Caster<'_>| caster.can_meet(&segment.ray, self.hit);
        let Some((tree, clearance)) = tree else {
            // The first one is known to be able to.
            let (first, others) = casters[self.first..].split_at(1);
            let others = others.iter().filter(|caster| can_meet(caster));
            let all = first.iter().chain(others).filter(|caster| hides(caster));
            return passed(all.map(|caster| &caster.entry), segment);
        };
        tree.transmittance(segment, clearance.until(segment), |place| {
            let caster = &casters[place];
            (can_meet(caster) && hides(caster)).then_some((&caster.entry, caster.blocks))
        })
    }
}
