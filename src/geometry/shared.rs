//! Planes and borders that surfaces share, found when a scene is loaded.

use std::cmp::Ordering;
use std::collections::{HashMap, HashSet};

use dashu_ratio::RBig;
use glam::DVec3;

use super::{Planar, Shape};
use crate::math::exact::{RationalVector, decimal};
use crate::math::{ExactGeometry, Line};

/// The largest distance between planes or lines that count as one.
///
/// It is in units in the last place of the largest coordinate, for sums or products of numbers in
/// the file. Single numbers, such as the height of a floor, must be equal.
// The corners of a wall along (1, 1, 0) are irrational, so their author rounds them. A scene scaled
// by a program has every number rounded. A smaller tolerance leaves gaps between decimals written
// to the last digit. A larger one joins surfaces that are meant to be apart.
const ULPS: u8 = 8;

/// A plane or a line that surfaces share.
#[derive(Debug, Clone, PartialEq)]
pub struct Shared {
    /// The type of the shared geometry.
    pub what: SharedKind,
    /// The surfaces by their positions in the file.
    pub surfaces: Vec<usize>,
    /// The largest distance between them in the file, in world units; 0 if equal.
    pub distance: f64,
}

/// The types of shared geometry.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SharedKind {
    /// A plane of several surfaces.
    Plane,
    /// A line with surfaces on both sides.
    Line,
}

/// A plane or border to be grouped with others at its position.
#[derive(Debug)]
struct Member {
    /// The position along the direction of the group.
    position: RBig,
    /// The largest coordinate in the position.
    magnitude: f64,
    /// True if the position is a single number of the file.
    single: bool,
    surface: usize,
    border: usize,
    /// True if normal or border point along the direction of the group.
    forward: bool,
    /// Both ends of a border along that direction.
    interval: [RBig; 2],
}

/// Lets surfaces that share a plane or a border line decide by the same numbers.
///
/// The surfaces on one side of a line own it. A ray through the line then hits exactly one of two
/// neighbours, of four around a corner, or of three at a T-junction. A border without neighbours
/// all along stays with its surface, or rays would pass where it has none.
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

/// An order of points and directions, independent of the order of the file.
fn order(a: &[DVec3; 2], b: &[DVec3; 2]) -> Ordering {
    let numbers = |vectors: &[DVec3; 2]| vectors.map(|vector| vector.to_array()).concat();
    let (a, b) = (numbers(a), numbers(b));
    let orders = a.iter().zip(&b).map(|(a, b)| a.total_cmp(b));
    orders.fold(Ordering::Equal, Ordering::then)
}

/// The surfaces in each plane, in file order; the planes as well.
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
            // Seen along the shared normal, the outer side is to the left of a border. It is to the
            // right if its surface faces the other way or the shared direction is reversed.
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
            member.interval = places.map(|place| direction.dot(&place) / &unit);
            member.interval.sort();
        }
    })
}

/// The ownership of a line by each border on it.
///
/// Borders on one side own it, as do those on the other without neighbours all along. A point where
/// tiles meet belongs to at least one of them.
fn owners(line: &[Member]) -> Vec<bool> {
    let places = line.iter().flat_map(|member| &member.interval);
    let sizes = places.map(|place| place.to_f64().value().abs());
    let magnitudes = line.iter().map(|member| member.magnitude);
    let tolerance = tolerance(magnitudes.chain(sizes).fold(0.0, f64::max));
    let neighbors = joined(line, &tolerance);
    let owned = |one: &Member| one.forward || !is_covered(one, &neighbors, &tolerance);
    line.iter().map(owned).collect()
}

/// The intervals of the forward borders along the line, joined where they touch.
fn joined(line: &[Member], tolerance: &RBig) -> Vec<[RBig; 2]> {
    let forward = line.iter().filter(|border| border.forward);
    let mut intervals: Vec<_> = forward.map(|border| border.interval.clone()).collect();
    intervals.sort();
    let mut joined: Vec<[RBig; 2]> = Vec::new();
    for [begin, end] in intervals {
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

/// Returns whether a border is within one of these intervals.
fn is_covered(border: &Member, intervals: &[[RBig; 2]], tolerance: &RBig) -> bool {
    let [begin, end] = &border.interval;
    let later = intervals.partition_point(|[first, _]| *first <= begin + tolerance);
    let neighbor = later.checked_sub(1).and_then(|index| intervals.get(index));
    neighbor.is_some_and(|[_, last]| *end <= last + tolerance)
}

/// The largest distance between equal positions, for this largest coordinate.
fn tolerance(magnitude: f64) -> RBig {
    decimal(magnitude.next_up() - magnitude) * RBig::from(ULPS)
}

/// Members by shared direction, in the order of first appearance.
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

    /// The members of each direction, in groups of one position each.
    ///
    /// `place` computes the positions if there is more than one surface. No group has two borders
    /// of one surface on opposite sides.
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
                // The first has the lowest position, so no other is further off.
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
    /// A member without a position yet.
    fn new(surface: usize, border: usize, forward: bool) -> Self {
        Self {
            position: RBig::ZERO,
            magnitude: 0.0,
            single: false,
            surface,
            border,
            forward,
            interval: [RBig::ZERO, RBig::ZERO],
        }
    }

    /// Returns whether another member of the same direction has the same position.
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
