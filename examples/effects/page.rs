//! The measured part of `docs/effects.md`.

use std::error::Error;
use std::fmt::Write;
use std::io;
use std::path::{Path, PathBuf};

use heliodon::measure::{Prices, prices};
use heliodon::read::{Options, read_file};

/// The page.
pub(crate) const DOCUMENT: &str = "docs/effects.md";

/// The size of the pictures that are measured: small enough for a test, large enough for a clock.
const SIZE: [u32; 2] = [240, 180];

const START: &str = "<!-- What follows is measured by `examples/effects`. -->\n";
const END: &str = "<!-- The end of what is measured. -->\n";

/// The scenes of the project, in the order of their names.
pub(crate) fn scenes() -> io::Result<Vec<PathBuf>> {
    let entries = std::fs::read_dir("scenes")?;
    let paths = entries.map(|entry| Ok(entry?.path()));
    let mut paths = paths.collect::<io::Result<Vec<_>>>()?;
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "kdl"));
    paths.sort();
    Ok(paths)
}

/// A scene and its prices.
#[derive(Debug)]
pub(crate) struct List {
    scene: PathBuf,
    samples: u32,
    prices: Prices,
}

impl List {
    /// Measures a scene.
    pub(crate) fn measure(path: &Path, runs: u32) -> Result<Self, Box<dyn Error + Send + Sync>> {
        let options = Options {
            size: Some(SIZE),
            ..Options::default()
        };
        let reading = read_file(path, &options)?;
        let reading = reading.map_err(|no| format!("{:?}", no.diagnostics))?;
        Ok(Self {
            scene: path.to_owned(),
            samples: reading.scene.settings.samples,
            prices: prices(&reading.scene, runs, &|_, _| ())?,
        })
    }

    fn link(&self) -> String {
        let name = self.scene.file_stem().unwrap_or_default().to_string_lossy();
        format!("[{name}](../scenes/{name}.kdl)")
    }
}

/// The page with these lists in place of its own; `None` if it does not say where they belong.
pub(crate) fn renewed(page: &str, lists: &[List]) -> Option<String> {
    let (before, rest) = page.split_once(START)?;
    let (_, after) = rest.split_once(END)?;
    let measured = format!("{}{}", elisions(lists), effects(lists));
    Some(format!("{before}{START}{measured}{END}{after}"))
}

/// What simulating everything costs, a row for each scene.
fn elisions(lists: &[List]) -> String {
    let [width, height] = SIZE;
    let runs = lists.first().map_or(0, |list| list.prices.runs);
    let mut text = format!(
        "\nMeasured at {width} × {height} pixels with the scenes' own `samples`: medians of {runs} \
         runs, in turn, ± their median\nabsolute deviation, in processor time of one thread. \
         Planning the scene is a part of it, reading it is not.\n\n\
         ## What is left out\n\n\
         | scene | shadow rays | tests of each | time | with everything | tests of each | time | takes |\n\
         |---|--:|--:|--:|--:|--:|--:|--:|\n",
    );
    for list in lists {
        let Prices {
            whole, everything, ..
        } = &list.prices;
        let [called, all] = [whole, everything].map(|effort| {
            let tests = effort.tests_per_shadow_ray();
            let tests = tests.map_or_else(|| "-".to_owned(), |tests| format!("{tests:.2}"));
            let rays = effort.shadow_rays();
            format!("{rays} | {tests} | {}", effort.time)
        });
        let takes = everything.time.over(whole.time);
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "| {} | {called} | {all} | × {takes:.2} |",
            list.link()
        );
    }
    text
}

/// What the effects cost, a table for each scene.
fn effects(lists: &[List]) -> String {
    let mut text = "\n## What each effect costs\n".to_owned();
    for list in lists {
        let samples = match list.samples {
            1 => "1 ray through each pixel".to_owned(),
            some => format!("{some} rays through each pixel"),
        };
        let _ = write!(
            text,
            "\n### {}\n\n{samples}.\n\n```text\n{}```\n",
            list.link(),
            list.prices.list()
        );
    }
    text.push('\n');
    text
}
