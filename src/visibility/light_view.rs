//! Light views: the receivers and occluders of one light.

use std::collections::HashSet;
use std::sync::Arc;

use glam::DVec3;

use super::occluder_bound::OccluderBound;
use super::occluder_distance::OccluderDistance;
use super::occluder_tree::OccluderTree;
use super::primitive::Primitive;
use super::shadow_rect::ShadowRect;
use super::silhouette::{Silhouette, Silhouettes};
use super::surface_list::SurfaceList;
use crate::math::{CarrierId, Point, Side};
use crate::surface::Lamp;

/// The largest number of surfaces that each have their own list of occluders.
///
/// In larger scenes all share one list. Building the lists takes time proportional to the square of
/// the number of surfaces. With a smaller limit, scenes of a few dozen surfaces test shadows in
/// vain. With a larger one, building the lists takes longer than it saves.
pub const MOST_LISTS: usize = 128;

/// The source of a light.
#[derive(Debug, Clone, Copy)]
pub enum Emitter<'a> {
    /// A point light at this location.
    Point(DVec3),
    /// A lamp, with its index in the scene's list and its carrier.
    Lamp(&'a Lamp, usize, Option<CarrierId>),
}

/// The receivers and occluders of one light.
#[derive(Debug)]
pub struct LightView<'a> {
    pub(super) emitter: Emitter<'a>,
    pub(super) silhouette: Silhouette,
    /// All surfaces that can cast a shadow, in file order.
    pub(super) occluders: Vec<Occluder<'a>>,
    /// Lists of occluders, each of which serves one receiver or more.
    lists: Vec<Vec<Candidate>>,
    /// The list of every receiver; `None` if the light never arrives there.
    list_of: Vec<Option<usize>>,
    /// The tree that finds occluders if all receivers share one list.
    pub(super) tree: Option<OccluderTree>,
    /// The least distance of the occluders in that tree from a point light.
    pub(super) distance: Option<OccluderDistance>,
    /// True if only surfaces can end a ray to the light.
    pub(super) is_open: bool,
    /// True if occluders are tested even if the plan has decided.
    pub(super) tests_all: bool,
    pub(super) silhouettes: Arc<Silhouettes>,
}

/// A surface that can cast a shadow in the light of one emitter.
#[derive(Debug)]
pub(super) struct Occluder<'a> {
    pub(super) primitive: Primitive<'a>,
    /// The side of the surface that holds all of the emitter, except points of contact.
    pub(super) side: Option<Side>,
    pub(super) bound: OccluderBound,
    /// True if no light passes.
    ///
    /// It is opaque, and no transparent surface on its carrier comes first.
    pub(super) is_opaque: bool,
}

/// An occluder that may hide an emitter from one receiver.
#[derive(Debug, Clone, Copy)]
pub(super) struct Candidate {
    /// Its index in the list of occluders.
    pub(super) occluder: usize,
    /// Its carrier.
    pub(super) carrier: Option<CarrierId>,
    /// The part of the receiver that its shadow can fall on; `None` if that is unknown.
    pub(super) shadow: Option<ShadowRect>,
}

/// A surface that receives the light of one emitter.
#[derive(Debug, Clone, Copy)]
pub struct Receiver<'v, 'a> {
    pub(super) view: &'v LightView<'a>,
    pub(super) primitive: &'v Primitive<'a>,
    /// The occluders that can hide the emitter from some part of it.
    pub(super) candidates: &'v [Candidate],
}

impl<'a> LightView<'a> {
    /// The view of a light.
    ///
    /// `lights` returns whether the light arrives at a surface, by its index. With `tests_all`
    /// every occluder is tested for every shadow, even if it is proven to cast none.
    #[must_use]
    pub fn new(
        surfaces: &SurfaceList<'a>,
        silhouettes: &Arc<Silhouettes>,
        emitter: Emitter<'a>,
        tests_all: bool,
        lights: impl Fn(usize) -> bool,
    ) -> Self {
        let silhouette = emitter.silhouette();
        let occluders = occluders(surfaces, silhouettes, emitter, &silhouette);
        let count = surfaces.primitives().len();
        let shares_list = tests_all || count > MOST_LISTS;
        let all = occluders
            .iter()
            .enumerate()
            .map(|(occluder, it)| Candidate {
                occluder,
                carrier: it.primitive.carrier,
                shadow: None,
            });
        let lists = shares_list.then(|| all.collect());
        let mut view = Self {
            lists: lists.into_iter().collect(),
            list_of: vec![None; count],
            tree: None,
            distance: None,
            is_open: true,
            tests_all,
            silhouettes: silhouettes.clone(),
            emitter,
            silhouette,
            occluders,
        };
        for receiver in surfaces.primitives() {
            if !lights(receiver.index) {
                continue;
            }
            if !shares_list {
                let list = view.candidates(silhouettes.of(receiver));
                view.lists.push(list);
            }
            view.list_of[receiver.index] = Some(view.lists.len() - 1);
        }
        let walks = shares_list && (!tests_all || emitter.lamp().is_none());
        if let Some(tree) = surfaces.tree().filter(|_| walks) {
            let primitives = || view.occluders.iter().map(|occluder| &occluder.primitive);
            view.tree = Some(OccluderTree::new(
                tree,
                count,
                primitives().map(|it| it.index),
            ));
            if let Emitter::Point(light) = emitter {
                let bounded = primitives().filter(|it| it.surface.shape().bounds().is_some());
                view.distance = Some(OccluderDistance::new(light, bounded));
            }
        }
        view
    }

    /// The occluders that can hide the emitter from some part of a receiver.
    fn candidates(&self, receiver: &Silhouette) -> Vec<Candidate> {
        let candidate = |(occluder, it): (usize, &Occluder<'_>)| {
            let silhouette = self.silhouettes.of(&it.primitive);
            let can_hide = silhouette.can_hide(&self.silhouette, receiver)
                && !it.bound.hides_nothing_from(receiver);
            can_hide.then(|| Candidate {
                occluder,
                carrier: it.primitive.carrier,
                shadow: match self.emitter {
                    Emitter::Point(light) => ShadowRect::of(light, silhouette, receiver),
                    Emitter::Lamp(..) => None,
                },
            })
        };
        let occluders = self.occluders.iter().enumerate();
        occluders.filter_map(candidate).collect()
    }

    /// The same view, in which a camera's screen may end a ray to the light unless `is_open`.
    #[must_use]
    pub fn open(self, is_open: bool) -> Self {
        Self { is_open, ..self }
    }

    /// The lamp that the light comes from; `None` if it comes from a point.
    #[must_use]
    pub fn lamp(&self) -> Option<&'a Lamp> {
        self.emitter.lamp()
    }

    /// The light as a surface receives it; `None` if it never arrives there.
    #[must_use]
    #[inline(always)]
    pub fn receiver<'v>(&'v self, primitive: &'v Primitive<'a>) -> Option<Receiver<'v, 'a>> {
        Some(Receiver {
            view: self,
            primitive,
            candidates: &self.lists[self.list_of[primitive.index]?],
        })
    }

    /// The indices in the scene's list of the occluders that can hide the light.
    #[must_use]
    pub fn occluders_of(&self, receiver: usize) -> Vec<usize> {
        let candidates = self.list_of[receiver].map_or(&[][..], |list| &self.lists[list]);
        let occluders = candidates
            .iter()
            .map(|candidate| &self.occluders[candidate.occluder]);
        occluders.map(|occluder| occluder.primitive.index).collect()
    }

    /// The side of an occluder that holds all of the emitter.
    ///
    /// The occluder is given by its index in the scene's list.
    ///
    /// Parts of a lamp may touch the occluder. `None` if a lamp is on both sides, or on its
    /// carrier.
    #[must_use]
    pub fn side_of(&self, occluder: usize) -> Option<Side> {
        let mut occluders = self.occluders.iter();
        let found = occluders.find(|it| it.primitive.index == occluder);
        found?.side
    }
}

impl<'a> Emitter<'a> {
    /// The emitters of lamps among some surfaces, in their order.
    pub fn lamps<'s>(surfaces: &'s SurfaceList<'a>) -> impl Iterator<Item = Self> + use<'s, 'a> {
        surfaces.primitives().iter().filter_map(|primitive| {
            let lamp = primitive.surface.lamp()?;
            Some(Self::Lamp(lamp, primitive.index, primitive.carrier))
        })
    }

    /// The lamp; `None` for a point light.
    #[must_use]
    pub fn lamp(&self) -> Option<&'a Lamp> {
        match self {
            Self::Point(_) => None,
            Self::Lamp(lamp, ..) => Some(lamp),
        }
    }

    /// The geometry of the emitter.
    #[must_use]
    pub fn silhouette(&self) -> Silhouette {
        match self {
            Self::Point(light) => Silhouette::of_point(*light),
            Self::Lamp(lamp, _, carrier) => Silhouette::of_surface(*lamp, *carrier),
        }
    }

    /// Returns whether a surface is the lamp, or lies on its carrier.
    fn is_on(&self, primitive: &Primitive<'_>) -> bool {
        match self {
            Self::Point(_) => false,
            Self::Lamp(_, index, carrier) => {
                primitive.index == *index || primitive.lies_on(*carrier)
            }
        }
    }
}

/// All surfaces that can cast a shadow in the light of an emitter, in file order.
fn occluders<'a>(
    surfaces: &SurfaceList<'a>,
    silhouettes: &Silhouettes,
    emitter: Emitter<'a>,
    silhouette: &Silhouette,
) -> Vec<Occluder<'a>> {
    let mut panes = HashSet::new();
    let casting = surfaces.primitives().iter();
    let casting = casting.filter(|it| it.common.shadows.cast && !emitter.is_on(it));
    let occluder = |primitive: &Primitive<'a>| {
        let is_opaque = primitive.common.material.transparency == 0.0;
        let carrier = primitive.carrier;
        let is_first = !carrier.is_some_and(|carrier| panes.contains(&carrier));
        panes.extend(carrier.filter(|_| !is_opaque));
        let (bound, side) = match emitter {
            Emitter::Point(light) => {
                let side = primitive.side(&Point::exact(light));
                (OccluderBound::Unknown, Some(side))
            }
            Emitter::Lamp(lamp, ..) => {
                let bound = OccluderBound::new(silhouettes.of(primitive), lamp, silhouette);
                let side = bound.side_of_lamp();
                (bound, side)
            }
        };
        Occluder {
            primitive: *primitive,
            side,
            bound,
            is_opaque: is_opaque && is_first,
        }
    };
    casting.map(occluder).collect()
}
