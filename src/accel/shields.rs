//! What certainly does not stand between a place and a lamp, and what certainly does.

use glam::DVec3;

use super::divide::Divide;
use super::receivers::Body;
use crate::math::error_bounds::SLIDE;
use crate::math::{Flat, Point, Ray, Side, UNIT};
use crate::surface::{Lamp, Surface};

/// A surface as it stands before a lamp, made ready to be asked about places.
#[derive(Debug)]
pub(super) enum Shield {
    /// A plane without end, or one that the lamp is on both sides of, is certain of nothing more
    /// than what its borders say; `lamp` is the side that all of the lamp is on.
    Flat {
        flat: Flat,
        lamp: Option<Side>,
        borders: Vec<Border>,
    },
    /// A round thing within a ball, and a plane between it and the lamp, if one is known.
    Ball {
        center: DVec3,
        radius: f64,
        lamp: (DVec3, f64),
        divide: Option<Divide>,
    },
    /// One that is behind the lamp, by more than rounding for a way of this size.
    Behind { farthest: f64 },
    /// One of which nothing is known.
    Unknown,
}

/// How a surface stands between a place and a lamp.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stand {
    /// It hides nothing of the lamp.
    Beside,
    /// It may hide some of it.
    Doubtful,
    /// It hides all of it.
    Before,
}

/// The planes through one border of a surface and each corner of a lamp.
#[derive(Debug)]
pub(super) struct Border {
    point: DVec3,
    planes: Vec<Plane>,
}

/// A plane through the point of a border; the surface is on the side that the normal points to.
#[derive(Debug)]
struct Plane {
    normal: DVec3,
    /// What a height above it can be off by, as a polynomial in the place's size.
    doubt: [f64; 3],
}

/// How far a rounded number here can be from what it stands for, in units of the sizes that it was
/// made of: 2⁻⁴³. Corners, places and points of a lamp are off by 16 roundings of their size at most,
/// a product of three differences of them by three times two of these and 11 more; that is
/// far less. A ray whose direction is rounded passes a corner of the lamp as far off as if that were moved by a few
/// roundings of the whole way. Nothing depends on the rest, since whatever is in doubt is asked.
pub(super) const BLUR: f64 = 1024.0 * UNIT;

impl Shield {
    /// What a surface is to a lamp; `body` and `source` are these two.
    pub(super) fn new(surface: &dyn Surface, body: &Body, lamp: &Lamp, source: &Body) -> Self {
        if let Some(flat) = surface.flat() {
            return Self::Flat {
                flat: *flat,
                lamp: body.side_of(source),
                borders: Border::all(&surface.outline(), body.overhang, &source.corners()),
            };
        }
        let Some([center, axes]) = surface.round() else {
            return Self::Unknown;
        };
        let radius = axes.max_element();
        let farthest = lamp.flat().map(|flat| {
            let (way, size) = Point::exact(center).seen_from(flat.point);
            let base = Point::exact(flat.point).size();
            let gap = -flat.normal.dot(way) - radius - flat.slack();
            gap / BLUR - (size + base + radius)
        });
        if let Some(farthest) = farthest.filter(|farthest| *farthest > 0.0) {
            return Self::Behind { farthest };
        }
        Self::Ball {
            center,
            radius,
            lamp: (lamp.center().world(), lamp.reach()),
            divide: body.divide_from(source),
        }
    }

    /// The side that all of the lamp is on, but for what touches it; `None` if there is none, or if that
    /// is not known.
    pub(super) fn side_of_lamp(&self) -> Option<Side> {
        match self {
            Self::Flat { lamp, .. } => *lamp,
            Self::Ball {
                divide: Some(_), ..
            }
            | Self::Behind { .. } => Some(Side::Front),
            Self::Ball {
                center,
                radius,
                lamp,
                divide: None,
            } => {
                let size = lamp.0.abs().element_sum() + center.abs().element_sum();
                let apart = radius + lamp.1 + BLUR * (size + radius + lamp.1);
                ((lamp.0 - *center).length() > apart).then_some(Side::Front)
            }
            Self::Unknown => None,
        }
    }

    /// Whether it certainly hides nothing of the lamp from any place of another surface, if it is
    /// round.
    pub(super) fn hides_nothing_from(&self, receiver: &Body) -> bool {
        let hides_nothing_from = |point| {
            let point = Point::exact(point);
            match self {
                Self::Behind { farthest } => point.size() < *farthest,
                // Hits lie between these points, or slide along the surface beyond them.
                Self::Ball {
                    divide: Some(divide),
                    ..
                } => divide.has_before_it(&point, SLIDE * point.size()),
                Self::Flat { .. } | Self::Ball { .. } | Self::Unknown => false,
            }
        };
        let hull = receiver.hull();
        hull.is_some_and(|mut hull| hull.all(hides_nothing_from))
    }

    /// How it stands between the lamp and a hit, from which a ray starts.
    pub(super) fn stands(&self, hit: &Ray) -> Stand {
        match self {
            Self::Flat {
                flat,
                lamp,
                borders,
            } => stands_flat(flat, *lamp, borders, hit),
            Self::Ball {
                center,
                radius,
                lamp,
                divide,
            } => {
                let is_before = |it: &Divide| it.has_before_it(&hit.origin, hit.astray);
                if divide.as_ref().is_some_and(is_before)
                    || misses_ball(*center, *radius, *lamp, hit)
                {
                    Stand::Beside
                } else {
                    Stand::Doubtful
                }
            }
            Self::Behind { farthest } if hit.size() < *farthest => Stand::Beside,
            Self::Behind { .. } => Stand::Doubtful,
            Self::Unknown => Stand::Doubtful,
        }
    }
}

fn stands_flat(flat: &Flat, lamp: Option<Side>, borders: &[Border], hit: &Ray) -> Stand {
    let (way, size) = hit.origin.seen_from(flat.point);
    let height = flat.normal.dot(way);
    let base = Point::exact(flat.point).size();
    let certain = height.abs() > BLUR * (size + base) + hit.astray + flat.slack();
    let behind = match lamp {
        // Nothing is on both sides of a plane in which it lies.
        Some(Side::On) => return Stand::Beside,
        Some(side) if certain => {
            if (side == Side::Front) == (height > 0.0) {
                return Stand::Beside;
            }
            true
        }
        _ => false,
    };
    let mut inside = behind && !borders.is_empty();
    for border in borders {
        match border.side(hit) {
            Some(Side::Back) => return Stand::Beside,
            Some(Side::Front) => {}
            _ => inside = false,
        }
    }
    if inside {
        Stand::Before
    } else {
        Stand::Doubtful
    }
}

impl Border {
    /// The borders of an outline, as seen from the corners of a lamp; of one from which they see the
    /// surface on different sides there is nothing to say. What decides may lie `beside` them by so much.
    fn all(outline: &[DVec3], beside: f64, corners: &[DVec3]) -> Vec<Self> {
        let next = outline.iter().cycle().skip(1);
        let inner = outline.iter().cycle().skip(2);
        let borders = outline.iter().zip(next).zip(inner);
        let planes = |((from, to), inner): ((&DVec3, &DVec3), &DVec3)| {
            let planes = corners
                .iter()
                .map(|corner| Plane::new(*corner, [*from, *to], beside, *inner));
            let planes: Option<Vec<_>> = planes.collect();
            let planes = planes.unwrap_or_default();
            let turned = |(_, turned): &(Plane, bool)| *turned;
            let uniform = planes.iter().all(turned) || !planes.iter().any(turned);
            let planes = planes.into_iter().filter(|_| uniform);
            Self {
                point: *from,
                planes: planes.map(|(plane, _)| plane).collect(),
            }
        };
        borders.map(planes).collect()
    }

    /// The side of all planes that a place is on for certain: in front with the surface, or behind.
    fn side(&self, hit: &Ray) -> Option<Side> {
        let (way, _) = hit.origin.seen_from(self.point);
        let size = hit.origin.size();
        let mut sides = self
            .planes
            .iter()
            .map(|plane| plane.side(way, size, hit.astray));
        let first = sides.next()??;
        sides.all(|side| side == Some(first)).then_some(first)
    }
}

impl Plane {
    /// The plane through a lamp's corner and a border, and whether it had to be turned for its
    /// front to be the inner side; `None` if that is in doubt.
    fn new(
        corner: DVec3,
        [from, to]: [DVec3; 2],
        beside: f64,
        inner: DVec3,
    ) -> Option<(Self, bool)> {
        let normal = (from - corner).cross(to - corner);
        let size = |point: DVec3| (point.abs() + corner.abs()).element_sum();
        let share = BLUR * size(from) * size(to) + beside * (size(from) + size(to) + beside);
        let bend = BLUR * (size(from) + size(to));
        let fixed =
            share * (size(from) + corner.abs().element_sum()) + normal.abs().element_sum() * beside;
        let height = normal.dot(inner - from);
        let turned = height < 0.0;
        (height.abs() > fixed + share * size(inner)).then(|| {
            let plane = Self {
                normal: if turned { -normal } else { normal },
                doubt: [fixed, share, bend],
            };
            (plane, turned)
        })
    }

    fn side(&self, way: DVec3, size: f64, astray: f64) -> Option<Side> {
        let height = self.normal.dot(way);
        let [fixed, share, bend] = self.doubt;
        let doubt = fixed + (share + bend * size) * size + self.normal.abs().element_sum() * astray;
        (height.abs() > doubt).then_some(if height > 0.0 {
            Side::Front
        } else {
            Side::Back
        })
    }
}

/// Whether a ball certainly lies beside everything between a place and the ball around a lamp.
///
/// Between the two are balls, from a point at the place to all of the lamp. With `w` from the
/// ball's centre to the place and `d` from there to the lamp's, the squared distance beyond both
/// radii is `f(t) = |w + t d|² − (r + t ρ)²`, and must be above zero for all `t` from 0 to 1.
fn misses_ball(center: DVec3, radius: f64, (lamp, reach): (DVec3, f64), hit: &Ray) -> bool {
    let (way, size) = hit.origin.seen_from(center);
    let onward = -hit.origin.from(lamp);
    let size =
        size + hit.origin.size() + (center.abs() + lamp.abs()).element_sum() + radius + reach;
    let doubt = size * (BLUR * size + 8.0 * hit.astray);
    let a = onward.length_squared() - reach * reach;
    let b = way.dot(onward) - radius * reach;
    let c = way.length_squared() - radius * radius;
    if c <= doubt || a + 2.0 * b + c <= doubt {
        return false;
    }
    let lowest_within = a > 0.0 && b < 0.0 && -b < a;
    !lowest_within || a * c - b * b > doubt * (a + size * size)
}
