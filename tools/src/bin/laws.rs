//! Measures the laws in `docs/accuracy.md` anew: how wrong each dial is at each of its steps.
//!
//! `cargo run --release --bin laws`, in the project's folder. It writes the figures in `docs/laws` and
//! the numbers that they show. All are the same on every machine; tests compare them.

use heliodon_tools::laws::{figures, series};

fn main() -> Result<(), series::Failed> {
    let pool = rayon::ThreadPoolBuilder::new().stack_size(heliodon::render::STACK);
    pool.build()?.install(|| {
        for law in figures::LAWS {
            println!("{}", law.name);
            let text = series::written(law.columns, &(law.measured)()?)?;
            let figure = (law.figure)(&series::read(&text)?);
            std::fs::write(law.file("csv"), text)?;
            std::fs::write(law.file("svg"), figure.svg())?;
        }
        Ok(())
    })
}
