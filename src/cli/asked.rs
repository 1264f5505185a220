//! Formats that the command line leaves possible for a picture.

use std::path::Path;

use super::error::CommandError;
use crate::film::{BitDepth, Format};

/// Part of the command line that decides where pictures go and in which format.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Asked<'a> {
    /// The file, the folder, or the name with `{stem}`.
    pub(super) pattern: Option<&'a str>,
    pub(super) format: Option<Format>,
    pub(super) depth: Option<BitDepth>,
}

impl Asked<'_> {
    /// The formats, at least one, that agree with the options and with the ending of a file's name.
    ///
    /// # Errors
    /// Refuses options that contradict each other or the name, and a name that leaves the format
    /// open.
    pub(super) fn formats(&self, path: Option<&Path>) -> Result<Vec<Format>, CommandError> {
        let extension = path.and_then(|path| path.extension()?.to_str());
        let ends = |format: &Format| {
            extension.is_some_and(|it| it.eq_ignore_ascii_case(format.extension()))
        };
        let name = path.map_or(String::new(), |path| path.display().to_string());
        let mut formats = Format::ALL.to_vec();
        let is_named = formats.iter().any(ends);
        if is_named {
            formats.retain(ends);
        }
        if let Some(format) = self.format {
            if !formats.contains(&format) {
                let extension = format.extension();
                let reason =
                    format!("--format needs a .{extension} file, but the output is {name}");
                return Err(CommandError::usage(reason));
            }
            formats = vec![format];
        } else if path.is_some() && !is_named {
            return Err(CommandError::usage(format!(
                "the ending of {name:?} names no picture format; use .png, .ppm or .pfm, or give \
                 --format"
            )));
        }
        let Some(depth) = self.depth else {
            return Ok(formats);
        };
        formats.retain(|format| format.depth() == depth);
        if formats.is_empty() {
            return Err(CommandError::usage(self.contradiction(depth, &name)));
        }
        Ok(formats)
    }

    /// The contradiction between a depth and the format or the name.
    fn contradiction(&self, depth: BitDepth, name: &str) -> String {
        let word = depth.word();
        if let Some(format) = self.format {
            let other = format.depth().word();
            return format!(
                "--depth {word} contradicts --format, which has a depth of {other}; leave one of \
                 them out"
            );
        }
        let fitting = Format::ALL.iter().filter(|format| format.depth() == depth);
        let endings: Vec<_> = fitting.map(|it| format!(".{}", it.extension())).collect();
        format!(
            "{name} cannot have a depth of {word}; use the ending {}, or another --depth",
            endings.join(" or ")
        )
    }
}
