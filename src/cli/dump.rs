//! `heliodon dump`.

use std::path::{Path, PathBuf};

use clap::Args;

use super::messages::Messages;
use super::{Status, convert::name_from, input};

/// Prints the resolved scene as KDL, every include inserted and every default spelled out.
///
/// This is the chapter's `dump_obj`; what it prints renders to the same picture.
#[derive(Debug, Args)]
pub(super) struct Options {
    /// Scene file; `-` is standard input.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    #[command(flatten)]
    format: input::SceneFormat,
}

pub(super) fn run(options: &Options, messages: &Messages) -> Status {
    let reading = match input::read(&options.scene, &options.format.options(), messages) {
        Ok(reading) => reading,
        Err(failure) => return failure.status,
    };
    let text = reading
        .scene
        .to_kdl(true, |texture| name_from(Path::new(""), texture));
    messages.result(&text, Status::Done)
}
