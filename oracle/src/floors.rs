//! Floors of tiles that share edges, corners and T-junctions, and rays aimed at those.

use glam::{DVec2, DVec3};
use heliodon::geometry::{Rectangle, SharedKind, Triangle};
use heliodon::math::{Frame, Point, Ray, Span, unit};
use heliodon::surface::share;

use crate::cases::{Boxed, boxed};
use crate::rational::{Vector, number};
use crate::tally::Tally;
use support::random::Random;

/// Rows of tiles, cut at the same places or at others, each tile written down in its own way.
#[derive(Debug)]
pub struct Floor {
    surfaces: Vec<Boxed>,
    axes: Axes,
    /// The cuts of each row, in tenths.
    cuts: Vec<Vec<i32>>,
    /// Where rows begin and end, in tenths.
    rows: Vec<i32>,
}

/// How a floor lies in space.
#[derive(Debug)]
struct Axes {
    /// The corner of the floor, in tenths.
    base: [i32; 3],
    /// All lengths are multiples of so many tenths.
    step: i32,
    /// Where x, y and the normal point, in whole numbers or in any direction.
    given: [DVec3; 3],
    /// The length of x and of y, if they are made of whole numbers.
    whole: Option<i32>,
    /// The size of a unit.
    scale: f64,
}

impl Axes {
    /// Along the world's axes, along whole numbers whose length is a whole number, or anyhow.
    fn any(random: &mut Random) -> Self {
        const ALONG_WORLD: [[DVec3; 3]; 3] = [
            [DVec3::X, DVec3::Y, DVec3::Z],
            [DVec3::Y, DVec3::Z, DVec3::X],
            [DVec3::Z, DVec3::X, DVec3::Y],
        ];
        let step = random.pick(&[1, 10]);
        let base = [0; 3].map(|_| step * random.between(-200, 200));
        let whole = |given, length| Self {
            base,
            step,
            given,
            whole: Some(length),
            scale: 1.0,
        };
        match random.below(3) {
            0 => whole(random.pick(&ALONG_WORLD), 1),
            1 => {
                let axes = [[2.0, 1.0, -2.0], [-2.0, 2.0, -1.0], [1.0, 2.0, 2.0]];
                whole(axes.map(DVec3::from), 3)
            }
            _ => loop {
                let (normal, xdir) = (random.cube(), random.cube());
                let Ok(frame) = Frame::new(normal, xdir) else {
                    continue;
                };
                return Self {
                    base,
                    step,
                    given: [frame.x, frame.y, normal],
                    whole: None,
                    scale: random.power(-100, 100),
                };
            },
        }
    }

    /// The place at some tenths along x and y.
    ///
    /// Where all numbers are whole, tenths and their thirds come out as they would be written.
    fn place(&self, x: i32, y: i32) -> DVec3 {
        let [along_x, along_y, _] = self.given;
        let base = DVec3::from(self.base.map(f64::from));
        let tenths = match self.whole {
            Some(_) => base + along_x * f64::from(x) + along_y * f64::from(y),
            None => {
                let exact = |along, length: i32| Vector::of(along).times(&number(length.into()));
                let sum = Vector::of(base)
                    .plus(&exact(along_x, x))
                    .plus(&exact(along_y, y));
                sum.rounded()
            }
        };
        tenths / 10.0 * self.scale
    }

    /// The length of some tenths.
    fn length(&self, tenths: i32) -> f64 {
        f64::from(tenths * self.whole.unwrap_or(1)) / 10.0 * self.scale
    }
}

impl Floor {
    /// A floor of two or three rows.
    pub fn any(random: &mut Random) -> Self {
        let axes = Axes::any(random);
        let step = axes.step;
        let width = random.between(20, 60);
        let mut rows = vec![0];
        let mut cuts = Vec::new();
        for _ in 0..random.between(2, 3) {
            rows.push(rows[rows.len() - 1] + step * random.between(5, 20));
            let inner = step * random.between(3, width - 3);
            let same = cuts.last().cloned().filter(|_| random.once_in(2));
            cuts.push(same.unwrap_or_else(|| vec![0, inner, step * width]));
        }
        let mut floor = Self {
            surfaces: Vec::new(),
            axes,
            cuts,
            rows,
        };
        for row in 0..floor.cuts.len() {
            for cut in 1..floor.cuts[row].len() {
                let [left, right] = [floor.cuts[row][cut - 1], floor.cuts[row][cut]];
                let tiles = floor.tile(
                    random,
                    [left, right],
                    [floor.rows[row], floor.rows[row + 1]],
                );
                floor.surfaces.extend(tiles);
            }
        }
        floor
    }

    /// A tile, from any of its corners, from the front or the back, or as two triangles.
    fn tile(
        &self,
        random: &mut Random,
        [left, right]: [i32; 2],
        [low, high]: [i32; 2],
    ) -> Vec<Boxed> {
        let Axes {
            given, whole, step, ..
        } = self.axes;
        let [x, y, normal] = given;
        let corners = [[left, low], [right, low], [right, high], [left, high]];
        let places = corners.map(|[x, y]| self.axes.place(x, y));
        // The edges of triangles go through their corners as doubles, so they only meet those of
        // rectangles where the corners are doubles.
        if whole.is_some() && step == 10 && random.once_in(4) {
            let [a, b, c, d] = places;
            let halves = [[a, b, c], [c, d, a]].map(|vertices| {
                let made = Triangle::new(vertices).expect("three corners");
                boxed(made)
            });
            return halves.into();
        }
        let size = DVec2::new(self.axes.length(right - left), self.axes.length(high - low));
        let turned = DVec2::new(size.y, size.x);
        // The corner, the normal, the direction of x there, and the size.
        let ways = [
            (places[0], normal, x, size),
            (places[2], normal, -x, size),
            (places[3], -normal, x, size),
            (places[1], -normal, -x, size),
            (places[1], normal, y, turned),
            (places[3], normal, -y, turned),
            (places[0], -normal, y, turned),
            (places[2], -normal, -y, turned),
        ];
        let known = if whole.is_some() { 8 } else { 4 };
        let (corner, normal, xdir, size) = random.pick(&ways[..known]);
        let made = Rectangle::new(corner, normal, xdir, size);
        vec![boxed(made.expect("a tile"))]
    }

    /// Welds the tiles, as loading a scene does, and sees to it that all seams were found.
    pub fn share(&mut self, tally: &mut Tally) {
        let welds = share(&mut self.surfaces);
        let lines = welds
            .iter()
            .filter(|weld| weld.what == SharedKind::Line)
            .count();
        let mut inner: Vec<_> = self
            .cuts
            .iter()
            .flat_map(|cuts| cuts[1..cuts.len() - 1].iter())
            .collect();
        inner.sort_unstable();
        inner.dedup();
        let seams = inner.len() + self.rows.len() - 2;
        if lines < seams {
            tally.wrong(|| format!("{lines} lines of {seams} were welded: {self:?}"));
        }
    }

    /// A place on a seam, and whether it is a corner.
    fn target(&self, random: &mut Random) -> [f64; 2] {
        let row = random.below(u32::try_from(self.cuts.len()).unwrap_or(1)) as usize;
        let cuts = &self.cuts[row];
        let cut = f64::from(cuts[1]);
        let [low, high] = [self.rows[row], self.rows[row + 1]].map(f64::from);
        // A seam between two rows, if there is one on this side of the row.
        let seam = if row == 0 { high } else { low };
        match random.below(4) {
            0 => [cut, seam],
            1 => {
                let width = f64::from(cuts[2]);
                [width * (0.01 + 0.98 * random.share()), seam]
            }
            _ => [cut, low + (high - low) * (0.02 + 0.96 * random.share())],
        }
    }

    /// A ray at a seam, or so little beside it that it still meets the floor.
    fn ray(&self, random: &mut Random) -> Ray<'static> {
        let [along_x, along_y, normal] = self.axes.given;
        let step = f64::from(self.axes.step);
        let unit_length = 0.1 * self.axes.scale;
        let [x, y] = self.target(random);
        let base = DVec3::from(self.axes.base.map(f64::from));
        let target = (base + along_x * x + along_y * y) * unit_length;
        let away = random.cube();
        let lift = if random.once_in(4) {
            random.power(-30, 0)
        } else {
            1.0
        };
        let height = (random.share() + 0.1) * if random.once_in(2) { lift } else { -lift };
        let flat = away - normal * (away.dot(normal) / normal.length_squared());
        let back = (flat + normal * height) * (100.0 * step * unit_length);
        let way = if random.once_in(32) {
            -back
        } else {
            let beside = 100.0 * step * unit_length * lift * random.power(-51, -14);
            -back + random.cube() * beside
        };
        let dir = unit(way).unwrap_or(DVec3::Z);
        let origin = match random.below(32) {
            0 => {
                // Exactly through the corner of a tile.
                let row =
                    1 + random.below(u32::try_from(self.rows.len() - 2).unwrap_or(1)) as usize;
                let corner = self.axes.place(self.cuts[row][1], self.rows[row]);
                Point {
                    anchor: corner,
                    offset: -dir * (unit_length * random.power(0, 8)),
                }
            }
            1..16 => Point {
                anchor: target,
                offset: back,
            },
            _ => Point::exact(target + back),
        };
        Ray::new(origin, dir)
    }

    /// Sends a ray at a seam; exactly one tile has to be there.
    pub fn ask(&self, random: &mut Random, tally: &mut Tally) {
        let ray = self.ray(random);
        let hits = |surface: &&Boxed| surface.hits(&ray, Span::AHEAD).is_some();
        let count = self.surfaces.iter().filter(hits).count();
        tally.cases += 1;
        match count {
            0 => tally.none += 1,
            1 => tally.positive += 1,
            _ => tally.several += 1,
        }
        if count != 1 {
            tally.wrong(|| format!("{count} tiles instead of one: {ray:?} and {self:?}"));
        }
    }
}
