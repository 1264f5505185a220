//! Which surfaces any ray can meet.

use glam::DVec3;
use serde::Serialize;

use crate::accel::{ScreenBounds, overhang};
use crate::camera::Camera;
use crate::math::error_bounds::APART;
use crate::math::{Bounds, Flat, Point, Side};
use crate::scene::{RenderSettings, Scene};
use crate::surface::Surface;

/// How a ray can come to meet a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reachability {
    /// From the eye.
    Directly,
    /// Sent on by mirrors or through surfaces, but not from the eye.
    SentOn,
    /// Not at all.
    Never,
}

/// The most pairs of one that sends rays on and another surface that are looked at; of more, every
/// surface is taken for one that can be met.
const MOST_PAIRS: usize = 1 << 20;

impl Reachability {
    /// How rays can meet each surface of a scene: from the eye where the camera sees it, and from
    /// surfaces that send rays on. Without `sight` all are taken to be in sight.
    ///
    /// A flat surface mirrors rays to the side that they come from, and lets them through to the other
    /// one; what lies wholly on the side to which none go is not met by them. Something round
    /// sends rays anywhere.
    pub(super) fn all(
        scene: &Scene,
        sight: Option<&ScreenBounds<'_>>,
        camera: &Camera,
    ) -> Vec<Self> {
        let count = scene.surfaces.len();
        let Some(sight) = sight else {
            return vec![Self::Directly; count];
        };
        let RenderSettings { width, height, .. } = scene.settings;
        let in_sight = sight.seen([width, height], count);
        let mut seen: Vec<_> = in_sight
            .into_iter()
            .map(|seen| if seen { Self::Directly } else { Self::Never })
            .collect();
        let senders = scene.surfaces.iter().map(|surface| sends_on(&**surface));
        if senders.filter(|sends| *sends).count() * count > MOST_PAIRS {
            for seen in seen.iter_mut().filter(|seen| **seen == Self::Never) {
                *seen = Self::SentOn;
            }
            return seen;
        }
        let mut spread = Spread::new(scene, seen);
        spread.arrive_from_eye(&Point::exact(camera.viewpoint()));
        while let Some((sender, side)) = spread.waiting.pop() {
            spread.send_on(sender, side);
        }
        spread.seen
    }

    /// Whether any ray can meet it.
    #[must_use]
    pub fn is_seen(self) -> bool {
        self != Self::Never
    }
}

/// Rays on their way from surface to surface.
#[derive(Debug)]
struct Spread<'s> {
    surfaces: &'s [Box<dyn Surface>],
    /// A box in which each surface is met; `None` if it has no end.
    boxes: Vec<Option<Bounds>>,
    /// How rays can meet each surface, as far as that is known yet.
    seen: Vec<Reachability>,
    /// Whether rays arrive at the front and at the back of each surface that sends them on.
    arrived: Vec<[bool; 2]>,
    /// The surfaces and sides that rays arrive at which have not been sent on yet.
    waiting: Vec<(usize, Side)>,
}

impl<'s> Spread<'s> {
    fn new(scene: &'s Scene, seen: Vec<Reachability>) -> Self {
        let surfaces = &scene.surfaces[..];
        Self {
            surfaces,
            boxes: surfaces.iter().map(|it| met_within(&**it)).collect(),
            seen,
            arrived: vec![[false; 2]; surfaces.len()],
            waiting: Vec::new(),
        }
    }

    /// Rays arrive from the eye at all surfaces that it sees.
    fn arrive_from_eye(&mut self, eye: &Point) {
        for (index, surface) in self.surfaces.iter().enumerate() {
            for side in SIDES {
                let is_here = surface.flat().is_none() || surface.side(eye) != other(side);
                if self.seen[index] == Reachability::Directly && is_here {
                    self.arrive(index, side);
                }
            }
        }
    }

    /// Rays that arrived at one side of a surface go on to all that they can meet then.
    fn send_on(&mut self, sender: usize, from: Side) {
        for (index, surface) in self.surfaces.iter().enumerate() {
            let can_meet = |to: Side| {
                let bounds = self.boxes[index].as_ref();
                can_go(&*self.surfaces[sender], from, to, bounds)
            };
            if index == sender || !SIDES.into_iter().any(can_meet) {
                continue;
            }
            if self.seen[index] == Reachability::Never {
                self.seen[index] = Reachability::SentOn;
            }
            for side in SIDES {
                let start = self.boxes[sender].as_ref();
                let flat = surface.flat();
                if flat.is_none_or(|flat| !is_beyond(start, flat, other(side))) {
                    self.arrive(index, side);
                }
            }
        }
    }

    /// Rays arrive at one side of a surface, which may send them on.
    fn arrive(&mut self, index: usize, side: Side) {
        let known = &mut self.arrived[index][usize::from(side == Side::Back)];
        if sends_on(&*self.surfaces[index]) && !std::mem::replace(known, true) {
            self.waiting.push((index, side));
        }
    }
}

const SIDES: [Side; 2] = [Side::Front, Side::Back];

fn other(side: Side) -> Side {
    side.opposite().unwrap_or(side)
}

fn sends_on(surface: &dyn Surface) -> bool {
    surface.common().material.spawns_rays()
}

/// A box in which a surface is met; `None` if it has no end.
fn met_within(surface: &dyn Surface) -> Option<Bounds> {
    let Bounds { min, max } = surface.bounds()?;
    let beside = DVec3::splat(overhang(surface));
    Some(Bounds {
        min: min - beside,
        max: max + beside,
    })
}

/// Whether a ray that arrives at a surface from one side can go on to one, and meet what is in a box there.
fn can_go(sender: &dyn Surface, from: Side, to: Side, bounds: Option<&Bounds>) -> bool {
    let Some(flat) = sender.flat() else {
        return true;
    };
    let material = &sender.common().material;
    let goes = if from == to {
        material.mirrors()
    } else {
        material.transparency > 0.0
    };
    goes && !is_beyond(bounds, flat, other(to))
}

/// Whether all that is in a box lies strictly on this side of a plane, for certain: further from it, seen
/// from anywhere on its way, than rounding can lead a ray astray. What has no box is everywhere.
fn is_beyond(bounds: Option<&Bounds>, flat: &Flat, side: Side) -> bool {
    let Some(bounds) = bounds else {
        return false;
    };
    let base = Point::exact(flat.point).size();
    bounds.corners().into_iter().all(|corner| {
        let (way, size) = Point::exact(corner).seen_from(flat.point);
        let height = flat.normal.dot(way);
        let height = if side == Side::Front { height } else { -height };
        height > APART * (base + size) + flat.slack()
    })
}
