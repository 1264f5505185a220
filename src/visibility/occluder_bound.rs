//! Bounds of an occluder in front of a lamp, tested before any shadow ray.

use glam::DVec3;

use super::border_planes::BorderPlanes;
use super::separating_plane::SeparatingPlane;
use super::silhouette::Silhouette;
use crate::math::error_bounds::{OCCLUSION, SLIDE};
use crate::math::{Flat, Point, Ray, Side};
use crate::surface::{Lamp, Surface};

/// The bound of an occluder in front of a lamp; most points need no other test.
#[derive(Debug)]
pub(super) enum OccluderBound {
    /// A flat occluder; `lamp` is the side that all of the lamp is on.
    Flat {
        plane: Flat,
        lamp: Option<Side>,
        borders: Vec<BorderPlanes>,
    },
    /// A round occluder within a ball; `separating` is a plane between it and the lamp.
    Ball {
        center: DVec3,
        radius: f64,
        lamp: (DVec3, f64),
        separating: Option<SeparatingPlane>,
    },
    /// A round occluder behind the lamp, for points of a size below `farthest`.
    Behind { farthest: f64 },
    /// No bound exists.
    Unknown,
}

/// The part of a lamp that one occluder hides from a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum HiddenPart {
    /// Nothing of it.
    None,
    /// Possibly some of it.
    Partial,
    /// All of it.
    Full,
}

impl OccluderBound {
    /// The bound of an occluder in front of a lamp, from the silhouettes of both.
    pub(super) fn new(occluder: &Silhouette, lamp: &Lamp, emitter: &Silhouette) -> Self {
        if let Some(plane) = occluder.plane {
            return Self::Flat {
                plane,
                lamp: occluder.side_of(emitter),
                borders: BorderPlanes::all(occluder, emitter),
            };
        }
        let Some([center, axes]) = occluder.round else {
            return Self::Unknown;
        };
        let radius = axes.max_element();
        let farthest = lamp.shape().carrier().map(|plane| {
            let (offset, size) = Point::exact(center).seen_from(plane.point);
            let base = Point::exact(plane.point).size();
            let gap = -plane.normal.dot(offset) - radius - plane.slack();
            gap / OCCLUSION - (size + base + radius)
        });
        if let Some(farthest) = farthest.filter(|farthest| *farthest > 0.0) {
            return Self::Behind { farthest };
        }
        Self::Ball {
            center,
            radius,
            lamp: (lamp.center().world(), lamp.radius()),
            separating: SeparatingPlane::between(occluder, emitter),
        }
    }

    /// The side of the occluder that holds all of the lamp, except points of contact.
    ///
    /// `None` if it is uncertain.
    pub(super) fn side_of_lamp(&self) -> Option<Side> {
        match self {
            Self::Flat { lamp, .. } => *lamp,
            Self::Ball {
                separating: Some(_),
                ..
            }
            | Self::Behind { .. } => Some(Side::Front),
            Self::Ball {
                center,
                radius,
                lamp,
                separating: None,
            } => {
                let size = lamp.0.abs().element_sum() + center.abs().element_sum();
                let apart = radius + lamp.1 + OCCLUSION * (size + radius + lamp.1);
                ((lamp.0 - *center).length() > apart).then_some(Side::Front)
            }
            Self::Unknown => None,
        }
    }

    /// Returns whether a round occluder certainly hides nothing from a receiver.
    pub(super) fn hides_nothing_from(&self, receiver: &Silhouette) -> bool {
        let hides_nothing_from = |point| {
            let point = Point::exact(point);
            match self {
                Self::Behind { farthest } => point.size() < *farthest,
                // Hits lie between these points, or beyond them by a rounding along the surface.
                Self::Ball {
                    separating: Some(plane),
                    ..
                } => plane.has_in_front(&point, SLIDE * point.size()),
                Self::Flat { .. } | Self::Ball { .. } | Self::Unknown => false,
            }
        };
        receiver.is_bounded() && receiver.corners().all(hides_nothing_from)
    }

    /// The part of the lamp that it hides from the origin of a ray.
    pub(super) fn hidden_part(&self, ray: &Ray) -> HiddenPart {
        match self {
            Self::Flat {
                plane,
                lamp,
                borders,
            } => hidden_by_flat(plane, *lamp, borders, ray),
            Self::Ball {
                center,
                radius,
                lamp,
                separating,
            } => {
                let in_front = |it: &SeparatingPlane| it.has_in_front(&ray.origin, ray.astray);
                if separating.as_ref().is_some_and(in_front)
                    || misses_ball(*center, *radius, *lamp, ray)
                {
                    HiddenPart::None
                } else {
                    HiddenPart::Partial
                }
            }
            Self::Behind { farthest } if ray.size() < *farthest => HiddenPart::None,
            Self::Behind { .. } | Self::Unknown => HiddenPart::Partial,
        }
    }
}

fn hidden_by_flat(
    plane: &Flat,
    lamp: Option<Side>,
    borders: &[BorderPlanes],
    ray: &Ray,
) -> HiddenPart {
    let (offset, size) = ray.origin.seen_from(plane.point);
    let height = plane.normal.dot(offset);
    let base = Point::exact(plane.point).size();
    let certain = height.abs() > OCCLUSION * (size + base) + ray.astray + plane.slack();
    let behind = match lamp {
        // A lamp in a plane is on neither side of it.
        Some(Side::On) => return HiddenPart::None,
        Some(side) if certain => {
            if (side == Side::Front) == (height > 0.0) {
                return HiddenPart::None;
            }
            true
        }
        _ => false,
    };
    let mut inside = behind && !borders.is_empty();
    for border in borders {
        match border.side(ray) {
            Some(Side::Back) => return HiddenPart::None,
            Some(Side::Front) => {}
            _ => inside = false,
        }
    }
    if inside {
        HiddenPart::Full
    } else {
        HiddenPart::Partial
    }
}

/// Returns whether a ball certainly misses all segments from an origin to a lamp.
///
/// The lamp is given by a ball around it.
fn misses_ball(center: DVec3, radius: f64, (lamp, lamp_radius): (DVec3, f64), ray: &Ray) -> bool {
    // The segments fill balls that grow from the origin to the whole lamp. Let w be the vector from
    // the occluder's centre to the origin, and d the vector from there to the lamp's centre. The
    // segments miss the occluder if f(t) = |w + t d|² − (r + t ρ)² > 0 for all t from 0 to 1.
    let (offset, size) = ray.origin.seen_from(center);
    let to_lamp = -ray.origin.from(lamp);
    let points = (center.abs() + lamp.abs()).element_sum();
    let size = size + ray.origin.size() + points + radius + lamp_radius;
    let bound = size * (OCCLUSION * size + 8.0 * ray.astray);
    let a = to_lamp.length_squared() - lamp_radius * lamp_radius;
    let b = offset.dot(to_lamp) - radius * lamp_radius;
    let c = offset.length_squared() - radius * radius;
    if c <= bound || a + 2.0 * b + c <= bound {
        return false;
    }
    let lowest_within = a > 0.0 && b < 0.0 && -b < a;
    !lowest_within || a * c - b * b > bound * (a + size * size)
}
