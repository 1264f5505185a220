//! The measured part of `docs/effects.md`.

use std::error::Error;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use heliodon::measure::{Prices, prices};
use heliodon::read::{Options, read_file};
use support::files::files;
use support::texts::Section;

/// The page.
pub const DOCUMENT: &str = "docs/effects.md";

/// The size of the pictures that are measured: small enough for a test, large enough for a clock.
const SIZE: [u32; 2] = [240, 180];

/// How the lines begin between which the measured part stands.
const MARKS: [&str; 2] = [
    "<!-- Start of the measured part",
    "<!-- End of the measured part",
];

/// The scenes of the project, in the order of their names.
#[must_use]
pub fn scenes() -> Vec<PathBuf> {
    files("scenes", "kdl")
}

/// A scene and its prices.
#[derive(Debug)]
pub struct List {
    scene: PathBuf,
    samples: u32,
    prices: Prices,
}

impl List {
    /// Measures a scene.
    pub fn measure(path: &Path, runs: u32) -> Result<Self, Box<dyn Error + Send + Sync>> {
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
pub fn renewed(page: &str, lists: &[List]) -> Option<String> {
    let [start, end] = MARKS;
    let section = Section::of(page, start, end)?;
    Some(section.with(&format!("{}{}", elisions(lists), effects(lists))))
}

/// What simulating everything costs, a row for each scene.
fn elisions(lists: &[List]) -> String {
    let [width, height] = SIZE;
    let runs = lists.first().map_or(0, |list| list.prices.runs);
    let mut text = format!(
        "\nMeasured at {width} × {height} pixels with each scene's own `samples`. Times are \
         processor time of one thread: medians of {runs} runs, in\nturn, ± their median absolute \
         deviation. Planning a scene is included; reading it is not.\n\n\
         ## Measured savings of the plan\n\n\
         The columns on the right are for `--simulate-everything`. The last one is the ratio of \
         the two times.\n\n\
         | scene | shadow rays | tests per ray | time | shadow rays | tests per ray | time | ratio |\n\
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
    let mut text = "\n## Measured price of each effect\n".to_owned();
    for list in lists {
        let samples = match list.samples {
            1 => "1 ray per pixel".to_owned(),
            some => format!("{some} rays per pixel"),
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
