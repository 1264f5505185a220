//! A wall of tiles is the wall.
//!
//! Each tile is a finite plane of its own, its corner written as a decimal. The decimals meet exactly
//! and their doubles do not: 0.1 + 0.2 is not 0.3. So every joint is a gap or an overlap of one part in
//! 10^16, and no ray may fall through it.

use std::fmt::Write;

use super::subject::{Subject, difference_beyond_rounding, fail_on};

/// The numbers of tiles along x and y.
const TILES: [i64; 2] = [7, 13];

/// A wall, its lengths in millionths.
struct Wall {
    name: &'static str,
    corner: [i64; 3],
    /// From a tile to the next along x and y.
    steps: [[i64; 3]; 2],
    /// The side of a tile.
    side: i64,
    /// Words for the directions: any multiples.
    normal: &'static str,
    xdir: &'static str,
}

/// Axis-aligned walls of 0.7 by 1.3, and one of 2.1 by 3.9 along (2, 1, 2) / 3 and (−2, 2, 1) / 3.
const WALLS: [Wall; 5] = [
    Wall {
        name: "a wall at the origin",
        corner: [0; 3],
        steps: [[100_000, 0, 0], [0, 100_000, 0]],
        side: 100_000,
        normal: "0 0 1",
        xdir: "1 0 0",
    },
    Wall {
        name: "a wall with an odd corner",
        corner: [-1_234_567, 303_030, -3_141_593],
        steps: [[100_000, 0, 0], [0, 100_000, 0]],
        side: 100_000,
        normal: "0 0 1",
        xdir: "1 0 0",
    },
    Wall {
        name: "a wall along z",
        corner: [-700_001, -99_999, -2_000_003],
        steps: [[0, 0, -100_000], [0, 100_000, 0]],
        side: 100_000,
        normal: "1 0 0",
        xdir: "0 0 -1",
    },
    Wall {
        name: "a floor",
        corner: [-333_333, -777_777, -999_999],
        steps: [[100_000, 0, 0], [0, 0, -100_000]],
        side: 100_000,
        normal: "0 3 0",
        xdir: "7 0 0",
    },
    Wall {
        name: "a slanting wall",
        corner: [-123_457, -1_000_001, -4_200_000],
        steps: [[200_000, 100_000, 200_000], [-200_000, 200_000, 100_000]],
        side: 300_000,
        normal: "-1 -2 2",
        xdir: "2 1 2",
    },
];

/// Millionths as a decimal.
fn decimal(millionths: i64) -> String {
    let sign = if millionths < 0 { "-" } else { "" };
    let (whole, rest) = (millionths.abs() / 1_000_000, millionths.abs() % 1_000_000);
    format!("{sign}{whole}.{rest:06}")
}

fn decimals(millionths: [i64; 3]) -> String {
    millionths.map(decimal).join(" ")
}

impl Wall {
    /// The point after so many half tiles along x and y.
    fn point(&self, halves: [i64; 2]) -> [i64; 3] {
        let [x, y] = self.steps;
        [0, 1, 2].map(|axis| self.corner[axis] + (x[axis] * halves[0] + y[axis] * halves[1]) / 2)
    }

    /// The normal, as long as a tile is wide.
    fn across(&self) -> [i64; 3] {
        let [x, y] = self.steps;
        let cross = |a: usize, b: usize| (x[a] * y[b] - x[b] * y[a]) / self.side;
        [cross(1, 2), cross(2, 0), cross(0, 1)]
    }

    /// A part of the wall as a finite plane: the corner and the size in tiles.
    fn part(&self, at: [i64; 2], size: [i64; 2]) -> String {
        let corner = decimals(self.point(at.map(|tiles| 2 * tiles)));
        let [width, height] = size.map(|tiles| decimal(self.side * tiles));
        let Self { normal, xdir, .. } = self;
        format!(
            "finite-plane {{ material \"wall\"; point {corner}; normal {normal}; xdir {xdir}; \
             dimensions {width} {height} }}\n"
        )
    }

    fn whole(&self) -> String {
        self.part([0, 0], TILES)
    }

    fn tiled(&self) -> String {
        let places = (0..TILES[1]).flat_map(|row| (0..TILES[0]).map(move |column| [column, row]));
        places.map(|place| self.part(place, [1, 1])).collect()
    }

    /// Cameras before the wall; the first ones look exactly at joints.
    fn cameras(&self) -> Vec<String> {
        let mut cameras = Vec::new();
        let [width, height] = TILES;
        let lies_in_a_screen = self.steps.iter().all(|step| step[2] == 0);
        if lies_in_a_screen {
            // The window is the wall: with as many pixels as joints, with two for each tile, and one
            // tile larger on each side.
            let [w, h] = TILES.map(|tiles| decimal(self.side * tiles));
            let at = decimals(self.corner);
            let from = self.point([3, 5]);
            let eye = decimals([from[0], from[1], from[2] + 1_000_000]);
            for (columns, rows) in [(width + 1, height + 1), (2 * width + 1, 2 * height + 1)] {
                cameras.push(format!(
                    "image {columns} {rows}
                    camera {{ viewpoint {eye}; screen {w} {h}; screen-at {at} }}"
                ));
            }
            let [w, h] = TILES.map(|tiles| decimal(self.side * (tiles + 2)));
            let at = decimals(self.point([-2, -2]));
            let (columns, rows) = (4 * (width + 2) + 1, 4 * (height + 2) + 1);
            cameras.push(format!(
                "image {columns} {rows}
                camera {{ viewpoint {eye}; screen {w} {h}; screen-at {at} }}"
            ));
        }
        // Straight at a crossing of joints, at a joint, at the middle of a tile, and at a crossing
        // again; from an eye that is so many tiles away along the normal.
        let normal = self.across();
        for (halves, far) in [([6, 12], 10), ([6, 13], 10), ([7, 13], 10), ([2, 4], 3)] {
            let target = self.point(halves);
            let eye = [0, 1, 2].map(|axis| target[axis] + normal[axis] * far);
            let up = self.steps[1].map(decimal).join(" ");
            let (target, eye) = (decimals(target), decimals(eye));
            cameras.push(format!(
                "image 41 41
                camera {{ viewpoint {eye}; look-at {target}; up {up}; field-of-view 70 }}"
            ));
        }
        // Along the joints, slanting.
        for (aim, from) in [([8, 10], [-9, 3]), ([5, 20], [22, -4])] {
            let (target, aside) = (self.point(aim), self.point(from));
            let eye = [0, 1, 2].map(|axis| aside[axis] + normal[axis] * 2);
            let up = self.steps[1].map(decimal).join(" ");
            let (target, eye) = (decimals(target), decimals(eye));
            cameras.push(format!(
                "image 48 36
                camera {{ viewpoint {eye}; look-at {target}; up {up}; field-of-view 80 }}"
            ));
        }
        cameras
    }

    /// A bright plane behind the wall, which shines through any gap and receives its shadow, a
    /// mirror beside it and a light before it.
    fn surroundings(&self) -> String {
        let normal = self.across();
        let shift = |from: [i64; 3], tiles: i64| {
            decimals([0, 1, 2].map(|axis| from[axis] + normal[axis] * tiles))
        };
        let (back, light) = (shift(self.corner, -5), shift(self.point([5, 9]), 12));
        let (mirror, facing) = (
            shift(self.point([-6, 0]), 0),
            self.steps[0].map(decimal).join(" "),
        );
        let Self { normal, .. } = self;
        format!(
            "lighting {{ view-falloff none }}
            material \"back\" {{ ambient 0.3 0 0.3; diffuse 0.4 }}
            material \"mirror\" {{ specular 0.8 }}
            plane {{ material \"back\"; point {back}; normal {normal} }}
            plane {{ material \"mirror\"; point {mirror}; normal {facing} }}
            light {{ location {light}; emissivity 1 }}\n"
        )
    }
}

/// Compares each wall of tiles with the wall, for a material.
fn complaints(material: &str) -> Vec<String> {
    let mut complaints = Vec::new();
    for wall in &WALLS {
        let surroundings = wall.surroundings();
        for (number, camera) in wall.cameras().iter().enumerate() {
            let picture = |parts: &str| {
                let mut text = String::new();
                let _ = writeln!(text, "{camera}\nmaterial \"wall\" {{ {material} }}");
                let _ = writeln!(text, "{parts}\n{surroundings}");
                Subject::new(wall.name, &text).film()
            };
            let title = format!("{}, camera {number}", wall.name);
            let (whole, tiled) = (picture(&wall.whole()), picture(&wall.tiled()));
            complaints.extend(difference_beyond_rounding(&title, &whole, &tiled));
        }
    }
    complaints
}

#[test]
fn a_wall_of_tiles_is_the_wall() {
    fail_on(complaints("ambient 0.1 0.2 0.3; diffuse 0.3"));
}

#[test]
fn a_mirror_of_tiles_is_the_mirror() {
    fail_on(complaints("ambient 0.1; specular 0.7; diffuse 0.3"));
}

#[test]
fn a_pane_of_tiles_is_the_pane() {
    fail_on(complaints(
        "ambient 0.1; diffuse 0.1 0.2 0.3; transparency 0.5",
    ));
}
