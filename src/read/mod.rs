//! Text to scene: two languages, one builder.

mod build;
mod check;
mod course;
mod entries;
mod files;
mod include;
mod kdl;
mod limits;
mod names;
mod pieces;
mod say;
mod surfaces;
mod syntax;
mod textures;
mod unknown;

use std::path::{Path, PathBuf};

use crate::language::{Problem, Schema, Severity, Source, Sources};
use crate::scene::{Scene, Setting};
use kdl::Nodes;

pub use files::{Files, bytes_from};

/// The most errors that are reported for one scene.
pub const MOST_ERRORS: usize = 20;

/// What the reader is told beside the text.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Options {
    /// The language; recognised by content if not given.
    pub language: Option<Language>,
    /// A picture size that replaces the scene's.
    pub size: Option<[u32; 2]>,
    /// What holds of the picture instead of what the scene says.
    pub settings: Vec<Setting>,
}

/// The languages that scenes are written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Language {
    /// KDL 2 in the chapter's words.
    Kdl,
    /// The course's old block grammar.
    Course,
}

/// A scene, and what is odd about its text.
#[derive(Debug)]
pub struct Reading {
    /// The scene.
    pub scene: Scene,
    /// The language it was written in.
    pub language: Language,
    /// What is odd but can be rendered.
    pub warnings: Vec<Problem>,
}

/// Why a text is not a scene.
#[derive(Debug)]
pub struct SceneError {
    /// The errors, at most [`MOST_ERRORS`], and the warnings.
    pub problems: Vec<Problem>,
    /// The texts that they point into.
    pub sources: Sources,
}

/// Every kind of node that a KDL scene file may hold.
pub fn schemas() -> impl Iterator<Item = &'static Schema> {
    Scene::schemas().chain([&include::INCLUDE])
}

/// Reads a scene file.
///
/// # Errors
/// The file system's error if the file cannot be read; a [`SceneError`] if it is not a scene.
pub fn read_file(path: &Path, options: &Options) -> std::io::Result<Result<Reading, SceneError>> {
    let bytes = files::bytes_of(path)?;
    let directory = path.parent().map(Path::to_owned).unwrap_or_default();
    Ok(read_bytes(
        &path.display().to_string(),
        bytes,
        directory,
        options,
    ))
}

/// Reads a scene from bytes; `name` is what messages call it, `directory` is where the files that
/// it names are looked for.
///
/// # Errors
/// All that is wrong with the text.
pub fn read_bytes(
    name: &str,
    bytes: Vec<u8>,
    directory: PathBuf,
    options: &Options,
) -> Result<Reading, SceneError> {
    let mut problems = Vec::new();
    let mut files = Files::default();
    let is_picture = image::guess_format(&bytes).is_ok();
    let text = files::text_of(bytes);
    let language = options
        .language
        .unwrap_or_else(|| Language::of(text.as_deref().unwrap_or("")));
    let directories = match language {
        Language::Kdl => vec![directory],
        // Old scenes name their textures from wherever the program was started.
        Language::Course => vec![directory, PathBuf::new()],
    };
    let source = Source {
        name: name.to_owned(),
        text: text.as_deref().unwrap_or("").into(),
        included_at: None,
    };
    let source = files.add(source, directories);
    if let Err(line) = text {
        return Err(SceneError {
            problems: vec![no_text(name, line, is_picture)],
            sources: files.into_sources(),
        });
    }
    let Nodes { nodes, complete } = match language {
        Language::Kdl => kdl::read(source, &mut files, &mut problems),
        Language::Course => Nodes {
            nodes: course::read(source, &files, &mut problems),
            complete: true,
        },
    };
    let built = build::scene(&nodes, complete, options, files, &mut problems);
    // In the order of the text, whoever found them; what lacks in the whole text comes last.
    problems.sort_by_key(|problem| {
        let place = problem.place.as_ref();
        place.map(|(at, _)| (at.length == 0, at.source, at.start))
    });
    let (errors, warnings): (Vec<_>, Vec<_>) = problems
        .into_iter()
        .partition(|problem| problem.severity == Severity::Error);
    match built {
        Ok(scene) if errors.is_empty() => Ok(Reading {
            scene,
            language,
            warnings,
        }),
        Ok(Scene { sources, .. }) | Err(sources) => Err(SceneError {
            problems: limited(errors, warnings),
            sources,
        }),
    }
}

/// What is wrong with bytes of which those in this line are no text.
fn no_text(name: &str, line: usize, is_picture: bool) -> Problem {
    let (message, help) = if is_picture {
        (format!("{name} is a picture, not a scene"), None)
    } else {
        let help = "save it as UTF-8, if it is a scene file";
        let message = format!("{name} is not a text: line {line} is not UTF-8");
        (message, Some(help.to_owned()))
    };
    Problem {
        message,
        help,
        ..no_place()
    }
}

/// The first errors and all warnings, with a last word on how many there were.
fn limited(mut errors: Vec<Problem>, warnings: Vec<Problem>) -> Vec<Problem> {
    if errors.len() > MOST_ERRORS {
        let more = errors.len() - MOST_ERRORS;
        errors.truncate(MOST_ERRORS);
        errors.push(Problem {
            message: match more {
                1 => "1 more error is not shown".to_owned(),
                more => format!("{more} more errors are not shown"),
            },
            help: Some("mend the first ones and look again".to_owned()),
            ..no_place()
        });
    }
    errors.into_iter().chain(warnings).collect()
}

fn no_place() -> Problem {
    Problem {
        severity: Severity::Error,
        message: String::new(),
        place: None,
        help: None,
    }
}

impl Language {
    /// The language of a text: the course's camera and entities have words that KDL scenes lack.
    #[must_use]
    pub fn of(text: &str) -> Self {
        if course::looks_like(text) {
            Self::Course
        } else {
            Self::Kdl
        }
    }
}
