//! `heliodon dump`.

use std::path::Path;

use clap::Args;

use super::messages::Messages;
use super::{Status, convert::name_from, input};

/// Print the resolved scene as KDL, with includes inserted and defaults spelled out.
///
/// This is the chapter's `dump_obj`. The printed scene renders to the same picture.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    input: input::OneScene,
}

pub(super) fn run(options: &Options, messages: &Messages) -> Status {
    let text = options.input.read(messages).map(|reading| {
        let name = |texture: &_| name_from(Path::new(""), texture);
        (reading.scene.to_kdl(true, name), Status::Done)
    });
    messages.finish(&options.input.scene, false, text)
}
