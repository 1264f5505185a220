//! Measures what the effects of the project's scenes cost, and writes it into `docs/effects.md`.
//!
//! `cargo run --release --bin effects [RUNS]`, in the project's folder; 5 runs if not told
//! otherwise. Everything but the times is the same on every machine, and tests compare it.

use std::error::Error;

use heliodon_tools::effects as page;

fn main() -> Result<(), Box<dyn Error + Send + Sync>> {
    let runs = match std::env::args().nth(1) {
        Some(runs) => runs.parse()?,
        None => 5,
    };
    let mut lists = Vec::new();
    for path in page::scenes() {
        println!("{}", path.display());
        lists.push(page::List::measure(&path, runs)?);
    }
    let text = std::fs::read_to_string(page::DOCUMENT)?;
    let text = page::renewed(&text, &lists).ok_or("the page has lost its marks")?;
    std::fs::write(page::DOCUMENT, text)?;
    Ok(())
}
