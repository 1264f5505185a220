//! What scenes of very many finite planes cost: to load, to check, and to render, with a tree and with
//! a list.
//!
//! `cargo bench --bench many_planes [-- COUNT …]` makes scenes of so many finite planes (1000, 10,000
//! and 100,000 if none is named) and prints a table of times on one thread. A list is only
//! rendered up to [`LONGEST_LIST`] planes. The last line tells by what factor the time of a render grows
//! when the number of planes grows tenfold.

use std::error::Error;
use std::time::Instant;

use heliodon::plan::{Plan, Scope};
use heliodon::read::{Options, read_bytes};
use heliodon::render::{Counts, Render};
use heliodon::visibility::{Accelerator, SurfaceList};
use heliodon::{measure, scene::Scene};
use support::random::Random;
use support::scenes::Writer;

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
    let plan = Plan::with(scene, Scope::CalledFor, accelerator);
    let plan = plan.map_err(|error| error.reason)?;
    let (made, seconds) = timed(|| Render::new(scene).planned::<Counts>(&plan));
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

/// Writes a square, its numbers rounded to four places.
fn plane(text: &mut Writer, point: [f64; 3], normal: [f64; 3], xdir: [f64; 3], size: f64) {
    let [point, normal, xdir] =
        [point, normal, xdir].map(|[x, y, z]| format!("{x:.4} {y:.4} {z:.4}"));
    let size = (size * 1e4).round() / 1e4;
    let axes = [normal, xdir];
    text.rectangle("finite-plane", "material \"m\"", point, axes, [size, size]);
}

fn vector(random: &mut Random, reach: f64) -> [f64; 3] {
    (random.cube() * reach).to_array()
}

/// Planes anywhere in a cube, so small that a ray meets about as many among more of them.
fn any(count: usize) -> String {
    let mut text = Writer::new(HEAD);
    let mut random = Random::from_state(count as u64);
    for _ in 0..count {
        let [point, normal, xdir] = [10.0, 1.0, 1.0].map(|reach| vector(&mut random, reach));
        plane(&mut text, point, normal, xdir, 10.0 / (count as f64).cbrt());
    }
    text.text()
}

/// One wall of tiles.
fn tiles(count: usize) -> String {
    let mut text = Writer::new(HEAD);
    let columns = (count as f64).sqrt().ceil();
    for index in 0..count {
        let [x, y] = [index as f64 % columns, (index as f64 / columns).floor()];
        let point = [x / 10.0, y / 10.0, 0.0];
        plane(&mut text, point, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], 0.1);
    }
    text.text()
}

/// Planes in one plane, each turned another way.
fn turned(count: usize) -> String {
    let mut text = Writer::new(HEAD);
    let mut random = Random::from_state(count as u64);
    let columns = (count as f64).sqrt().ceil();
    for index in 0..count {
        let [x, y] = [index as f64 % columns, (index as f64 / columns).floor()];
        let [a, b, _] = vector(&mut random, 1.0);
        plane(&mut text, [x, y, 0.0], [0.0, 0.0, 1.0], [a, b, 0.0], 0.3);
    }
    text.text()
}
