//! Scene files that scene files include.

use std::io::ErrorKind;
use std::path::Path;

use super::Language;
use super::files::{self, Files, nearby};
use crate::language::{Attribute, Location, Naming, Node, Problem, Schema, Source, Takes, Value};

/// The `include` node, which only files have.
pub(crate) const INCLUDE: Schema = Schema {
    word: "include",
    about: "Another scene file, whose nodes take this node's place.",
    naming: Naming::None,
    value: Some(&Attribute::new(
        "file",
        Takes::Path,
        "a KDL file, relative to this file",
    )),
    properties: &[],
    attributes: &[],
};

/// The most files that one scene may consist of; files that include one another twice over would
/// otherwise never end.
const MOST_FILES: usize = 1000;

/// The text that an `include` node names, as one more of the files.
pub(super) fn open(node: &Node, files: &mut Files) -> Result<usize, Option<Problem>> {
    let (Some(at), Some(Value::Text(file))) = (node.location, &node.value) else {
        return Err(None);
    };
    let path = files.locate(at.source, file);
    let source = source(&path, at, files)?;
    let directory = path.parent().map(Path::to_owned).unwrap_or_default();
    Ok(files.add(source, vec![directory]))
}

/// The text of an included file, if it is not part of the chain of files that includes it.
fn source(path: &Path, at: Location, files: &Files) -> Result<Source, Problem> {
    let name = path.display();
    let error = |message: String, label: &str| Problem::error(at, message, label);
    if files.is_within(at.source, path) {
        let message = format!("{name} includes itself");
        let problem = error(message, "this include closes the circle");
        return Err(problem.help("remove one of the includes of the circle"));
    }
    if files.sources().len() >= MOST_FILES {
        let message = format!("the scene consists of more than {MOST_FILES} files");
        let problem = error(message, "this include is one too many");
        return Err(problem.help("do two files include the same ones again and again?"));
    }
    let bytes = files::bytes_of(path).map_err(|reason| {
        if reason.kind() == ErrorKind::NotFound {
            return error(format!("there is no file {name}"), "expected a scene file").help(
                nearby(
                    path,
                    "file names are relative to the file that says `include`",
                ),
            );
        }
        let reason = files::reason(path, &reason);
        error(
            format!("cannot read {name}: {reason}"),
            "expected a scene file",
        )
        .help("name a file that you may read")
    })?;
    let text = files::text_of(bytes).map_err(|line| {
        let message = format!("{name} is not a text: line {line} is not UTF-8");
        error(message, "expected a scene file").help("save it as UTF-8, if it is a scene file")
    })?;
    if Language::of(&text) == Language::Course {
        let message = format!("{name} is written in the course's block grammar");
        let problem = error(message, "expected a KDL file");
        return Err(problem.help("rewrite it with `heliodon convert` and include that"));
    }
    Ok(Source {
        name: name.to_string(),
        text: text.into(),
        included_at: Some(at),
    })
}
