//! `heliodon dump`.

use std::path::Path;

use clap::Args;

use super::messages::Messages;
use super::{Status, convert::name_from, input};

/// Prints the resolved scene as KDL, every include inserted and every default spelled out.
///
/// This is the chapter's `dump_obj`; what it prints renders to the same picture.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    input: input::OneScene,
}

pub(super) fn run(options: &Options, messages: &Messages) -> Status {
    let reading = match options.input.read(messages) {
        Ok(reading) => reading,
        Err(failure) => return failure.status,
    };
    let text = reading
        .scene
        .to_kdl(true, |texture| name_from(Path::new(""), texture));
    messages.result(&text, Status::Done)
}
