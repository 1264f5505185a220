//! What must not change a picture with lamps.

use heliodon::plan::Scope;

use super::{bits, drawn, picture};

/// A sequence of numbers without pattern: a linear congruence (Knuth 1969, vol. 2, §3.3.4).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / 9_007_199_254_740_992.0
    }

    fn below(&mut self, end: usize) -> usize {
        self.next();
        usize::try_from(self.0 >> 33).expect("31 bits") % end
    }

    fn pick<'a>(&mut self, words: &[&'a str]) -> &'a str {
        words[self.below(words.len())]
    }

    /// Three numbers, often whole, so that things touch and lie in one plane.
    fn place(&mut self, reach: f64) -> String {
        let rounded = self.next() < 0.6;
        let numbers = [0; 3].map(|_| {
            let number = (self.next() * 2.0 - 1.0) * reach;
            if rounded {
                number.round()
            } else {
                (number * 64.0).round() / 64.0
            }
        });
        format!("{} {} {}", numbers[0], numbers[1], numbers[2])
    }

    /// A place that makes no line with two others of the above.
    fn corner(&mut self) -> String {
        let [x, y, z] = [0; 3].map(|_| 5.0 * self.next() + 0.03);
        format!("{x} {y} {z}")
    }

    fn axes(&mut self) -> &'static str {
        self.pick(&[
            "normal 0 1 0; xdir 1 0 0",
            "normal 0 -1 0; xdir 1 0 0",
            "normal 1 0 0; xdir 0 0 -1",
            "normal -1 0 0; xdir 0 1 0",
            "normal 0 0 1; xdir 1 0 0",
            "normal 1 2 0.5; xdir 1 0 0",
            "normal -1 -1 -1; xdir 0 1 0",
        ])
    }

    fn scene(&mut self) -> String {
        let camera = self.pick(&[
            "viewpoint 1 3 9; look-at 0 0 0",
            "viewpoint 0 2 12; screen 5 4",
        ]);
        let mut text = format!(
            "image 24 18\ncamera {{ {camera} }}\nmaterial \"chalk\" {{ diffuse 1 0.9 0.8 }}\n\
             material \"glass\" {{ diffuse 0.2 1 0.4; transparency 0.5 }}\n\
             material \"mirror\" {{ diffuse 0.5; specular 0.5 }}\n"
        );
        for _ in 0..1 + self.below(2) {
            let (place, axes) = (self.place(3.0), self.axes());
            text += &match self.pick(&["pane", "globe"]) {
                "pane" => format!(
                    "lamp {{ point {place}; {axes}; dimensions 2 1; emissivity 3; samples 8 }}\n"
                ),
                _ => format!("lamp {{ center {place}; radius 0.5; emissivity 3; samples 8 }}\n"),
            };
        }
        for _ in 0..2 + self.below(7) {
            let (place, axes) = (self.place(3.0), self.axes());
            let material = self.pick(&["chalk", "chalk", "glass", "mirror"]);
            let normal = axes.split_once(';').expect("two parts").0;
            text += &match self.pick(&[
                "plane",
                "rectangle",
                "rectangle",
                "sphere",
                "ellipsoid",
                "triangle",
            ]) {
                "plane" => {
                    format!("plane {{ material \"{material}\"; point {place}; {normal} }}\n")
                }
                "rectangle" => format!(
                    "finite-plane {{ material \"{material}\"; point {place}; {axes}; dimensions 3 2 }}\n"
                ),
                "sphere" => {
                    format!("sphere {{ material \"{material}\"; center {place}; radius 1 }}\n")
                }
                "ellipsoid" => format!(
                    "ellipsoid {{ material \"{material}\"; center {place}; radius 1; scale 1 0.5 2 }}\n"
                ),
                _ => format!(
                    "triangle {{ material \"{material}\"; vertex1 {place}; vertex2 {}; vertex3 {} }}\n",
                    self.place(4.0),
                    self.corner(),
                ),
            };
        }
        text
    }
}

#[test]
fn what_is_left_out_changes_no_bit() {
    let mut random = Random(2026);
    let (mut few, mut many) = (0, 0);
    for index in 0..150 {
        let scene = random.scene();
        let (planned, counts) = picture(&scene, Scope::CalledFor);
        let (all, all_counts) = picture(&scene, Scope::Everything);
        (few, many) = (few + counts.lamp_rays, many + all_counts.lamp_rays);
        assert!(
            bits(&planned) == bits(&all),
            "scene {index} differs:\n{scene}"
        );
    }
    assert!(
        few > 0 && 3 * few < 2 * many,
        "{few} of {many} rays are left"
    );
}

/// A scene of numbers that are sums of few powers of two, moved and scaled.
fn moved_and_scaled(by: f64, scale: f64) -> String {
    let at = |x: f64, y: f64, z: f64| {
        let numbers = [x, y, z].map(|number| format!("{:?}", (number + by) * scale));
        numbers.join(" ")
    };
    let length = |length: f64| format!("{:?}", length * scale);
    format!(
        "image 40 30\ncamera {{ viewpoint {}; look-at {} }}\nmaterial \"chalk\" {{ diffuse 1 }}\n\
         lamp {{ point {}; normal 0 -1 0; xdir 1 0 0; dimensions {} {}; emissivity 3; samples 16 }}\n\
         lamp {{ center {}; radius {}; emissivity 2 1 4; samples 16 }}\n\
         plane {{ material \"chalk\"; point {}; normal 0 1 0 }}\n\
         finite-plane {{ material \"chalk\"; point {}; normal 1 0 0; xdir 0 0 -1; dimensions {} {} }}\n\
         sphere {{ material \"chalk\"; center {}; radius {} }}",
        at(0.0, 2.0, 5.0),
        at(0.0, 0.5, 0.0),
        at(-1.0, 3.0, -1.0),
        length(2.0),
        length(1.5),
        at(1.5, 0.5, 1.5),
        length(0.25),
        at(0.0, 0.0, 0.0),
        at(-1.5, 0.0, 1.0),
        length(2.0),
        length(1.0),
        at(0.0, 0.75, 0.0),
        length(0.75),
    )
}

#[test]
fn scaling_and_moving_change_no_bit() {
    let (here, counts) = drawn(&moved_and_scaled(0.0, 1.0));
    assert!(counts.lamp_rays > 1000);
    for power in [-100, -3, 7, 100] {
        let (there, _) = drawn(&moved_and_scaled(0.0, 2f64.powi(power)));
        assert!(bits(&here) == bits(&there), "scaled by 2^{power}");
    }
    let (far, _) = drawn(&moved_and_scaled(1e9, 1.0));
    assert!(bits(&here) == bits(&far), "moved by 1e9");
}

#[test]
fn threads_change_no_bit() {
    let scene = moved_and_scaled(0.0, 1.0);
    let [one, three] = [1, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("threads");
        bits(&pool.install(|| drawn(&scene)).0)
    });
    assert!(one == three);
}

/// What is mirrored looks mirrored: exactly where the whole lamp is seen, and as well as 64 places of
/// it can say elsewhere.
#[test]
fn a_symmetric_scene_looks_symmetric() {
    let scene = "image 48 36\ncamera { viewpoint 0 2 5; look-at 0 0.5 0 }\nmaterial \"chalk\" { diffuse 1 }\n\
        lamp { point -1 3 -1; normal 0 -1 0; xdir 1 0 0; dimensions 2 2; emissivity 3 }\n\
        plane { material \"chalk\"; point 0 0 0; normal 0 1 0 }\n\
        sphere { material \"chalk\"; center 0 0.75 0; radius 0.5 }";
    let film = drawn(scene).0;
    let mut exact = 0;
    for (x, y) in (0..24).flat_map(|x| (0..36).map(move |y| (x, y))) {
        let [left, right] = [x, 47 - x].map(|x| film.pixel(x, y).r);
        let off = (left - right).abs();
        assert!(off <= 0.05, "{x} {y}: {left} {right}");
        exact += usize::from(off <= 1e-12 * left);
    }
    assert!(
        exact > 400,
        "only {exact} are as bright as their mirror images"
    );
}
