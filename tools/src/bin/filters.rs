//! How right the texture filter `exact` is on floors to the horizon, and what it costs.
//!
//! ```sh
//! cargo run --release --bin filters
//! ```
//!
//! For each floor it prints the largest error of a channel, in code values of 255, against the mean of
//! 65,536 rays in the pattern `sobol`, over all pixels of a small picture whose middle shows the floor; the
//! same over those that do not show the horizon's neighbourhood, where each ray is as good as random
//! and the mean of so many is off itself; and how many times the processor's time of `exact` with one ray
//! a pixel `nearest` takes with 1,024, on a larger picture.

use clap::Parser;
use cpu_time::ProcessTime;
use heliodon::film::{Film, Region};
use heliodon::render::{Counts, Render, STACK};
use support::floors::{
    self, HORIZON, LEVEL, Painter, TURNED, checker, folder, head, noise, scene, squares,
};

/// Compares the filter `exact` with very many rays.
#[derive(Debug, Parser)]
struct Arguments {
    /// The rays through each pixel of the reference.
    #[arg(long, default_value_t = 65_536)]
    reference: u32,
    /// The rays through each pixel beside which `exact` is timed.
    #[arg(long, default_value_t = 1024)]
    beside: u32,
}

/// A floor, and how it is looked at.
struct Floor {
    name: &'static str,
    camera: &'static str,
    /// The size of a texel in the world.
    texel: f64,
    sides: [u32; 2],
    painter: Painter,
}

const FLOORS: [Floor; 4] = [
    Floor {
        name: "squares of one texel, level",
        camera: LEVEL,
        texel: 1.0,
        sides: [2, 2],
        painter: checker,
    },
    Floor {
        name: "noise, turned",
        camera: TURNED,
        texel: 1.0,
        sides: [13, 7],
        painter: noise,
    },
    Floor {
        name: "squares of 32 texels, level",
        camera: LEVEL,
        texel: 1.0 / 32.0,
        sides: [64, 64],
        painter: squares,
    },
    Floor {
        name: "squares of 32 texels, turned",
        camera: TURNED,
        texel: 1.0 / 32.0,
        sides: [64, 64],
        painter: squares,
    },
];

fn main() {
    let arguments = Arguments::parse();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1);
    let pool = pool.stack_size(STACK).build().expect("a thread");
    pool.install(|| {
        for floor in &FLOORS {
            compare(floor, &arguments);
        }
    });
}

fn compare(floor: &Floor, arguments: &Arguments) {
    let folder = folder(floor.sides, floor.painter);
    let draw = |size, filter: &str, samples: u32| {
        let start = ProcessTime::now();
        let text = head(size, floor.camera) + &floors::floor(floor.texel, HORIZON);
        let settings = [
            ("texture-filter", filter),
            ("samples", &samples.to_string()),
            ("pattern", "sobol"),
        ];
        let scene = scene(&text, folder.path(), &settings);
        let (film, _) = Render::new(&scene).film::<Counts>().expect("a picture");
        (film, start.elapsed().as_secs_f64())
    };
    let small = [24, 16];
    let (truth, _) = draw(small, "nearest", arguments.reference);
    let (exact, _) = draw(small, "exact", 1);
    let [all, whole] = errors(&exact, &truth);
    let large = [384, 192];
    let (_, dear) = draw(large, "nearest", arguments.beside);
    let cheap = (0..5)
        .map(|_| draw(large, "exact", 1).1)
        .fold(f64::MAX, f64::min);
    println!(
        "{:30} error {all:.3}, without the horizon {whole:.3}; 1/{:.1} of the time",
        floor.name,
        dear / cheap
    );
}

/// The largest error of a channel in code values, over all pixels whose middle shows the floor and over
/// those that are more than a pixel below the horizon.
fn errors(exact: &Film, truth: &Film) -> [f64; 2] {
    let mut most = [0.0f64; 2];
    let size = [24, 16];
    for [column, row] in Region::whole(size).pixels() {
        let (found, expected) = (exact.pixel(column, row), truth.pixel(column, row));
        // In blue every pixel shows how much of it is floor.
        if found.b == 0.0 || expected.b == 0.0 {
            continue;
        }
        let around = Region::around([column, row], size);
        let is_below = around
            .pixels()
            .all(|[column, row]| truth.pixel(column, row).b == 1.0);
        for (found, expected) in [(found.r, expected.r), (found.g, expected.g)] {
            let off = (found - expected / truth.pixel(column, row).b).abs() * 255.0;
            most[0] = most[0].max(off);
            if is_below {
                most[1] = most[1].max(off);
            }
        }
    }
    most
}
