//! What scenes of very many finite planes cost: to load, to check, and to render, with a tree and with
//! a list.
//!
//! `cargo bench --bench many_planes [-- COUNT …]` makes scenes of so many finite planes (1000, 10,000
//! and 100,000 if none is named) and prints a table of times on one thread. A list is only
//! rendered up to [`LONGEST_LIST`] planes. The last line tells by what factor the time of a render grows
//! when the number of planes grows tenfold.

use std::error::Error;
use std::fmt::Write;
use std::time::Instant;

use heliodon::accel::{Accelerator, SurfaceList};
use heliodon::plan::{Plan, Scope};
use heliodon::read::{Options, read_bytes};
use heliodon::render::{Counts, drawn};
use heliodon::{measure, scene::Scene};

const LONGEST_LIST: usize = 10_000;

/// Makes a scene of so many planes.
type Maker = fn(usize) -> String;

/// How planes may lie.
const KINDS: [(&str, Maker); 3] = [("any way", any), ("tiles", tiles), ("turned", turned)];

fn main() -> Result<(), Box<dyn Error>> {
    // Cargo adds `--bench`.
    let counts: Vec<usize> = std::env::args()
        .filter_map(|argument| argument.parse().ok())
        .collect();
    let counts = if counts.is_empty() {
        vec![1000, 10_000, 100_000]
    } else {
        counts
    };
    rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build_global()?;
    println!(
        "| planes | lie | read | check | tree built | rendered, tree | list | tests per ray, tree | list |"
    );
    println!("|---:|---|---:|---:|---:|---:|---:|---:|---:|");
    for (kind, make) in KINDS {
        for count in &counts {
            let text = make(*count);
            let (scene, read) = timed(|| load(text));
            let (_, check) = timed(|| measure::check(&scene));
            let (_, built) = timed(|| SurfaceList::with(&scene.surfaces, Accelerator::Tree));
            let (tree, tree_tests) = rendered(&scene, Accelerator::Tree)?;
            let list = if *count <= LONGEST_LIST {
                let (list, tests) = rendered(&scene, Accelerator::List)?;
                [format!("{list:.3} s"), format!("{tests:.1}")]
            } else {
                ["".to_owned(), "".to_owned()]
            };
            let [list, list_tests] = list;
            println!(
                "| {count} | {kind} | {read:.3} s | {check:.3} s | {built:.3} s | {tree:.3} s | {list} | {tree_tests:.1} | {list_tests} |"
            );
        }
    }
    Ok(())
}

fn timed<T>(what: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let made = what();
    (made, start.elapsed().as_secs_f64())
}

fn load(text: String) -> Scene {
    let reading = read_bytes("planes.kdl", text.into(), "".into(), &Options::default());
    reading
        .unwrap_or_else(|no| panic!("{:?}", no.diagnostics))
        .scene
}

/// The seconds that a picture takes, and how many surfaces are asked for each ray.
fn rendered(scene: &Scene, accelerator: Accelerator) -> Result<(f64, f64), Box<dyn Error>> {
    let plan = Plan::with(scene, None, Scope::CalledFor, accelerator);
    let plan = plan.map_err(|error| error.reason)?;
    let (made, seconds) = timed(|| drawn::<Counts>(&plan, &|_| ()));
    let (_, counts) = made.map_err(|error| error.reason)?;
    let tests = counts.hit_tests + counts.occlusion_tests;
    Ok((seconds, tests as f64 / counts.rays() as f64))
}

const HEAD: &str = "
image 160 120
camera { viewpoint 0 0 30; look-at 0 0 0; field-of-view 40 }
material \"m\" { ambient 0.2; diffuse 5 }
light { location 10 20 30; emissivity 5 }
";

fn plane(text: &mut String, point: [f64; 3], normal: [f64; 3], xdir: [f64; 3], size: f64) {
    let [point, normal, xdir] =
        [point, normal, xdir].map(|[x, y, z]| format!("{x:.4} {y:.4} {z:.4}"));
    let _ = writeln!(
        text,
        "finite-plane {{ material \"m\"; point {point}; normal {normal}; xdir {xdir}; dimensions {size:.4} {size:.4} }}"
    );
}

/// Planes anywhere in a cube, so small that a ray meets about as many among more of them.
fn any(count: usize) -> String {
    let mut text = HEAD.to_owned();
    let mut random = Random(count as u64);
    for _ in 0..count {
        let [point, normal, xdir] = [10.0, 1.0, 1.0].map(|reach| random.vector(reach));
        plane(&mut text, point, normal, xdir, 10.0 / (count as f64).cbrt());
    }
    text
}

/// One wall of tiles.
fn tiles(count: usize) -> String {
    let mut text = HEAD.to_owned();
    let columns = (count as f64).sqrt().ceil();
    for index in 0..count {
        let [x, y] = [index as f64 % columns, (index as f64 / columns).floor()];
        let point = [x / 10.0, y / 10.0, 0.0];
        plane(&mut text, point, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], 0.1);
    }
    text
}

/// Planes in one plane, each turned another way.
fn turned(count: usize) -> String {
    let mut text = HEAD.to_owned();
    let mut random = Random(count as u64);
    let columns = (count as f64).sqrt().ceil();
    for index in 0..count {
        let [x, y] = [index as f64 % columns, (index as f64 / columns).floor()];
        let [a, b, _] = random.vector(1.0);
        plane(&mut text, [x, y, 0.0], [0.0, 0.0, 1.0], [a, b, 0.0], 0.3);
    }
    text
}

/// Random numbers (Steele, Lea and Flood 2014, "Fast Splittable Pseudorandom Number Generators").
struct Random(u64);

impl Random {
    fn vector(&mut self, reach: f64) -> [f64; 3] {
        std::array::from_fn(|_| {
            self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mixed = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
            let share = ((mixed ^ mixed >> 31) >> 11) as f64 / (1u64 << 53) as f64;
            reach * (2.0 * share - 1.0)
        })
    }
}
