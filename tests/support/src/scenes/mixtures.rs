//! Random scenes that mix everything that the scene language has.
//!
//! Numbers are mostly of one digit behind the point, so that surfaces meet at edges and corners, and lights
//! lie in planes; and a quarter of the scenes has numbers of all digits.

use crate::random::Random;
use crate::scenes::{Writer, triple};

/// The text of a scene: a function of its number alone.
#[must_use]
pub fn scene(seed: u64) -> String {
    let mut random = Random::of(0x005c_e7e5, seed);
    let digits = !random.once_in(4);
    let mut maker = Maker {
        random,
        digits,
        text: Writer::default(),
    };
    maker.head();
    maker.materials();
    maker.lights();
    maker.lamp();
    let surfaces = 3 + maker.random.below(5);
    for _ in 0..surfaces {
        maker.surface();
    }
    maker.text.text()
}

const NAMES: [&str; 11] = [
    "chalk", "silver", "mirror", "pane", "gloss", "glow", "black", "tinted", "glass", "varnish",
    "air",
];

struct Maker {
    random: Random,
    /// Whether numbers have one digit behind the point only.
    digits: bool,
    text: Writer,
}

impl Maker {
    /// A number between these two.
    fn number(&mut self, low: f64, high: f64) -> f64 {
        let number = low + (high - low) * self.random.share();
        if self.digits {
            (number * 10.0).round() / 10.0
        } else {
            number
        }
    }

    /// A number above zero and not above this one.
    fn size(&mut self, high: f64) -> f64 {
        self.number(0.1, high).max(0.1)
    }

    fn point(&mut self, reach: f64) -> String {
        triple([(); 3].map(|()| self.number(-reach, reach)))
    }

    fn head(&mut self) {
        let samples = self.random.pick(&["", "", " samples=2", " max-error=0.02"]);
        let cut_off = self
            .random
            .pick(&["", "", " cut-off=0.05", " cut-off=0.00001"]);
        let filter = self.random.pick(&[
            "",
            " texture-filter=\"exact\"",
            " texture-filter=\"mipmap\"",
            " texture-filter=\"anisotropic\"",
        ]);
        self.text
            .line(format!("image 20 15{samples}{cut_off}{filter}"));
        if self.random.once_in(3) {
            let [x, y] = [(); 2].map(|()| self.number(0.0, 4.0));
            let z = self.size(6.0);
            self.text
                .line(format!("camera {{ viewpoint {x} {y} {z}; screen 4 3 }}"));
        } else {
            let [eye, target] = [3.0, 0.5].map(|reach| self.point(reach));
            let angle = self.number(40.0, 110.0);
            self.text.line(format!(
                "camera {{ viewpoint {eye}; look-at {target}; up 0.31 1 0.17; field-of-view {angle} }}"
            ));
        }
        if self.random.once_in(3) {
            let words = ["none", "inverse", "inverse-square"];
            let (fall, view) = (self.random.pick(&words), self.random.pick(&words));
            let reach = if self.random.once_in(4) {
                "; reach 6"
            } else {
                ""
            };
            self.text.line(format!(
                "lighting {{ falloff \"{fall}\"; view-falloff \"{view}\"{reach} }}"
            ));
        }
    }

    fn materials(&mut self) {
        self.text.line(
            r#"texture "arrow" "textures/arrow-8x8.png"
material "chalk" { ambient 0.2 0.3 0.4; diffuse 3 4 5 }
material "silver" { ambient 0.1; diffuse 1; specular 0.6 0.7 0.5 }
material "mirror" { ambient 0.05; specular 0.9 }
material "pane" { ambient 0.1; diffuse 1 2 1; transparency 0.7 }
material "gloss" { diffuse 3 1 1; specular 0.3; shininess 12 }
material "glow" { ambient 1 0.8 0.3 }
material "black" { specular 0; shininess 5; diffuse 0 }
material "tinted" { diffuse 0 3 1; transparency 0.5; specular 0.4; shininess 3 }
material "glass" { ambient 0.1; diffuse 2 3 3; transparency 0.9; specular 0.3; shininess 9; ior 1.5 }
material "varnish" { ambient 0.1; diffuse 2 1 1; ior 1.4 }
material "air" { diffuse 1; transparency 1; ior 1 }"#,
        );
    }

    fn lights(&mut self) {
        for _ in 0..1 + self.random.below(3) {
            let location = self.point(5.0);
            let emissivity = self.random.pick(&["3", "6 5 4", "2 0 1", "0"]);
            let head = format!("location {location}; emissivity {emissivity}");
            let target = self.point(1.0);
            match self.random.below(5) {
                0 if location != target => {
                    let theta = self.number(5.0, 80.0);
                    self.text.line(format!(
                        "spotlight {{ {head}; point {target}; theta {theta} }}"
                    ));
                }
                1 => {
                    let (normal, xdir) = self.axes();
                    let (width, height) = (self.size(2.0), self.size(2.0));
                    self.text.line(format!(
                        "projector {{ {head}; point {target}; normal {normal}; xdir {xdir}; \
                         dimensions {width} {height}; texture \"arrow\" }}"
                    ));
                }
                _ => self.text.line(format!("light {{ {head} }}")),
            }
        }
    }

    /// A lamp that glows, now and then.
    fn lamp(&mut self) {
        if !self.random.once_in(3) {
            return;
        }
        let (place, emissivity) = (self.point(3.0), self.random.pick(&["2", "9 5 4"]));
        let shape = if self.random.once_in(3) {
            format!("center {place}; radius {}", self.size(1.0))
        } else {
            let (normal, xdir) = self.axes();
            let (width, height) = (self.size(2.0), self.size(2.0));
            format!("point {place}; normal {normal}; xdir {xdir}; dimensions {width} {height}")
        };
        self.text.line(format!(
            "lamp {{ {shape}; emissivity {emissivity}; samples 5 }}"
        ));
    }

    /// A normal and a direction of x at right angles to it.
    fn axes(&mut self) -> (&'static str, &'static str) {
        let sorts = [
            ("0 1 0", "1 0 0"),
            ("0 1 0", "0 0 1"),
            ("0 0 1", "1 0 0"),
            ("0 0 1", "0 -1 0"),
            ("1 0 0", "0 0 -1"),
            ("-1 0 0", "0 0 1"),
            ("0 0 -1", "-1 0 0"),
            ("0 -1 0", "1 0 0"),
            ("1 1 0", "1 -1 0"),
            ("1 2 2", "2 1 -2"),
            ("-0.3 0.9 0.1", "3 1 0"),
        ];
        let most = if self.random.once_in(3) {
            sorts.len()
        } else {
            8
        };
        self.random.pick(&sorts[..most])
    }

    fn surface(&mut self) {
        match self.random.below(10) {
            0 => self.plane(),
            1 => self.round(),
            2 => self.triangle(),
            3 => self.boxed(),
            4 => self.corner(),
            _ => self.rectangle(),
        }
    }

    /// The attributes of every surface.
    fn common(&mut self) -> String {
        let mut text = format!("material \"{}\"", self.random.pick(&NAMES));
        match self.random.below(12) {
            0 => text += "; shadows receive=#false",
            1 => text += "; shadows cast=#false",
            _ => {}
        }
        text
    }

    fn plane(&mut self) {
        let (common, point, (normal, xdir)) = (self.common(), self.point(3.0), self.axes());
        let head = format!("{common}; point {point}; normal {normal}");
        match self.random.below(3) {
            0 => {
                let tile = self.size(2.0);
                let other = self.random.pick(&NAMES);
                self.text.line(format!(
                    "tiled-plane {{ {head}; xdir {xdir}; dimensions {tile} {tile}; alternate \"{other}\" }}"
                ));
            }
            1 => self
                .text
                .line(format!("procedural-plane {{ {head}; shader \"stripes\" }}")),
            _ => self.text.plane(&common, point, normal),
        }
    }

    fn rectangle(&mut self) {
        let (common, point, (normal, xdir)) = (self.common(), self.point(2.0), self.axes());
        let (width, height) = (self.size(5.0), self.size(5.0));
        let (word, image) = match self.random.below(3) {
            0 => ("texture-plane", "; texture \"arrow\""),
            1 => (
                "texture-plane",
                "; texture \"arrow\" mode=\"repeat\" texel=0.1",
            ),
            _ => ("finite-plane", ""),
        };
        let (common, axes) = (common + image, [normal, xdir]);
        self.text
            .rectangle(word, &common, point, axes, [width, height]);
    }

    fn round(&mut self) {
        let (common, center) = (self.common(), self.point(2.0));
        let texture = self.random.pick(&["", "", "; texture \"arrow\""]);
        let common = common + texture;
        let [a, b, c] = [(); 3].map(|()| self.size(1.5));
        if self.random.once_in(3) {
            self.text.ellipsoid(&common, center, a, triple([1.0, b, c]));
        } else {
            self.text.sphere(&common, center, a);
        }
    }

    fn triangle(&mut self) {
        let [x, y, z] = [(); 3].map(|()| self.number(-2.0, 2.0));
        let (width, height, lean) = (self.size(3.0), self.size(3.0), self.number(-1.0, 1.0));
        let common = self.common();
        let vertices = [[x, y, z], [x + width, y, z], [x, y + height, z + lean]];
        self.text.triangle(&common, vertices.map(triple));
    }

    /// Five sides of a box that meet at its edges, seen from outside or from inside.
    fn boxed(&mut self) {
        let [x, y, z] = [(); 3].map(|()| self.number(-2.0, 1.0));
        let [w, h, d] = [(); 3].map(|()| self.size(3.0));
        let (x1, y1, z1) = (x + w, y + h, z + d);
        let inside = self.random.once_in(2);
        let common = self.common();
        let sides = [
            ([x, y, z1], [0, 0, 1], [1, 0, 0], w, h),
            ([x1, y, z1], [1, 0, 0], [0, 0, -1], d, h),
            ([x1, y, z], [0, 0, -1], [-1, 0, 0], w, h),
            ([x, y, z], [-1, 0, 0], [0, 0, 1], d, h),
            ([x, y1, z1], [0, 1, 0], [1, 0, 0], w, d),
        ];
        for (mut corner, mut normal, mut xdir, width, height) in sides {
            if inside {
                // From the other end of x, x runs back and y as before.
                for (place, along) in corner.iter_mut().zip(xdir) {
                    *place += width * f64::from(along);
                }
                normal = normal.map(|along: i32| -along);
                xdir = xdir.map(|along: i32| -along);
            }
            self.finite_plane(&common, corner, normal, xdir, [width, height]);
        }
    }

    fn finite_plane(
        &mut self,
        common: &str,
        corner: [f64; 3],
        normal: [i32; 3],
        xdir: [i32; 3],
        size: [f64; 2],
    ) {
        let axes = [normal, xdir].map(|way| triple(way.map(f64::from)));
        self.text
            .rectangle("finite-plane", common, triple(corner), axes, size);
    }

    /// Floor and two walls that meet in a corner, of tiles.
    fn corner(&mut self) {
        let [x, y, z] = [(); 3].map(|()| self.number(-2.0, 0.0));
        let tile = self.size(1.5);
        let common = self.common();
        for (normal, xdir, up) in [
            ([0, 1, 0], [0, 0, 1], [1, 0, 0]),
            ([1, 0, 0], [0, 1, 0], [0, 0, 1]),
            ([0, 0, 1], [1, 0, 0], [0, 1, 0]),
        ] {
            for (i, j) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                let steps = [0, 1, 2].map(|axis| f64::from(i * xdir[axis] + j * up[axis]));
                let corner = [
                    x + tile * steps[0],
                    y + tile * steps[1],
                    z + tile * steps[2],
                ];
                self.finite_plane(&common, corner, normal, xdir, [tile, tile]);
            }
        }
    }
}
