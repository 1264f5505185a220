//! What robust numerics cost: the processor time of whole runs, beside the chapter's own algorithm.
//!
//! `cargo bench --bench against_classic [-- PAIRS [SCENE …]]` renders the rooms and the saucers (or
//! the scenes that are named) on one thread, with `--numerics robust`, `classic` and `classic-f32`
//! in turn, and prints the medians of the ratios within each turn. Below 1, robust is faster.

mod processor;

use std::error::Error;
use std::process::Command;

use processor::median;

const TURNS: usize = 15;
const SCENES: [&str; 7] = [
    "scenes/room-1-small-bricks.kdl",
    "scenes/room-2-large-bricks.kdl",
    "scenes/room-3-bright-wall.kdl",
    "scenes/room.kdl",
    "scenes/saucers.kdl",
    "scenes/saucers-with-shadows.kdl",
    "scenes/saucers-textured.kdl",
];
const NUMERICS: [&str; 3] = ["robust", "classic", "classic-f32"];

fn main() -> Result<(), Box<dyn Error>> {
    // Cargo adds `--bench`.
    let named = std::env::args().skip(1);
    let mut named = named
        .filter(|argument| !argument.starts_with("--"))
        .peekable();
    let turns = match named.peek().map(|first| first.parse()) {
        Some(Ok(turns)) => {
            named.next();
            turns
        }
        _ => TURNS,
    };
    let named: Vec<_> = named.collect();
    let scenes = if named.is_empty() {
        SCENES.map(str::to_owned).to_vec()
    } else {
        named
    };

    println!("CPU time of whole runs on one thread, medians of {turns} turns\n");
    println!(
        "| scene | robust | classic | classic-f32 | robust / classic | robust / classic-f32 |"
    );
    println!("|---|---:|---:|---:|---:|---:|");
    let mut all = Vec::new();
    for scene in &scenes {
        let times = (0..turns).map(|turn| times(scene, turn));
        let times = times.collect::<Result<Vec<_>, _>>()?;
        let time = |which: usize| median(times.iter().map(|times| times[which]));
        let ratio = |which: usize| median(times.iter().map(|times| times[0] / times[which]));
        println!(
            "| {scene} | {:.1} ms | {:.1} ms | {:.1} ms | {:.3} | {:.3} |",
            1e3 * time(0),
            1e3 * time(1),
            1e3 * time(2),
            ratio(1),
            ratio(2),
        );
        all.extend(times);
    }
    let ratio = |which: usize| median(all.iter().map(|times| times[0] / times[which]));
    println!("| all | | | | {:.3} | {:.3} |", ratio(1), ratio(2));
    Ok(())
}

/// The time of each of the numerics; each turn begins with another one, so that none is always
/// first.
fn times(scene: &str, turn: usize) -> Result<[f64; 3], Box<dyn Error>> {
    let mut times = [0.0; 3];
    for step in 0..NUMERICS.len() {
        let which = (turn + step) % NUMERICS.len();
        times[which] = cpu_seconds(scene, NUMERICS[which])?;
    }
    Ok(times)
}

/// The processor's time of a run; the picture goes nowhere, but it is made.
fn cpu_seconds(scene: &str, numerics: &str) -> Result<f64, Box<dyn Error>> {
    let mut command = Command::new(env!("CARGO_BIN_EXE_heliodon"));
    command.args(["render", scene, "--numerics", numerics, "--threads", "1"]);
    processor::seconds(command.args(["-q", "--format", "ppm", "-o", "-"]))
}
