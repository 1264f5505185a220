//! The reachability of surfaces by rays.

use glam::DVec3;
use serde::Serialize;

use crate::camera::Camera;
use crate::math::error_bounds::APART;
use crate::math::{Bounds, Flat, Point, Side};
use crate::scene::{RenderSettings, Scene};
use crate::surface::Surface;
use crate::visibility::{ScreenBounds, shared_border_error};

/// The reachability of a surface by rays.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reachability {
    /// From the eye.
    Directly,
    /// Only after reflection or transmission.
    SentOn,
    /// Not at all.
    Never,
}

/// The largest number of pairs of a scattering and another surface to examine.
///
/// In larger scenes every surface counts as reachable.
const MOST_PAIRS: usize = 1 << 20;

impl Reachability {
    /// The reachability of each surface from the camera and scattering surfaces.
    ///
    /// Without screen bounds all count as visible. A flat surface reflects rays to the side of
    /// their origin and transmits them to the other. They reach no surface that lies wholly on a
    /// side without rays. A round surface scatters rays in all directions.
    pub(super) fn all(
        scene: &Scene,
        screen_bounds: Option<&ScreenBounds<'_>>,
        camera: &Camera,
    ) -> Vec<Self> {
        let count = scene.surfaces.len();
        let Some(screen_bounds) = screen_bounds else {
            return vec![Self::Directly; count];
        };
        let RenderSettings { width, height, .. } = scene.settings;
        let is_visible = screen_bounds.visible([width, height], count);
        let mut seen: Vec<_> = is_visible
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
        let mut propagation = Propagation::new(scene, seen);
        propagation.arrive_from_eye(&Point::exact(camera.viewpoint()));
        while let Some((sender, side)) = propagation.pending.pop() {
            propagation.send_on(sender, side);
        }
        propagation.seen
    }

    /// Returns whether any ray can hit it.
    #[must_use]
    pub fn is_reached(self) -> bool {
        self != Self::Never
    }
}

/// The propagation of reachability from surface to surface.
#[derive(Debug)]
struct Propagation<'s> {
    surfaces: &'s [Box<dyn Surface>],
    /// The box in which each surface can be hit; `None` if it is unbounded.
    boxes: Vec<Option<Bounds>>,
    /// The reachability of each surface so far.
    seen: Vec<Reachability>,
    /// True for the front and back of each scattering surface if rays arrive there.
    marked: Vec<[bool; 2]>,
    /// Surfaces and sides whose scattered rays are not propagated yet.
    pending: Vec<(usize, Side)>,
}

impl<'s> Propagation<'s> {
    fn new(scene: &'s Scene, seen: Vec<Reachability>) -> Self {
        let surfaces = &scene.surfaces[..];
        Self {
            surfaces,
            boxes: surfaces.iter().map(|it| hit_bounds(&**it)).collect(),
            seen,
            marked: vec![[false; 2]; surfaces.len()],
            pending: Vec::new(),
        }
    }

    /// Marks the sides of visible surfaces at which camera rays arrive.
    fn arrive_from_eye(&mut self, eye: &Point) {
        for (index, surface) in self.surfaces.iter().enumerate() {
            for side in SIDES {
                let is_facing = surface.shape().carrier().is_none()
                    || surface.shape().side(eye) != opposite(side);
                if self.seen[index] == Reachability::Directly && is_facing {
                    self.arrive(index, side);
                }
            }
        }
    }

    /// Marks all surfaces that rays from one side of a surface can hit after it.
    fn send_on(&mut self, sender: usize, from: Side) {
        for (index, surface) in self.surfaces.iter().enumerate() {
            let can_hit = |to: Side| {
                let bounds = self.boxes[index].as_ref();
                can_go(&*self.surfaces[sender], from, to, bounds)
            };
            if index == sender || !SIDES.into_iter().any(can_hit) {
                continue;
            }
            if self.seen[index] == Reachability::Never {
                self.seen[index] = Reachability::SentOn;
            }
            for side in SIDES {
                let start = self.boxes[sender].as_ref();
                let flat = surface.shape().carrier();
                if flat.is_none_or(|flat| !is_beyond(start, flat, opposite(side))) {
                    self.arrive(index, side);
                }
            }
        }
    }

    /// Marks one side of a surface as hit; it is pending if the surface scatters.
    fn arrive(&mut self, index: usize, side: Side) {
        let is_marked = &mut self.marked[index][usize::from(side == Side::Back)];
        if sends_on(&*self.surfaces[index]) && !std::mem::replace(is_marked, true) {
            self.pending.push((index, side));
        }
    }
}

const SIDES: [Side; 2] = [Side::Front, Side::Back];

fn opposite(side: Side) -> Side {
    side.opposite().unwrap_or(side)
}

fn sends_on(surface: &dyn Surface) -> bool {
    surface.common().material.spawns_rays()
}

/// The box in which a surface can be hit; `None` if it is unbounded.
fn hit_bounds(surface: &dyn Surface) -> Option<Bounds> {
    let Bounds { min, max } = surface.shape().bounds()?;
    let margin = DVec3::splat(shared_border_error(surface));
    Some(Bounds {
        min: min - margin,
        max: max + margin,
    })
}

/// Returns whether rays from one side of a surface can hit a box on another.
fn can_go(sender: &dyn Surface, from: Side, to: Side, bounds: Option<&Bounds>) -> bool {
    let Some(flat) = sender.shape().carrier() else {
        return true;
    };
    let material = &sender.common().material;
    let goes = if from == to {
        material.mirrors()
    } else {
        material.transparency > 0.0
    };
    goes && !is_beyond(bounds, flat, opposite(to))
}

/// Returns whether a box certainly lies strictly on this side of a plane.
///
/// Its distance from the plane exceeds the rounding errors of rays. Unbounded surfaces have no box
/// and lie on both sides.
fn is_beyond(bounds: Option<&Bounds>, flat: &Flat, side: Side) -> bool {
    let Some(bounds) = bounds else {
        return false;
    };
    let base = Point::exact(flat.point).size();
    bounds.corners().into_iter().all(|corner| {
        let (offset, size) = Point::exact(corner).seen_from(flat.point);
        let height = flat.normal.dot(offset);
        let height = if side == Side::Front { height } else { -height };
        height > APART * (base + size) + flat.slack()
    })
}
