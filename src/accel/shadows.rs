//! What stands in the way of a light.

use std::collections::HashSet;
use std::ops::ControlFlow;
use std::sync::Arc;

use glam::DVec3;

use super::clearance::Clearance;
use super::receivers::Body;
use super::shade::Shade;
use super::tree::Tree;
use super::{Entry, SurfaceList};
use crate::math::{Point, Ray, Rgb, Segment, Side, Support};
use crate::surface::Hit;

/// A scene's surfaces as one light has them before it.
#[derive(Debug)]
pub struct LightView<'a> {
    /// What can cast a shadow, in lists of which each serves one surface or more.
    casters: Vec<Vec<Caster<'a>>>,
    /// For every surface which of the lists counts for it; `None` if the light is behind its plane
    /// or in it.
    list_of: Vec<Option<usize>>,
    /// What finds the casters if all surfaces share one list.
    tree: Option<CasterTree>,
}

/// A tree of surfaces of which some cast shadows.
#[derive(Debug)]
struct CasterTree {
    tree: Arc<Tree>,
    /// For every surface its place in the list of casters.
    casters: Vec<Option<u32>>,
    clearance: Clearance,
}

/// What a light has before one of the surfaces that it can light.
#[derive(Debug, Clone, Copy)]
pub struct Before<'v, 'a> {
    casters: &'v [Caster<'a>],
    tree: Option<&'v CasterTree>,
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

/// The most surfaces of which each has its own list of casters; of more, all share one.
///
/// The lists take the square of the number of surfaces to make. Smaller, and scenes of a few dozen
/// surfaces test shadows in vain; larger, and making the lists takes longer than it saves.
const MOST_LISTS: usize = 128;

impl<'a> LightView<'a> {
    /// What lights at these places have before them. Without `elides` every surface is asked for
    /// every shadow, even if it is proven to cast none.
    #[must_use]
    pub fn all(
        surfaces: &SurfaceList<'a>,
        lights: impl Iterator<Item = DVec3>,
        elides: bool,
    ) -> Vec<Self> {
        let each = elides && surfaces.entries().len() <= MOST_LISTS;
        let bodies = surfaces.entries().iter().filter(|_| each).map(Body::of);
        let bodies: Vec<_> = bodies.collect();
        let view = |light| Self::new(surfaces, each.then_some(&bodies), light);
        lights.map(view).collect()
    }

    /// What a light at this place has before it.
    fn new(surfaces: &SurfaceList<'a>, bodies: Option<&Vec<Body>>, light: DVec3) -> Self {
        let location = Point::exact(light);
        let mut clear_sheets = HashSet::new();
        let casters: Vec<_> = surfaces
            .entries()
            .iter()
            .filter(|entry| entry.common.shadows.cast)
            .map(|entry| {
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
                    side: entry.surface.side(&location),
                    blocks: opaque && counts,
                }
            })
            .collect();
        let lit: Vec<_> = surfaces
            .entries()
            .iter()
            .filter(|entry| {
                let surface = entry.surface;
                surface.flat().is_none() || surface.side(&location) == Side::Front
            })
            .collect();
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
                let mut places = vec![None; surfaces.entries().len()];
                for (place, caster) in (0..).zip(&casters) {
                    places[caster.entry.index] = Some(place);
                }
                let bounded = casters.iter().map(|caster| &caster.entry);
                let bounded = bounded.filter(|entry| entry.surface.bounds().is_some());
                CasterTree {
                    tree: tree.clone(),
                    casters: places,
                    clearance: Clearance::new(light, bounded),
                }
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

    /// Forgets the surfaces, by their places in the list, that the light is not to light.
    pub fn retain(&mut self, lights: impl Fn(usize) -> bool) {
        for (surface, list) in self.list_of.iter_mut().enumerate() {
            *list = list.filter(|_| lights(surface));
        }
    }

    /// The surfaces, by their places in the list, that can stand between the light and this one.
    #[must_use]
    pub fn casters_of(&self, surface: usize) -> Vec<usize> {
        let list = self.list_of[surface].map_or(&[][..], |list| &self.casters[list]);
        list.iter().map(|caster| caster.entry.index).collect()
    }

    /// Whether light from here can reach the front of a surface at all.
    #[must_use]
    pub fn lights(&self, entry: &Entry<'_>) -> bool {
        self.list_of[entry.index].is_some()
    }

    /// What can stand between the light and a surface; `None` if no light from here can reach the front
    /// of the surface at all.
    #[must_use]
    #[inline(always)]
    pub fn before(&self, entry: &Entry<'_>) -> Option<Before<'_, 'a>> {
        Some(Before {
            casters: &self.casters[self.list_of[entry.index]?],
            tree: self.tree.as_ref(),
        })
    }
}

impl Before<'_, '_> {
    /// Whether anything can stand between the light and a hit of the surface from which a ray goes to
    /// the light.
    #[must_use]
    #[inline(always)]
    pub fn can_hide(&self, hit: &Hit, ray: &Ray) -> bool {
        let mut casters = self.casters.iter();
        // The tree asks for less than going through all of them.
        self.tree.is_some() && !casters.as_slice().is_empty()
            || casters.any(|caster| caster.can_meet(ray, hit))
    }

    /// The share of the light's colour that passes along a segment from a hit of the surface to it.
    ///
    /// Opaque surfaces block it, transparent ones tint it, each once. Of surfaces on the same sheet
    /// the first in the file counts. `tests` is raised by the number of surfaces that are asked.
    #[must_use]
    pub fn transmittance(&self, hit: &Hit, segment: &Segment, tests: &mut u64) -> Rgb {
        let casters = self.casters;
        let mut hides = |caster: &Caster<'_>| {
            if !caster.can_meet(&segment.ray, hit) {
                return false;
            }
            *tests += 1;
            caster.entry.surface.occludes(segment, caster.side)
        };
        let Some(CasterTree {
            tree,
            casters: places,
            clearance,
        }) = self.tree
        else {
            return passed(casters.iter().filter(|caster| hides(caster)), segment);
        };
        if casters.is_empty() {
            return Rgb::WHITE;
        }
        let mut in_the_way = Vec::new();
        let mut blocked = false;
        tree.walk(&segment.ray, clearance.until(segment), |index, until| {
            let Some(place) = places[index] else {
                return ControlFlow::Continue(until);
            };
            let caster = &casters[place as usize];
            if !hides(caster) {
                return ControlFlow::Continue(until);
            }
            in_the_way.push(place);
            blocked = caster.blocks;
            if blocked {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(until)
            }
        });
        if blocked {
            return Rgb::BLACK;
        }
        in_the_way.sort_unstable();
        passed(
            in_the_way.iter().map(|place| &casters[*place as usize]),
            segment,
        )
    }
}

/// The share of light that passes all of these, which are in file order.
fn passed<'c, 'a: 'c>(in_the_way: impl Iterator<Item = &'c Caster<'a>>, segment: &Segment) -> Rgb {
    let mut passed = Rgb::WHITE;
    let mut crossed: Vec<Support> = Vec::new();
    for Caster { entry, .. } in in_the_way {
        if entry
            .support
            .is_some_and(|support| crossed.contains(&support))
        {
            continue;
        }
        if entry.common.material.transparency == 0.0 {
            return Rgb::BLACK;
        }
        crossed.extend(entry.support);
        if let Some(mut hit) = entry.surface.hits(&segment.ray, segment.limits().span()) {
            entry.surface.settle(&mut hit, &segment.ray);
            passed = passed * entry.surface.transmits(&hit);
        }
    }
    passed
}
