//! `heliodon check`.

use std::path::{Path, PathBuf};

use clap::Args;

use super::messages::{Json, Messages, problems_json};
use super::{Status, input, shared};
use crate::measure;

/// Check scenes: report every error, and geometry that is probably a mistake.
///
/// Exit code 0 if no scene has errors, 1 if one has. Warnings do not count.
#[derive(Debug, Args)]
pub(super) struct Options {
    /// Scene files; `-` reads standard input.
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
    statuses.into_iter().max().unwrap_or(Status::Done)
}

fn one(scene: &Path, options: &Options, messages: &Messages) -> Status {
    let name = input::title(scene);
    let is_json = options.json.is_asked();
    let reading = match input::read(scene, &options.format.options(), messages) {
        Ok(reading) => reading,
        Err(mut error) => {
            messages.failed(&error);
            let mut verdict = "cannot be read";
            if error.status == Status::BadInput {
                // Errors in the scene are the answer here, not a failure to give one.
                (error.status, verdict) = (Status::No, "errors");
            }
            let text = if is_json {
                error.json(scene)
            } else {
                format!("{name}: {verdict}\n")
            };
            return messages.result(&text, error.status);
        }
    };
    let warnings = measure::check(&reading.scene);
    let sources = &reading.scene.sources;
    messages.problems(&warnings, sources);
    let all: Vec<_> = reading.warnings.iter().chain(&warnings).cloned().collect();
    let text = if is_json {
        let json = serde_json::json!({
            "scene": name,
            "exit": Status::Done.code(),
            "shared": shared::as_json(&reading.scene),
            "problems": problems_json(&all, sources),
        });
        format!("{json}\n")
    } else {
        let verdict = match all.len() {
            0 => "ok".to_owned(),
            1 => "ok, 1 warning".to_owned(),
            many => format!("ok, {many} warnings"),
        };
        let shared = shared::as_text(&reading.scene, messages.verbose);
        format!("{name}: {verdict}\n{shared}")
    };
    messages.result(&text, Status::Done)
}
