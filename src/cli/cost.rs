//! `heliodon cost`.

use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{PathBufValueParser, TypedValueParser};

use super::dials::Dials;
use super::input::ReadError;
use super::messages::{Json, Messages, problems_json};
use super::numbers::whole;
use super::output::place;
use super::threads::Threads;
use super::{Status, input, progress};
use crate::film::{check_writable, save};
use crate::language::ValueError;
use crate::measure::{self, Best, Cost, Ladder, Limit, Reference, Variation};
use crate::read::Reading;
use crate::scene::Scene;

/// Measures what accuracy costs in time: settings of a scene, each against a reference.
///
/// Without --vary each dial is tried alone that can change this scene's picture. The error of a
/// picture and the number of rays are the same in every run; times are not.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    input: input::OneScene,
    /// Try these values of a property of `image`; may be given for several.
    #[arg(long, value_name = "WORD=A,B,…", allow_hyphen_values = true, value_parser = Variation::new)]
    vary: Vec<Variation>,
    /// Try all combinations of what is varied, instead of each alone.
    #[arg(long, requires = "vary")]
    grid: bool,
    /// What to compare with: a PNG, PPM or PFM file, or `auto`, the best picture that there is.
    #[arg(long, value_name = "FILE", default_value = "auto")]
    reference: PathBuf,
    /// How often to draw each setting at most; times are medians. One is drawn no more when the
    /// median deviation of its times is a fiftieth.
    #[arg(long, value_name = "N", default_value = "3", allow_hyphen_values = true, value_parser = whole(1000))]
    runs: u32,
    #[command(flatten)]
    threads: Threads,
    /// Name the settings that are this good and take the least processor time, such as rmse=1e-3,
    /// max=1, off=0.01, psnr=40, ssim=0.99 or flip=0.01; exit code 1 if none are.
    #[arg(long, value_name = "WHAT=X", allow_hyphen_values = true, value_parser = Limit::new)]
    target: Option<Limit>,
    /// Name the most accurate settings that take no longer on the clock, such as 2s or 500ms; exit
    /// code 1 if none do.
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
    /// Write a page with plot, pictures, errors and table, one HTML file that needs nothing else.
    #[arg(long, value_name = "FILE", value_parser = named(&["html", "htm"]))]
    report: Option<PathBuf>,
    // The last, since the help has what comes after them under their heading.
    #[command(flatten)]
    dials: Dials,
}

impl Options {
    /// The file to compare with, if one is named.
    fn reference(&self) -> Option<&Path> {
        (self.reference.as_os_str() != "auto").then_some(&self.reference)
    }
}

/// A reader of files' names that have one of these endings or none; pipes and devices are called as they
/// like.
fn named(endings: &'static [&'static str]) -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(move |path| {
        let fits = path.extension().is_none_or(|it| {
            let mut endings = endings.iter();
            endings.any(|ending| it.eq_ignore_ascii_case(ending))
        });
        let is_special = || {
            path.metadata()
                .is_ok_and(|it| !it.is_file() && !it.is_dir())
        };
        if fits || is_special() {
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
    match answer(options, messages) {
        Ok((text, status)) => messages.result(&text, status),
        Err(failure) if options.json.is_asked() => {
            messages.result(&failure.json(&options.input.scene), failure.status)
        }
        Err(failure) => failure.status,
    }
}

/// What is printed, and how it ends.
fn answer(options: &Options, messages: &Messages) -> Result<(String, Status), ReadError> {
    let reader = options.dials.added_to(options.input.options());
    let mut reading = input::read(&options.input.scene, &reader, messages)?;
    check_outputs(options, &reading.scene, messages)?;
    let pool = options.threads.pool();
    let pool = pool.map_err(|error| ReadError::new(Status::Io, error, messages))?;
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

fn measured(options: &Options, scene: &mut Scene, messages: &Messages) -> Result<Cost, ReadError> {
    let title = options.input.title();
    let refused = |error: ValueError| {
        let error = format!("{title}: {}; {}", error.reason, error.advice);
        ReadError::new(Status::BadInput, error, messages)
    };
    let senseless = |error: ValueError| {
        let error = format!("{}; {}", error.reason, error.advice);
        ReadError::new(Status::Usage, error, messages)
    };
    let base = scene.settings;
    let ladder = match (options.vary.as_slice(), options.grid) {
        ([], _) => Ladder::of(base, &measure::effects_of(scene).map_err(refused)?),
        (variations, true) => Ladder::of_all(base, variations).map_err(senseless)?,
        (variations, false) => Ladder::of_each(base, variations).map_err(senseless)?,
    };
    let reference = options.reference().map(|path| {
        Reference::from_file(path, [base.width, base.height], base.transfer).map_err(|error| {
            let error = format!("cannot compare with {}: {error}", path.display());
            ReadError::new(Status::Io, error, messages)
        })
    });
    let bar = progress::bar(&title, 0, messages);
    let pictures = options.report.is_some();
    let cost = measure::cost(
        scene,
        &ladder,
        reference.transpose()?,
        options.runs,
        pictures,
        &|done, of| {
            bar.set_length(of as u64);
            bar.set_position(done as u64);
        },
    );
    bar.finish_and_clear();
    cost.map_err(refused)
}

/// Refuses to write one file twice, over what the scene is made of or compared with, or where nothing can
/// be written, before anything is measured.
fn check_outputs(options: &Options, scene: &Scene, messages: &Messages) -> Result<(), ReadError> {
    let outputs = [&options.csv, &options.plot, &options.report];
    let outputs: Vec<&Path> = outputs
        .into_iter()
        .flatten()
        .map(PathBuf::as_path)
        .collect();
    let same = |one: &Path, other: &Path| {
        let places = [one, other].map(|path| place(path).ok());
        places[0].is_some() && places[0] == places[1]
    };
    for (number, output) in outputs.iter().enumerate() {
        let error = if output.as_os_str() == "-" {
            let error = "standard output has the table; give a name to the file";
            (Status::Usage, error.to_owned())
        } else if outputs[..number].iter().any(|other| same(other, output)) {
            (
                Status::Usage,
                format!("{} would be written twice", output.display()),
            )
        } else if let Some(part) = input::part_at(output, &options.input.scene, scene) {
            let title = options.input.title();
            let error = format!(
                "{} would replace {part}, which {title} is made of",
                output.display()
            );
            (Status::Usage, error)
        } else if options.reference().is_some_and(|it| same(it, output)) {
            (
                Status::Usage,
                format!("{} would replace what is compared with", output.display()),
            )
        } else if let Err(error) = check_writable(output) {
            let error = format!("cannot write {}: {error}", output.display());
            (Status::Io, error)
        } else {
            continue;
        };
        return Err(ReadError::new(error.0, error.1, messages));
    }
    Ok(())
}

fn write(
    options: &Options,
    cost: &Cost,
    answers: &[(&str, Best)],
    messages: &Messages,
) -> Result<(), ReadError> {
    let title = options.input.title();
    let cannot = |path: &Path, error: &dyn std::fmt::Display| {
        let error = format!("cannot write {}: {error}", path.display());
        ReadError::new(Status::Io, error, messages)
    };
    let done = |path: &Path| messages.note(&format!("{title} -> {}", path.display()));
    if let Some(path) = &options.csv {
        save(path, |out| cost.write_csv(out)).map_err(|error| cannot(path, &error))?;
        done(path);
    }
    if let Some(path) = &options.plot {
        let saved = save(path, |out| out.write_all(cost.plot().as_bytes()));
        saved.map_err(|error| cannot(path, &error))?;
        done(path);
    }
    if let Some(path) = &options.report {
        let page = cost
            .page(&title, answers)
            .map_err(|error| cannot(path, &error))?;
        let saved = save(path, |out| out.write_all(page.as_bytes()));
        saved.map_err(|error| cannot(path, &error))?;
        done(path);
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
    let mut line = serde_json::json!(cost);
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
