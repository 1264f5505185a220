//! Which formats the command line leaves possible for a picture.

use std::path::Path;

use crate::film::{BitDepth, Format};

/// What the command line asks of all pictures.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Asked<'a> {
    /// The file, the folder, or the name with `{stem}`.
    pub(super) pattern: Option<&'a str>,
    /// The kind of picture.
    pub(super) format: Option<Format>,
    /// What its numbers are kept in.
    pub(super) depth: Option<BitDepth>,
}

impl Asked<'_> {
    /// The formats that are as asked for, and as the ending of a file's name says, which has to say it if
    /// nothing else does; one at least.
    ///
    /// # Errors
    /// Tells what contradicts what, or that a name says nothing.
    pub(super) fn formats(&self, path: Option<&Path>) -> Result<Vec<Format>, String> {
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
                return Err(format!(
                    "--format asks for a .{extension} file, but the output is {name}"
                ));
            }
            formats = vec![format];
        } else if path.is_some() && !is_named {
            return Err(format!(
                "the ending of {name:?} names no picture format; end it with .png, .ppm or .pfm, or \
                 give --format"
            ));
        }
        let Some(depth) = self.depth else {
            return Ok(formats);
        };
        formats.retain(|format| format.depth() == depth);
        if formats.is_empty() {
            return Err(self.contradiction(depth, &name));
        }
        Ok(formats)
    }

    /// Why a format or a name does not go with a depth.
    fn contradiction(&self, depth: BitDepth, name: &str) -> String {
        let word = depth.word();
        if let Some(format) = self.format {
            let other = format.depth().word();
            return format!(
                "--depth {word} contradicts --format, which asks for a depth of {other}; leave one \
                 of them out"
            );
        }
        let fitting = Format::ALL.iter().filter(|format| format.depth() == depth);
        let endings: Vec<_> = fitting.map(|it| format!(".{}", it.extension())).collect();
        format!(
            "{name} cannot have a depth of {word}; end it with {}, or ask for another --depth",
            endings.join(" or ")
        )
    }
}
