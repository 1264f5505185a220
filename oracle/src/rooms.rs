//! Closed rooms, of which no ray finds a way out, however often it is mirrored.

use glam::{DVec2, DVec3};
use heliodon::geometry::{Hit, Plane, Rectangle, Sphere};
use heliodon::math::{Point, Ray, Span, unit};
use heliodon::surface::share;
use heliodon::visibility::SurfaceList;

use crate::cases::{Boxed, boxed};
use crate::tally::Tally;
use support::random::Random;

/// A room with mirrors for walls.
#[derive(Debug)]
pub struct Room {
    /// Walls, panes and balls.
    pub surfaces: Vec<Boxed>,
    /// Which of them can be passed through.
    transparent: Vec<usize>,
    center: DVec3,
    /// From the centre to the middle of each of three walls; the others are opposite.
    reach: [DVec3; 3],
}

impl Room {
    /// Of six unbounded planes in any directions.
    pub fn of_planes(random: &mut Random, scale: f64) -> Self {
        let first = unit(random.cube()).unwrap_or(DVec3::X);
        let second = unit(first.any_orthogonal_vector()).unwrap_or(DVec3::Y);
        let across = [first, second, first.cross(second)];
        // Not quite a box, but far from flat.
        let skew = if random.once_in(2) { 0.1 } else { 0.0 };
        let normals = across.map(|normal| normal + random.cube() * skew);
        let center = if random.once_in(4) {
            DVec3::ZERO
        } else {
            random.cube() * random.power(-3, 8)
        };
        let walls = normals.map(|normal| normal * (0.8 + 0.4 * random.share()));
        let mut surfaces = Vec::new();
        for (wall, normal) in walls.iter().zip(&normals) {
            for side in [-1.0, 1.0] {
                let point = (center + *wall * side) * scale;
                let made = Plane::new(point, -*normal * side).expect("a normal");
                surfaces.push(boxed(made));
            }
        }
        let room = Self {
            surfaces,
            transparent: Vec::new(),
            center: center * scale,
            reach: walls.map(|wall| wall * scale),
        };
        room.furnished(random)
    }

    /// Of finite planes along the world's axes with decimals for corners, or scaled whole numbers, some cut into tiles.
    pub fn of_rectangles(random: &mut Random, scale: f64) -> Self {
        // Multiplied, decimals no longer add up: the walls of such a room would not meet.
        let divisor = if scale == 1.0 { 10.0 } else { 1.0 };
        let length = |value: i32| f64::from(value) / divisor;
        let low = [0; 3].map(|_| random.between(-300, 300));
        let high = low.map(|low| low + random.between(3, 200));
        let mut surfaces: Vec<Boxed> = Vec::new();
        for axis in 0..3 {
            let [x, y] = [(axis + 1) % 3, (axis + 2) % 3];
            for (at, inward) in [(low[axis], 1.0), (high[axis], -1.0)] {
                let cuts = [x, y].map(|axis| cut(random, low[axis], high[axis]));
                for across in cuts[0].windows(2) {
                    for upward in cuts[1].windows(2) {
                        let mut corner = [0.0; 3];
                        corner[axis] = length(at);
                        corner[x] = length(across[0]);
                        corner[y] = length(upward[0]);
                        // Seen from inside, x × y is along the axis or against it.
                        let [first, second] = if inward > 0.0 { [x, y] } else { [y, x] };
                        let spans = [length(across[1] - across[0]), length(upward[1] - upward[0])];
                        let size = if inward > 0.0 {
                            spans
                        } else {
                            [spans[1], spans[0]]
                        };
                        debug_assert_ne!(first, second);
                        let made = Rectangle::new(
                            DVec3::from(corner) * scale,
                            DVec3::AXES[axis] * inward,
                            DVec3::AXES[first],
                            DVec2::from(size) * scale,
                        );
                        surfaces.push(boxed(made.expect("a wall")));
                    }
                }
            }
        }
        share(&mut surfaces);
        let [low, high] = [low, high].map(|corner| DVec3::from(corner.map(length)) * scale);
        let half = (high - low) / 2.0;
        let room = Self {
            surfaces,
            transparent: Vec::new(),
            center: low + half,
            reach: [DVec3::X * half.x, DVec3::Y * half.y, DVec3::Z * half.z],
        };
        room.furnished(random)
    }

    /// A room of planes of any size that a scene may have.
    pub fn scaled_planes(random: &mut Random) -> Self {
        let scale = random.power(-200, 200);
        Self::of_planes(random, scale)
    }

    /// A room of rectangles whose numbers have so few digits that their decimals add up.
    pub fn scaled_rectangles(random: &mut Random) -> Self {
        let scale = if random.once_in(2) {
            1.0
        } else {
            random.power(-6, 40)
        };
        Self::of_rectangles(random, scale)
    }

    /// With a pane across, a ball, both or neither.
    fn furnished(mut self, random: &mut Random) -> Self {
        if random.once_in(2) {
            self.transparent.push(self.surfaces.len());
            let pane = Plane::new(self.place(random, 0.2), random.cube());
            self.surfaces.push(boxed(pane.expect("a normal")));
        }
        if random.once_in(2) {
            let radius = self
                .reach
                .map(DVec3::length)
                .into_iter()
                .fold(f64::MAX, f64::min)
                / 8.0;
            self.transparent.push(self.surfaces.len());
            let ball = Sphere::new(self.place(random, 0.3), radius);
            self.surfaces.push(boxed(ball.expect("a radius")));
        }
        self
    }

    /// A place up to so much of the way to the walls.
    fn place(&self, random: &mut Random, most: f64) -> DVec3 {
        let offset: DVec3 = self
            .reach
            .iter()
            .map(|reach| *reach * (random.signed() * most))
            .sum();
        self.center + offset
    }

    /// A direction from a place: any, or towards the edges and corners of the room.
    fn direction(&self, random: &mut Random, from: DVec3) -> DVec3 {
        let way = if random.once_in(4) {
            random.cube()
        } else if random.once_in(4)
            && let Some(seam) = self.seam(random)
        {
            seam - from
        } else {
            // Towards a corner, or somewhere on an edge.
            let inner = random.below(6) as usize;
            let mut target = DVec3::ZERO;
            for (axis, reach) in self.reach.iter().enumerate() {
                let end = if random.once_in(2) { 1.0 } else { -1.0 };
                target += *reach * if axis == inner { random.signed() } else { end };
            }
            let beside = target.length() * random.power(-51, -2);
            let aimed = self.center + target - from;
            // The largest rooms are too large for squares of squares.
            (aimed + random.cube() * beside) / target.length()
        };
        unit(way).unwrap_or(DVec3::X)
    }

    /// A place where a pane ends at a wall.
    fn seam(&self, random: &mut Random) -> Option<DVec3> {
        let pane = self
            .transparent
            .iter()
            .find_map(|pane| self.surfaces[*pane].shape().carrier())?;
        let wall = random.below(3) as usize;
        let end = if random.once_in(2) { 1.0 } else { -1.0 };
        let across = self.reach[(wall + 1) % 3] * random.signed();
        let place = self.center + self.reach[wall] * end + across;
        // Along the third direction, to where the pane is.
        let along = self.reach[(wall + 2) % 3];
        let share = pane.normal.dot(pane.point - place) / pane.normal.dot(along);
        (share.abs() < 1.0).then(|| place + along * share)
    }

    /// Sends a ray from inside; it has to meet a wall.
    pub fn ask(&self, list: &SurfaceList, random: &mut Random, tally: &mut Tally) {
        let from = self.place(random, 0.3);
        let ray = Ray::new(Point::exact(from), self.direction(random, from));
        tally.cases += 1;
        if list.nearest(&ray, Span::AHEAD, &mut 0).is_some() {
            tally.positive += 1;
        } else {
            tally.leaks += 1;
            tally.wrong(|| format!("nothing is met by {ray:?} in {self:?}"));
        }
    }

    /// Sends a ray from a wall, where rounding has put it a place or two beyond the others that
    /// meet in the corner or on an edge; it has to meet one of them, or what is opposite.
    pub fn ask_in_corner(&self, list: &SurfaceList, random: &mut Random, tally: &mut Tally) {
        let from = self.place(random, 0.3);
        let ends = self
            .reach
            .map(|reach| if random.once_in(2) { reach } else { -reach });
        let corner = self.center + ends.into_iter().sum::<DVec3>();
        let ray = Ray::new(Point::exact(from), unit(corner - from).unwrap_or(DVec3::X));
        let Some((entry, hit)) = list.nearest(&ray, Span::AHEAD, &mut 0) else {
            return tally.wrong(|| format!("nothing is met by {ray:?} in {self:?}"));
        };
        // What is in the way is no wall.
        if (hit.point.world() - corner).abs().max_element() > 1e-9 {
            return;
        }
        let mut point = hit.point;
        for axis in 0..3 {
            if hit.normal[axis] == 0.0 {
                let place = corner[axis];
                let ulp = place.next_up() - place;
                point.offset[axis] += ulp * f64::from(random.between(-2, 2));
            }
        }
        let ray_origin = entry.ray_origin(&ray, &Hit { point, ..hit });
        let way = random.cube();
        let inward = way - hit.normal * (2.0 * way.dot(hit.normal)).min(0.0);
        let next = Ray::spawn(&ray_origin, unit(inward).unwrap_or(hit.normal));
        tally.cases += 1;
        if list.nearest(&next, Span::AHEAD, &mut 0).is_some() {
            tally.positive += 1;
        } else {
            tally.leaks += 1;
            tally.wrong(|| format!("nothing is met by {next:?} in {self:?}"));
        }
    }

    /// Follows a ray through mirrors and panes; every hit has to be on something that it leads to.
    pub fn follow(&self, list: &SurfaceList, random: &mut Random, bounces: u32, tally: &mut Tally) {
        let from = self.place(random, 0.3);
        let ray = Ray::new(Point::exact(from), self.direction(random, from));
        self.follow_on(list, &ray, random, bounces, tally);
    }

    fn follow_on(
        &self,
        list: &SurfaceList,
        ray: &Ray,
        random: &mut Random,
        bounces: u32,
        tally: &mut Tally,
    ) {
        tally.cases += 1;
        let Some((entry, hit)) = list.nearest(ray, Span::AHEAD, &mut 0) else {
            tally.leaks += 1;
            tally.wrong(|| format!("nothing is met by {ray:?} in {self:?}"));
            return;
        };
        let can_be_passed = self.transparent.contains(&entry.index);
        // Walls face the inside of the room, and a ray inside of a ball has left it already.
        let is_pane = entry.surface.shape().carrier().is_some() && can_be_passed;
        let from_behind = !is_pane && ray.dir.dot(hit.normal) > 4.0 * f64::EPSILON;
        if from_behind || ray.leaves() == entry.carrier {
            tally.self_hits += 1;
            let index = entry.index;
            tally.wrong(|| format!("surface {index} is met again by {ray:?} in {self:?}"));
            return;
        }
        tally.positive += 1;
        if bounces == 0 {
            return;
        }
        let ray_origin = entry.ray_origin(ray, &hit);
        let through = can_be_passed && random.once_in(2);
        let dir = if through {
            ray.dir
        } else {
            ray.mirrored(hit.normal)
        };
        self.follow_on(
            list,
            &Ray::spawn(&ray_origin, dir),
            random,
            bounces - 1,
            tally,
        );
    }
}

/// Where a wall is cut: not at all, or once.
fn cut(random: &mut Random, low: i32, high: i32) -> Vec<i32> {
    if random.once_in(2) {
        vec![low, high]
    } else {
        vec![low, random.between(low + 1, high - 1), high]
    }
}
