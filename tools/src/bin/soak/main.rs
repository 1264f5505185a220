//! Sends aimed and random rays in any number and checks what they meet.
//!
//! `soak --help` lists the kinds of rays. The checks and the aiming are those of the oracle in
//! `oracle`; here they run for as long as one likes, on all cores, and can be resumed.

mod block;
mod options;

use std::process::ExitCode;
use std::time::Instant;

use clap::Parser;
use rayon::prelude::*;

use block::BLOCK;
use options::Options;
use oracle::tally::Tally;

fn main() -> ExitCode {
    let options = Options::parse();
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(options.threads)
        .build();
    let pool = pool.expect("threads can be started");
    let started = Instant::now();
    let first = options.from / BLOCK;
    let last = (options.from + options.rays).div_ceil(BLOCK);
    let tallies = || {
        (first..last)
            .into_par_iter()
            .map(|block| block::run(&options, block))
    };
    let tally = pool.install(|| {
        tallies().reduce(Tally::default, |mut all, one| {
            all += one;
            all
        })
    });
    println!(
        "{}",
        options.line(&tally, last * BLOCK, started.elapsed().as_secs_f64())
    );
    for sample in &tally.samples {
        eprintln!("{sample}");
    }
    ExitCode::from(u8::from(tally.mismatches > 0))
}
