//! Random scenes of a few hundred surfaces that touch, overlap and lie in one plane.

use crate::random::Random;
use crate::scenes::{Writer, triple};

/// The head of a scene, in units of this length and around this place.
fn head(unit: f64, place: f64, size: [u32; 2]) -> String {
    let at = |numbers: [f64; 3]| moved(numbers, unit, place);
    format!(
        r#"
        image {} {} cut-off=0.1
        lighting {{ falloff "none"; view-falloff "none" }}
        camera {{ viewpoint {}; look-at {}; field-of-view 50 }}
        light {{ location {}; emissivity 1 }}
        light {{ location {}; emissivity 1 0.5 0.25 }}
        material "chalk" {{ ambient 0.1; diffuse 0.5 }}
        material "red" {{ ambient 0.3 0.1 0.1; diffuse 0.5 0.1 0.1 }}
        material "pane" {{ ambient 0.1; diffuse 0.4 0.9 0.7; transparency 0.6 }}
        material "glass" {{ ambient 0; diffuse 1; transparency 1; ior 1.5 }}
        material "mirror" {{ ambient 0; diffuse 0.1; specular 0.7 }}
        "#,
        size[0],
        size[1],
        at([1.0, 2.0, 14.0]),
        at([0.0, 0.0, 0.0]),
        at([4.0, 9.0, 11.0]),
        at([0.5, 0.5, 0.5]),
    )
}

/// The numbers in units of a length and around a place.
fn moved(numbers: [f64; 3], unit: f64, place: f64) -> String {
    triple(numbers.map(|number| number * unit + place))
}

/// The text of a scene: a function of its number alone.
#[must_use]
pub fn scene(seed: u64) -> String {
    scene_of(20, seed)
}

/// The text of a scene of more surfaces, and two lamps.
#[must_use]
pub fn scene_with_lamps(seed: u64) -> String {
    scene_of(60, seed) + &lamps(seed, units(seed))
}

/// A rectangle and a ball that shine.
fn lamps(seed: u64, (unit, place): (f64, f64)) -> String {
    let mut random = Random::of(0x1a3b5, seed);
    let mut maker = Maker {
        text: Writer::default(),
        random: &mut random,
        unit,
        place,
    };
    let [pane, globe] = [0; 2].map(|_| moved(maker.point(5.0), unit, place));
    let [normal, xdir] = [[0.0, -1.0, 0.5], [1.0, 0.0, 0.0]].map(triple);
    let [width, height, radius] = [2.0, 1.0, 0.5].map(|length| length * unit);
    format!(
        r#"
        lamp {{ point {pane}; normal {normal}; xdir {xdir}; dimensions {width:?} {height:?}
            emissivity 3; samples 5 }}
        lamp {{ center {globe}; radius {radius:?}; emissivity 3; samples 5 }}
        "#
    )
}

/// The unit of length of a scene, and the place around which it lies.
fn units(seed: u64) -> (f64, f64) {
    match seed % 4 {
        0 => (2f64.powi(-100), 0.0),
        1 => (2f64.powi(100), 0.0),
        2 => (1.0, 1e9),
        _ => (1.0, 0.0),
    }
}

fn scene_of(groups: usize, seed: u64) -> String {
    let mut random = Random::of(0xacce1, seed);
    // All numbers are multiples of 1/64, so that far and scaled scenes are as exact as near ones.
    let (unit, place) = units(seed);
    let mut maker = Maker {
        text: Writer::new(&head(unit, place, [24, 18])),
        random: &mut random,
        unit,
        place,
    };
    for _ in 0..groups {
        maker.group();
    }
    maker.text.text()
}

/// So many small planes in a cube, each turned another way.
#[must_use]
pub fn many(count: usize) -> String {
    let mut random = Random::of(0xacce1, count as u64);
    let mut maker = Maker {
        text: Writer::new(&head(1.0, 0.0, [40, 30])),
        random: &mut random,
        unit: 1.0,
        place: 0.0,
    };
    for _ in 0..count {
        let [point, normal, xdir] = [4.0, 1.0, 1.0].map(|reach| maker.point(reach));
        maker.rectangle(point, normal, xdir, [0.25, 0.25]);
    }
    maker.text.text()
}

/// The same, with two lamps.
#[must_use]
pub fn many_with_lamps(count: usize) -> String {
    many(count) + &lamps(count as u64, (1.0, 0.0))
}

struct Maker<'r> {
    random: &'r mut Random,
    text: Writer,
    unit: f64,
    place: f64,
}

impl Maker<'_> {
    fn number(&mut self, reach: f64) -> f64 {
        (self.random.signed() * reach * 64.0).round() / 64.0
    }

    fn point(&mut self, reach: f64) -> [f64; 3] {
        std::array::from_fn(|_| self.number(reach))
    }

    /// The attribute that says what a surface is made of.
    fn material(&mut self) -> String {
        let names = ["chalk", "chalk", "red", "pane", "pane", "mirror"];
        format!("material \"{}\"", self.random.pick(&names))
    }

    /// A place of the scene, as the text has it.
    fn at(&self, numbers: [f64; 3]) -> String {
        moved(numbers, self.unit, self.place)
    }

    /// A few surfaces that have to do with each other.
    fn group(&mut self) {
        let corner = self.point(4.0);
        match self.random.below(6) {
            0 => self.tiles(corner),
            1 => {
                // In one place, or in one plane.
                let [normal, xdir] = [self.direction(), self.direction()];
                for _ in 0..4 {
                    let size = [1.0 + self.number(0.5), 1.5 + self.number(1.0)];
                    self.rectangle(corner, normal, xdir, size);
                }
            }
            2 => {
                // Along the axes, shifted along them.
                let axis = self.random.below(3) as usize;
                let mut normal = [0.0; 3];
                normal[axis] = 1.0;
                let mut xdir = [0.0; 3];
                xdir[(axis + 1) % 3] = 1.0;
                for step in 0..5 {
                    let mut corner = corner;
                    corner[axis] += f64::from(step) * 0.5;
                    self.rectangle(corner, normal, xdir, [1.0, 2.0]);
                }
            }
            3 => self.fan(corner),
            4 => {
                for _ in 0..3 {
                    self.ball(corner);
                }
            }
            _ => {
                for _ in 0..5 {
                    let [point, normal, xdir] =
                        [self.point(4.0), self.direction(), self.direction()];
                    self.rectangle(point, normal, xdir, [1.0, 0.5]);
                }
            }
        }
        if self.random.once_in(20) {
            let (material, at) = (self.material(), self.at([0.0, -4.0, 0.0]));
            self.text.plane(&material, at, "0 1 0");
        }
    }

    fn direction(&mut self) -> [f64; 3] {
        let [x, y, z] = self.point(1.0);
        [x, y, if z == 0.0 { 1.0 } else { z }]
    }

    fn rectangle(&mut self, point: [f64; 3], normal: [f64; 3], xdir: [f64; 3], size: [f64; 2]) {
        let material = self.material();
        let [[a, b, c], [d, e, f]] = [normal, xdir];
        let across = [b * f - c * e, c * d - a * f, a * e - b * d];
        // What is nearly parallel is refused.
        let square = |[x, y, z]: [f64; 3]| x * x + y * y + z * z;
        let xdir = if square(across) < 1e-3 * square(normal) * square(xdir) {
            if a.abs() > 0.5 * square(normal).sqrt() {
                [0.0, 1.0, 0.0]
            } else {
                [1.0, 0.0, 0.0]
            }
        } else {
            xdir
        };
        let (at, axes) = (self.at(point), [normal, xdir].map(triple));
        let size = size.map(|length| length * self.unit);
        self.text
            .rectangle("finite-plane", &material, at, axes, size);
    }

    /// A wall whose tiles share their borders.
    fn tiles(&mut self, corner: [f64; 3]) {
        for row in 0..4 {
            for column in 0..4 {
                let point = [
                    corner[0] + f64::from(column) * 0.5,
                    corner[1] + f64::from(row) * 0.5,
                    corner[2],
                ];
                self.rectangle(point, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.5, 0.5]);
            }
        }
    }

    /// Triangles around a point, which share their edges.
    fn fan(&mut self, top: [f64; 3]) {
        let rim: Vec<_> = (0..6)
            .map(|step| {
                let [x, y, z] = self.point(1.0);
                let turned = [
                    [2.0, 0.0],
                    [1.0, 2.0],
                    [-1.0, 2.0],
                    [-2.0, 0.0],
                    [-1.0, -2.0],
                    [1.0, -2.0],
                ];
                let [dx, dy] = turned[step];
                [
                    top[0] + dx + x / 4.0,
                    top[1] + dy + y / 4.0,
                    top[2] - 1.0 + z,
                ]
            })
            .collect();
        for step in 0..6 {
            let material = self.material();
            let corners = [top, rim[step], rim[(step + 1) % 6]];
            let corners = corners.map(|corner| self.at(corner));
            self.text.triangle(&material, corners);
        }
    }

    /// A sphere or an ellipsoid.
    fn ball(&mut self, center: [f64; 3]) {
        let glass = self.random.once_in(3);
        let material = if glass {
            "material \"glass\"".to_owned()
        } else {
            self.material()
        };
        let at = self.at(center);
        let radius = (0.75 + self.number(0.5)) * self.unit;
        if self.random.once_in(2) {
            self.text.sphere(&material, at, radius);
        } else {
            let scale = self.point(0.5).map(|number| number + 1.0);
            self.text.ellipsoid(&material, at, radius, triple(scale));
        }
    }
}
