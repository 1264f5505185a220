//! `heliodon check`.

use std::path::{Path, PathBuf};

use clap::Args;

use super::messages::{Json, Messages, problems_json};
use super::{Status, input, shared};
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
    #[command(flatten)]
    json: Json,
}

pub(super) fn run(options: &Options, messages: &Messages) -> Status {
    let scenes = options.scenes.iter();
    let statuses: Vec<_> = scenes.map(|scene| one(scene, options, messages)).collect();
    messages.tally(&statuses);
    statuses.into_iter().fold(Status::Done, Status::worst)
}

fn one(scene: &Path, options: &Options, messages: &Messages) -> Status {
    let name = input::title(scene);
    let reading = match input::read(scene, &options.format.options(), messages) {
        Ok(reading) => reading,
        Err(mut failure) => {
            let verdict = if failure.status == Status::BadInput {
                // That a scene has errors is the answer here, not a failure to give one.
                failure.status = Status::No;
                "errors"
            } else {
                "cannot be read"
            };
            let text = format!("{name}: {verdict}\n");
            let json = failure.json(scene);
            return messages.result(
                if options.json.is_asked() {
                    &json
                } else {
                    &text
                },
                failure.status,
            );
        }
    };
    let warnings = measure::check(&reading.scene);
    let sources = &reading.scene.sources;
    messages.problems(&warnings, sources);
    let all: Vec<_> = reading.warnings.iter().chain(&warnings).cloned().collect();
    let verdict = match all.len() {
        0 => "ok".to_owned(),
        1 => "ok, 1 warning".to_owned(),
        many => format!("ok, {many} warnings"),
    };
    let text = if options.json.is_asked() {
        let json = serde_json::json!({
            "scene": name,
            "exit": Status::Done.code(),
            "welds": shared::as_json(&reading.scene),
            "problems": problems_json(&all, sources),
        });
        format!("{json}\n")
    } else {
        let welds = shared::as_text(&reading.scene, messages.verbose);
        format!("{name}: {verdict}\n{welds}")
    };
    messages.result(&text, Status::Done)
}
