//! `heliodon cost`.

use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{PathBufValueParser, TypedValueParser};

use super::error::CommandError;
use super::messages::{Json, Messages, problems_json};
use super::numbers::whole;
use super::output::place;
use super::setting_options::SettingOptions;
use super::threads::Threads;
use super::{Status, input, progress};
use crate::film::{check_writable, save};
use crate::measure::{self, Best, Cost, CostOptions, Limit, Reference, Sweep, Variation};
use crate::read::Reading;
use crate::scene::Scene;

/// Measure what accuracy costs in time: settings of a scene, each against a reference.
///
/// Without --vary, each setting that can change this picture is varied alone. Errors and numbers of
/// rays are the same in every run; times are not.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    input: input::OneScene,
    /// Try these values of a setting of `image`; may be given for several settings.
    #[arg(long, value_name = "WORD=A,B,…", allow_hyphen_values = true, value_parser = Variation::new)]
    vary: Vec<Variation>,
    /// Try all combinations of the varied settings, instead of each alone.
    #[arg(long, requires = "vary")]
    grid: bool,
    /// Reference picture: a PNG, PPM or PFM file, or `auto` to render the most accurate one.
    #[arg(long, value_name = "FILE", default_value = "auto")]
    reference: PathBuf,
    /// Largest number of runs of each setting; times are medians.
    ///
    /// A setting is repeated until its times agree within 2 % (median deviation), at least twice.
    #[arg(long, value_name = "N", default_value = "3", allow_hyphen_values = true, value_parser = whole(1000))]
    runs: u32,
    #[command(flatten)]
    threads: Threads,
    /// Name the fastest settings of this accuracy: rmse=, max=, off=, psnr=, ssim= or flip=.
    ///
    /// For example rmse=1e-3, max=1, off=0.01, psnr=40, ssim=0.99 or flip=0.01. The fastest settings
    /// take the least processor time. Exit code 1 if none are as accurate.
    #[arg(long, value_name = "WHAT=X", allow_hyphen_values = true, value_parser = Limit::new)]
    target: Option<Limit>,
    /// Name the most accurate settings within this wall-clock time, such as 2s or 500ms.
    ///
    /// Exit code 1 if none are as fast.
    #[arg(long, value_name = "TIME", allow_hyphen_values = true, value_parser = seconds)]
    budget: Option<f64>,
    #[command(flatten)]
    json: Json,
    /// Write the table as comma-separated values.
    #[arg(long, value_name = "FILE", value_parser = named(&["csv"]))]
    csv: Option<PathBuf>,
    /// Write the plot of error against time as SVG.
    #[arg(long, value_name = "FILE", value_parser = named(&["svg"]))]
    plot: Option<PathBuf>,
    /// Write one self-contained HTML page with plot, pictures, errors and table.
    #[arg(long, value_name = "FILE", value_parser = named(&["html", "htm"]))]
    report: Option<PathBuf>,
    // The last, since the help lists later options under its heading.
    #[command(flatten)]
    settings: SettingOptions,
}

impl Options {
    /// The file to compare with, if one is named.
    fn reference(&self) -> Option<&Path> {
        (self.reference.as_os_str() != "auto").then_some(&self.reference)
    }
}

/// A parser of file names with one of these endings or none; pipes and devices may have any name.
fn named(endings: &'static [&'static str]) -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(move |path| {
        let fits = path.extension().is_none_or(|it| {
            let mut endings = endings.iter();
            endings.any(|ending| it.eq_ignore_ascii_case(ending))
        });
        let is_special = |it: std::fs::Metadata| !it.is_file() && !it.is_dir();
        if fits || path.metadata().is_ok_and(is_special) {
            return Ok(path);
        }
        let endings: Vec<_> = endings.iter().map(|it| format!(".{it}")).collect();
        let endings = endings.join(" or ");
        Err(format!(
            "expected a name that ends with {endings}, or has no ending"
        ))
    })
}

/// A time in seconds from `2s` or `500ms`.
fn seconds(text: &str) -> Result<f64, String> {
    let (number, unit) = match text.strip_suffix("ms") {
        Some(number) => (number, 0.001),
        None => (text.strip_suffix('s').unwrap_or(text), 1.0),
    };
    let number: Option<f64> = number.trim().parse().ok();
    let number = number.filter(|number| number.is_finite() && *number > 0.0);
    number
        .map(|number| number * unit)
        .ok_or_else(|| "expected a time above zero, such as 2s or 500ms".to_owned())
}

pub(super) fn run(options: &Options, messages: &Messages) -> Status {
    let json = options.json.is_asked();
    messages.finish(&options.input.scene, json, answer(options, messages))
}

/// The text or the JSON to print, and the status.
fn answer(options: &Options, messages: &Messages) -> Result<(String, Status), CommandError> {
    let reader = options.settings.added_to(options.input.options());
    let mut reading = input::read(&options.input.scene, &reader, messages)?;
    check_outputs(options, &reading.scene)?;
    let pool = options.threads.pool()?;
    let cost = pool.install(|| measured(options, &mut reading.scene, messages))?;
    let target = options.target.map(|limit| cost.cheapest(limit));
    let budget = options.budget.map(|budget| cost.within(budget));
    let answers = [("target", target), ("budget", budget)].into_iter();
    let answers: Vec<_> = answers
        .filter_map(|(word, best)| Some((word, best?)))
        .collect();
    write(options, &cost, &answers, messages)?;
    let title = options.input.title();
    let unmet = answers.iter().any(|(_, best)| best.label.is_none());
    let status = if unmet { Status::No } else { Status::Done };
    let text = if options.json.is_asked() {
        json(&title, status, &reading, &cost, &answers)
    } else {
        let answers = answers.iter().map(|(word, best)| best.words(word) + "\n");
        let answers: String = answers.collect();
        let [width, height] = cost.size;
        let runs = cost.runs_words();
        format!("{title}, {width}x{height}, {runs}\n\n{cost}{answers}")
    };
    Ok((text, status))
}

fn measured(
    options: &Options,
    scene: &mut Scene,
    messages: &Messages,
) -> Result<Cost, CommandError> {
    let title = options.input.title();
    let refused = |error| CommandError::value(Status::BadInput, &title, &error);
    let base = scene.settings;
    let sweep = match (options.vary.as_slice(), options.grid) {
        ([], _) => Ok(Sweep::of(
            base,
            &measure::effects_of(scene).map_err(refused)?,
        )),
        (variations, true) => Sweep::grid(base, variations),
        (variations, false) => Sweep::each(base, variations),
    };
    let sweep = sweep
        .map_err(|error| CommandError::usage(format!("{}; {}", error.reason, error.advice)))?;
    let reference = options.reference().map(|path| {
        let reference = Reference::from_file(path, [base.width, base.height], base.transfer);
        reference.map_err(|error| {
            CommandError::io(format!("cannot compare with {}: {error}", path.display()))
        })
    });
    let how = CostOptions {
        reference: reference.transpose()?,
        runs: options.runs,
        with_pictures: options.report.is_some(),
    };
    let bar = progress::bar(&title, 0, messages);
    let cost = measure::cost(scene, &sweep, how, &|done, of| {
        progress::show(&bar, done, of);
    });
    bar.finish_and_clear();
    cost.map_err(refused)
}

/// Checks the files to write before anything is measured.
///
/// # Errors
/// Refuses a file that would be written twice or would replace the reference or a part of the scene,
/// and a place where nothing can be written.
fn check_outputs(options: &Options, scene: &Scene) -> Result<(), CommandError> {
    let outputs = [&options.csv, &options.plot, &options.report];
    let outputs: Vec<&PathBuf> = outputs.into_iter().flatten().collect();
    let same = |one: &Path, other: &Path| {
        let places = [one, other].map(|path| place(path).ok());
        places[0].is_some() && places[0] == places[1]
    };
    for (number, output) in outputs.iter().enumerate() {
        let name = output.display();
        let part = || input::part_at(output, &options.input.scene, scene);
        let refused = if output.as_os_str() == "-" {
            Some("standard output carries the table; give a file name".to_owned())
        } else if outputs[..number].iter().any(|other| same(other, output)) {
            Some(format!("{name} would be written twice"))
        } else if let Some(part) = part() {
            let title = options.input.title();
            Some(format!("{name} would replace {part}, which {title} uses"))
        } else if options.reference().is_some_and(|it| same(it, output)) {
            Some(format!("{name} would replace the reference"))
        } else {
            None
        };
        if let Some(reason) = refused {
            return Err(CommandError::usage(reason));
        }
        check_writable(output).map_err(|error| CommandError::write(name, error))?;
    }
    Ok(())
}

fn write(
    options: &Options,
    cost: &Cost,
    answers: &[(&str, Best)],
    messages: &Messages,
) -> Result<(), CommandError> {
    let title = options.input.title();
    let done = |path: &Path, written: std::io::Result<()>| {
        let name = path.display();
        written.map_err(|error| CommandError::write(&name, error))?;
        messages.note(&format!("{title} -> {name}"));
        Ok(())
    };
    if let Some(path) = &options.csv {
        done(path, save(path, |out| cost.write_csv(out)))?;
    }
    if let Some(path) = &options.plot {
        done(
            path,
            save(path, |out| out.write_all(cost.plot().as_bytes())),
        )?;
    }
    if let Some(path) = &options.report {
        let page = cost.page(&title, answers);
        let page = page.map_err(|error| CommandError::write(path.display(), error))?;
        done(path, save(path, |out| out.write_all(page.as_bytes())))?;
    }
    Ok(())
}

fn json(
    title: &str,
    status: Status,
    reading: &Reading,
    cost: &Cost,
    answers: &[(&str, Best)],
) -> String {
    let mut line = cost.json();
    line["scene"] = title.into();
    line["exit"] = status.code().into();
    line["problems"] = problems_json(&reading.warnings, &reading.scene.sources).into();
    for word in ["target", "budget"] {
        let answer = answers.iter().find(|(known, _)| *known == word);
        line[word] = serde_json::json!(answer.map(|(_, best)| best));
    }
    format!("{line}\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_budget_is_a_time() {
        assert_eq!(seconds("2s"), Ok(2.0));
        assert_eq!(seconds("500 ms"), Ok(0.5));
        assert_eq!(seconds("1.5"), Ok(1.5));
        for text in ["", "s", "-1s", "nan", "2m"] {
            assert!(seconds(text).is_err(), "{text}");
        }
    }
}
