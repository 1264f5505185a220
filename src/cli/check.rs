//! `heliodon check`.

use std::path::{Path, PathBuf};

use clap::Args;

use super::messages::{Messages, problems_json};
use super::{Status, input};
use crate::measure;

/// Reads scenes and reports every error, and what is odd about their geometry.
///
/// Exit code 0 if there are no errors, 1 if there are; warnings do not count.
#[derive(Debug, Args)]
pub(super) struct Options {
    /// Scene files; `-` is standard input.
    #[arg(required = true, value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    #[command(flatten)]
    format: input::SceneFormat,
}

pub(super) fn run(options: &Options, messages: &Messages) -> Status {
    let statuses = options
        .scenes
        .iter()
        .map(|scene| one(scene, options, messages));
    statuses.fold(Status::Done, Status::worst)
}

fn one(scene: &Path, options: &Options, messages: &Messages) -> Status {
    let name = input::title(scene);
    let reading = match input::read(scene, &options.format.options(), messages) {
        Ok(reading) => reading,
        Err(failure) => {
            let status = match failure.status {
                // That a scene has errors is the answer here, not a failure to give one.
                Status::BadInput => Status::No,
                other => other,
            };
            return print(
                messages,
                failure.json(scene),
                format!("{name}: errors\n"),
                status,
            );
        }
    };
    let warnings = measure::check(&reading.scene);
    let sources = &reading.scene.sources;
    messages.problems(&warnings, sources);
    let all: Vec<_> = reading.warnings.iter().chain(&warnings).cloned().collect();
    let json = serde_json::json!({
        "scene": name,
        "exit": Status::Done.code(),
        "problems": problems_json(&all, sources),
    });
    let verdict = match all.len() {
        0 => "ok".to_owned(),
        1 => "ok, 1 warning".to_owned(),
        many => format!("ok, {many} warnings"),
    };
    print(
        messages,
        format!("{json}\n"),
        format!("{name}: {verdict}\n"),
        Status::Done,
    )
}

fn print(messages: &Messages, json: String, text: String, status: Status) -> Status {
    match messages.result(if messages.json { &json } else { &text }) {
        Ok(()) => status,
        Err(error) => {
            messages.error(&format!("error: cannot write to standard output: {error}"));
            status.worst(Status::Io)
        }
    }
}
