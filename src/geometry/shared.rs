//! Planes and borders that surfaces share, found when a scene is loaded.

use std::cmp::Ordering;
use std::collections::{HashMap, HashSet};

use dashu_ratio::RBig;
use glam::DVec3;

use super::{Planar, Shape};
use crate::math::exact::{RationalVector, decimal};
use crate::math::{ExactGeometry, Line};

/// How far apart planes or lines may be and still be one, in units of the last place of the
/// largest coordinate, where they are sums or products of the numbers in the file.
///
/// The corners of a wall along (1, 1, 0) are irrational, so whoever writes them down rounds them;
/// and a scene that a program has scaled has every number rounded. Smaller, and decimals written to
/// the last digit leave gaps; larger, and surfaces that are meant to be apart become one. What is a
/// single number, such as the height of a floor, is the same only if the number is.
const ULPS: u8 = 8;

/// A plane or a line that surfaces share.
#[derive(Debug, Clone, PartialEq)]
pub struct Shared {
    /// What is shared.
    pub what: SharedKind,
    /// The surfaces by their places in the file.
    pub surfaces: Vec<usize>,
    /// How far apart they were at most in the file, in world units; 0 if its decimals agree.
    pub distance: f64,
}

/// What surfaces can share.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SharedKind {
    /// The plane that they lie in.
    Plane,
    /// A line along which they meet from both sides.
    Line,
}

/// Something with a position, on its way into a group of what is at one position.
#[derive(Debug)]
struct Member {
    /// The position along the direction that the group shares.
    position: RBig,
    /// The largest coordinate that went into it.
    magnitude: f64,
    /// Whether the position is a single number of the file.
    single: bool,
    surface: usize,
    border: usize,
    /// Whether normal or border point along the direction that the group shares.
    forward: bool,
    /// Where a border begins and ends along that direction.
    stretch: [RBig; 2],
}

/// Lets surfaces that share a plane or a border line decide by the same numbers.
///
/// Lines that surfaces meet from both sides are owned by those on one side, so that a ray
/// through the line meets exactly one of two neighbours, of four around a corner, of three at a
/// T-junction. A border that is not beside neighbours all along stays with its surface, or rays would
/// pass where it has none.
pub fn share(shapes: &mut [&mut Shape]) -> Vec<Shared> {
    let geometries = shapes.iter().map(|shape| shape.planar());
    let geometries: Vec<_> = geometries.map(|it| Some(it?.exact_geometry())).collect();
    let mut shared = Vec::new();
    for plane in planes(&geometries) {
        let carriers = plane
            .iter()
            .filter_map(|one| shapes[one.surface].carrier().copied());
        let decisive = carriers.min_by(|a, b| order(&a.decisive(), &b.decisive()));
        let Some(decisive) = decisive.filter(|_| plane.len() > 1) else {
            continue;
        };
        shared.push(Shared::of(SharedKind::Plane, &plane));
        let mut borders = shared_borders(shapes, &plane, &geometries, &mut shared);
        for member in &plane {
            let borders = borders.remove(&member.surface).unwrap_or_default();
            if let Some(shape) = shapes[member.surface].planar_mut() {
                shape.share(&decisive, &borders);
            }
        }
    }
    shared
}

/// The shared borders of each surface in a plane, in the order of its own.
///
/// Adds those that are shared to a list.
fn shared_borders(
    shapes: &[&mut Shape],
    plane: &[Member],
    geometries: &[Option<ExactGeometry>],
    shared: &mut Vec<Shared>,
) -> HashMap<usize, Vec<Option<Line>>> {
    let own = |member: &Member| -> &[Line] {
        let shape = shapes[member.surface].planar();
        shape.map_or(&[], Planar::borders)
    };
    let fronts = plane.iter().map(|one| (one.surface, one.forward));
    let fronts: HashMap<usize, bool> = fronts.collect();
    let mut borders: HashMap<usize, Vec<Option<Line>>> = HashMap::new();
    for line in lines(plane, geometries) {
        let both_sides = line.iter().any(|member| member.forward != line[0].forward);
        if !both_sides {
            continue;
        }
        shared.push(Shared::of(SharedKind::Line, &line));
        let by_numbers = |a: &&Member, b: &&Member| {
            let [a, b] = [a, b].map(|member| own(member)[member.border]);
            order(&[a.point, a.dir.abs()], &[b.point, b.dir.abs()])
        };
        let Some(first) = line.iter().min_by(by_numbers) else {
            continue;
        };
        let decisive = own(first)[first.border];
        for (member, owned) in line.iter().zip(owners(&line)) {
            let same_front = fronts.get(&member.surface) == fronts.get(&first.surface);
            let mut border = decisive.for_neighbor(same_front, member.forward == first.forward);
            border.owned = owned;
            let all = borders.entry(member.surface);
            let all = all.or_insert_with(|| vec![None; own(member).len()]);
            all[member.border] = Some(border);
        }
    }
    borders
}

/// An order of places and directions, so that what decides does not depend on the order of a file.
fn order(a: &[DVec3; 2], b: &[DVec3; 2]) -> Ordering {
    let numbers = |vectors: &[DVec3; 2]| vectors.map(|vector| vector.to_array()).concat();
    let (a, b) = (numbers(a), numbers(b));
    let orders = a.iter().zip(&b).map(|(a, b)| a.total_cmp(b));
    orders.fold(Ordering::Equal, Ordering::then)
}

/// The surfaces in each plane, in file order; the planes too.
fn planes(geometries: &[Option<ExactGeometry>]) -> Vec<Vec<Member>> {
    let mut directions = Directions::default();
    for (surface, geometry) in geometries.iter().enumerate() {
        let Some(geometry) = geometry else {
            continue;
        };
        let (direction, turned) = geometry.normal.canonical();
        directions.put(direction, Member::new(surface, 0, !turned));
    }
    directions.grouped(|direction, members| {
        let (length, _) = direction.length();
        for member in members {
            let Some(geometry) = &geometries[member.surface] else {
                continue;
            };
            member.position = direction.dot(&geometry.point) / &length;
            member.magnitude = geometry.point.largest();
            member.single = direction.is_along_an_axis();
        }
    })
}

/// The borders on each line of a plane, of surfaces on both sides of it or on one.
fn lines(plane: &[Member], geometries: &[Option<ExactGeometry>]) -> Vec<Vec<Member>> {
    let mut directions = Directions::default();
    let first = plane
        .first()
        .and_then(|one| geometries[one.surface].as_ref());
    let Some(first) = first.filter(|_| plane.len() > 1) else {
        return Vec::new();
    };
    for one in plane {
        let Some(geometry) = &geometries[one.surface] else {
            continue;
        };
        for (border, line) in geometry.borders.iter().enumerate() {
            let (direction, turned) = line.along.canonical();
            // Seen along the shared normal, the outer side is to the left of a border, and to the
            // right if its surface faces the other way or the shared direction is turned.
            let forward = turned != one.forward;
            directions.put(direction, Member::new(one.surface, border, forward));
        }
    }
    let (normal, _) = first.normal.canonical();
    directions.grouped(|direction, members| {
        let (outer, flipped) = normal.cross(direction).canonical();
        let [(length, _), (unit, _)] = [outer.length(), direction.length()];
        for member in members {
            let Some(geometry) = &geometries[member.surface] else {
                continue;
            };
            let line = &geometry.borders[member.border];
            let outward = if member.forward == flipped { -1 } else { 1 };
            let across = &line.across * RBig::from(outward);
            member.position = outer.dot(&line.point) / &length + &across;
            member.magnitude = line.point.largest() + across.to_f64().value().abs();
            member.single = outer.is_along_an_axis() && across.is_zero();
            let ends = line.stretch.each_ref();
            let places = ends.map(|share| &line.point + &line.along.times(share));
            member.stretch = places.map(|place| direction.dot(&place) / &unit);
            member.stretch.sort();
        }
    })
}

/// Whether the borders on a line belong to their surfaces: those on one side do, and those on the other
/// that are not beside them all along. So where tiles meet in a point it belongs to one of them at least.
fn owners(line: &[Member]) -> Vec<bool> {
    let places = line.iter().flat_map(|member| &member.stretch);
    let sizes = places.map(|place| place.to_f64().value().abs());
    let magnitudes = line.iter().map(|member| member.magnitude);
    let tolerance = tolerance(magnitudes.chain(sizes).fold(0.0, f64::max));
    let neighbors = joined(line, &tolerance);
    let owned = |one: &Member| one.forward || !is_covered(one, &neighbors, &tolerance);
    line.iter().map(owned).collect()
}

/// The stretches of the forward borders in their order along the line; those that touch are one.
fn joined(line: &[Member], tolerance: &RBig) -> Vec<[RBig; 2]> {
    let forward = line.iter().filter(|border| border.forward);
    let mut stretches: Vec<_> = forward.map(|border| border.stretch.clone()).collect();
    stretches.sort();
    let mut joined: Vec<[RBig; 2]> = Vec::new();
    for [begin, end] in stretches {
        match joined.last_mut() {
            Some([_, last]) if begin <= &*last + tolerance => {
                if end > *last {
                    *last = end;
                }
            }
            _ => joined.push([begin, end]),
        }
    }
    joined
}

/// Whether a border runs beside one of these stretches all along.
fn is_covered(border: &Member, stretches: &[[RBig; 2]], tolerance: &RBig) -> bool {
    let [begin, end] = &border.stretch;
    let later = stretches.partition_point(|[first, _]| *first <= begin + tolerance);
    let beside = later.checked_sub(1).and_then(|index| stretches.get(index));
    beside.is_some_and(|[_, last]| *end <= last + tolerance)
}

/// How far apart positions may be and still be one, if this is the largest coordinate in them.
fn tolerance(magnitude: f64) -> RBig {
    decimal(magnitude.next_up() - magnitude) * RBig::from(ULPS)
}

/// Members by the directions that they share, in the order in which those appear.
#[derive(Debug, Default)]
struct Directions {
    all: Vec<(RationalVector, Vec<Member>)>,
    known: HashMap<RationalVector, usize>,
}

impl Directions {
    fn put(&mut self, direction: RationalVector, member: Member) {
        let index = *self.known.entry(direction.clone()).or_insert_with(|| {
            self.all.push((direction, Vec::new()));
            self.all.len() - 1
        });
        self.all[index].1.push(member);
    }

    /// The members of each direction, cut into groups of one position each; `place` gives them their
    /// positions, where there is more than one surface.
    ///
    /// A group has no two borders of a surface that it is on either side of.
    fn grouped(self, place: impl Fn(&RationalVector, &mut [Member])) -> Vec<Vec<Member>> {
        let mut groups: Vec<Vec<Member>> = Vec::new();
        for (direction, mut members) in self.all {
            if members
                .iter()
                .all(|member| member.surface == members[0].surface)
            {
                groups.extend(members.into_iter().map(|alone| vec![alone]));
                continue;
            }
            place(&direction, &mut members);
            members.sort_by(|a, b| a.position.cmp(&b.position));
            let start = groups.len();
            let mut in_group = HashSet::new();
            for member in members {
                let last = groups.get_mut(start..).and_then(<[_]>::last_mut);
                // The first lies lowest, so no other is further off.
                let group = last.filter(|group| {
                    group.first().is_some_and(|first| first.is_at(&member))
                        && !in_group.contains(&(member.surface, !member.forward))
                });
                if group.is_none() {
                    in_group.clear();
                }
                in_group.insert((member.surface, member.forward));
                match group {
                    Some(group) => group.push(member),
                    None => groups.push(vec![member]),
                }
            }
            for group in &mut groups[start..] {
                group.sort_by_key(|member| (member.surface, member.border));
            }
        }
        groups
    }
}

impl Member {
    /// A member whose position is not known yet.
    fn new(surface: usize, border: usize, forward: bool) -> Self {
        Self {
            position: RBig::ZERO,
            magnitude: 0.0,
            single: false,
            surface,
            border,
            forward,
            stretch: [RBig::ZERO, RBig::ZERO],
        }
    }

    /// Whether another member, of the same direction, has the same position.
    fn is_at(&self, other: &Self) -> bool {
        let apart = &other.position - &self.position;
        if apart.is_zero() {
            return true;
        }
        if self.single && other.single {
            return false;
        }
        let tolerance = tolerance(self.magnitude.max(other.magnitude));
        apart <= tolerance && -&apart <= tolerance
    }
}

impl Shared {
    fn of(what: SharedKind, members: &[Member]) -> Self {
        let positions = || members.iter().map(|member| &member.position);
        let distance = match (positions().min(), positions().max()) {
            (Some(low), Some(high)) => (high - low).to_f64().value(),
            _ => 0.0,
        };
        let mut surfaces: Vec<_> = members.iter().map(|member| member.surface).collect();
        surfaces.dedup();
        Self {
            what,
            surfaces,
            distance,
        }
    }
}
