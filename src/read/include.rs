//! Included scene files.

use std::io::ErrorKind;
use std::path::Path;

use super::files::{self, Files, nearby};
use super::options::Language;
use crate::language::{Diagnostic, Location, Node, Source, Value};

/// The most files of one scene.
///
/// Without a limit, files that include each other twice would take exponential time.
const MOST_FILES: usize = 1000;

/// Adds the text of an `include` node to the files.
pub(super) fn open(node: &Node, files: &mut Files) -> Result<usize, Option<Diagnostic>> {
    let (Some(at), Some(Value::Text(file))) = (node.location, &node.value) else {
        return Err(None);
    };
    let path = files.locate(at.source, file);
    let source = source(&path, at, files)?;
    let directory = path.parent().map(Path::to_owned).unwrap_or_default();
    Ok(files.add(source, vec![directory]))
}

/// The text of an included file that does not include itself.
fn source(path: &Path, at: Location, files: &Files) -> Result<Source, Diagnostic> {
    let name = path.display().to_string();
    let error =
        |message: String, label: &str, help: &str| Diagnostic::error(at, message, label).help(help);
    if files.is_within(at.source, path) {
        let message = format!("include cycle: {name} includes itself");
        let help = "remove one of the includes of the cycle";
        return Err(error(message, "this include closes the cycle", help));
    }
    if files.sources().len() >= MOST_FILES {
        let message = format!("the scene has more than {MOST_FILES} files");
        let help = "check for files that include the same file more than once";
        return Err(error(message, "this include exceeds the limit", help));
    }
    let bytes = files::bytes_of(path).map_err(|io_error| {
        let (message, help) = if io_error.kind() == ErrorKind::NotFound {
            let advice = "file names are relative to the file with the `include`";
            (format!("there is no file {name}"), nearby(path, advice))
        } else {
            let reason = files::reason(path, &io_error);
            let message = format!("cannot read {name}: {reason}");
            (message, "name a file that you may read".to_owned())
        };
        error(message, "expected a scene file", &help)
    })?;
    let text = files::text_of(bytes).map_err(|line| {
        let message = files::not_utf8(&name, line);
        error(message, "expected a scene file", files::SAVE_AS_UTF8)
    })?;
    if Language::of(&text) == Language::Course {
        let message = format!("{name} is written in the course's block grammar");
        let help = "convert it with `heliodon convert`, and include the result";
        return Err(error(message, "expected a KDL file", help));
    }
    Ok(Source {
        name,
        text: text.into(),
        included_at: Some(at),
    })
}
