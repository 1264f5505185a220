//! Where pictures go, decided for all scenes before the first is rendered.

use std::collections::HashMap;
use std::io::{ErrorKind, IsTerminal};
use std::path::{Path, PathBuf};

use super::Status;
use super::input::DASH;
use crate::film::Format;

/// Where one scene's picture goes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Output {
    /// The file; `None` for standard output.
    pub(super) path: Option<PathBuf>,
    /// The kind of picture.
    pub(super) format: Format,
}

impl Output {
    /// What messages call the place.
    pub(super) fn title(&self) -> String {
        let path = self.path.as_ref();
        path.map_or("stdout".to_owned(), |path| path.display().to_string())
    }
}

/// Why there is no place for a picture.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Refused {
    pub(super) status: Status,
    pub(super) reason: String,
}

fn usage(reason: impl Into<String>) -> Refused {
    Refused {
        status: Status::Usage,
        reason: reason.into(),
    }
}

/// The outputs of a list of scenes, in their order.
///
/// # Errors
/// If two pictures would go to one file, a picture would replace a scene, the format cannot be
/// told, or a folder is missing.
pub(super) fn plan(
    scenes: &[PathBuf],
    pattern: Option<&str>,
    format: Option<Format>,
) -> Result<Vec<Output>, Refused> {
    if pattern == Some(DASH) {
        return to_standard_output(scenes, format);
    }
    let mut outputs = Vec::new();
    let mut taken: HashMap<PathBuf, &Path> = HashMap::new();
    for scene in scenes {
        let output = output(scene, pattern, format)?;
        let Some(path) = &output.path else { continue };
        let place = place(path)?;
        if scenes
            .iter()
            .any(|scene| scene.canonicalize().is_ok_and(|scene| scene == place))
        {
            let reason = format!("the picture {} would replace a scene", path.display());
            return Err(usage(reason));
        }
        if let Some(other) = taken.insert(place, scene) {
            return Err(usage(format!(
                "{} and {} would both be written to {}; put {{stem}} into the output's name",
                other.display(),
                scene.display(),
                path.display(),
            )));
        }
        outputs.push(output);
    }
    Ok(outputs)
}

fn to_standard_output(scenes: &[PathBuf], format: Option<Format>) -> Result<Vec<Output>, Refused> {
    if scenes.len() > 1 {
        return Err(usage("only one picture can go to standard output"));
    }
    if std::io::stdout().is_terminal() {
        return Err(usage(
            "a terminal cannot show a picture; send standard output to a file",
        ));
    }
    Ok(vec![Output {
        path: None,
        format: format.unwrap_or(Format::Png8),
    }])
}

fn output(scene: &Path, pattern: Option<&str>, format: Option<Format>) -> Result<Output, Refused> {
    let stem = if scene.as_os_str() == DASH {
        "stdin".into()
    } else {
        scene
            .file_stem()
            .unwrap_or(scene.as_os_str())
            .to_string_lossy()
    };
    let extension = format.unwrap_or(Format::Png8).extension();
    let path = match pattern {
        None => PathBuf::from(format!("{stem}.{extension}")),
        Some(pattern) => {
            let path = PathBuf::from(filled(pattern, &stem)?);
            let folder = path.is_dir() || pattern.ends_with(std::path::MAIN_SEPARATOR);
            if folder {
                path.join(format!("{stem}.{extension}"))
            } else {
                path
            }
        }
    };
    let meant = Format::of(&path);
    let contradicts = |format: Format| meant.is_some_and(|m| m.extension() != format.extension());
    if let Some(format) = format.filter(|format| contradicts(*format)) {
        return Err(usage(format!(
            "--format asks for a .{} file, but the output is {}",
            format.extension(),
            path.display()
        )));
    }
    let format = format.or(meant).ok_or_else(|| {
        usage(format!(
            "the ending of {:?} names no picture format; end it with .png, .ppm or .pfm, \
             or give --format",
            path.display().to_string()
        ))
    })?;
    Ok(Output {
        path: Some(path),
        format,
    })
}

/// The pattern with `{stem}` replaced; other words in braces are mistakes.
fn filled(pattern: &str, stem: &str) -> Result<String, Refused> {
    let mut text = String::new();
    let mut rest = pattern;
    while let Some(open) = rest.find('{') {
        let (before, from_brace) = rest.split_at(open);
        let Some(close) = from_brace.find('}') else {
            break;
        };
        let word = &from_brace[1..close];
        if word != "stem" {
            let reason = format!("{{{word}}} in the output's name is unknown; {{stem}} is known");
            return Err(usage(reason));
        }
        text += before;
        text += stem;
        rest = &from_brace[close + 1..];
    }
    Ok(text + rest)
}

/// The one true path of a file that may not exist yet; its folder must.
fn place(path: &Path) -> Result<PathBuf, Refused> {
    if let Ok(place) = path.canonicalize() {
        return Ok(place);
    }
    let parent = path
        .parent()
        .filter(|parent| !parent.as_os_str().is_empty());
    let folder = parent.unwrap_or(Path::new("."));
    let place = folder.canonicalize().map_err(|error| Refused {
        status: Status::Io,
        reason: match error.kind() {
            ErrorKind::NotFound => format!("there is no folder {}", folder.display()),
            _ => format!("cannot write {}: {error}", path.display()),
        },
    })?;
    Ok(place.join(path.file_name().unwrap_or_default()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn planned(scenes: &[&str], pattern: Option<&str>) -> Result<Vec<String>, String> {
        let scenes: Vec<_> = scenes.iter().map(PathBuf::from).collect();
        let outputs = plan(&scenes, pattern, None).map_err(|refused| refused.reason)?;
        let paths = outputs.into_iter().filter_map(|output| output.path);
        Ok(paths.map(|path| path.display().to_string()).collect())
    }

    #[test]
    fn the_default_is_the_scenes_stem_here() {
        assert_eq!(
            planned(&["deep/room.kdl", "-"], None).unwrap(),
            ["room.png", "stdin.png"]
        );
    }

    #[test]
    fn the_stem_is_filled_in() {
        assert_eq!(
            planned(&["a.kdl", "b.kdl"], Some("{stem}-x.ppm")).unwrap(),
            ["a-x.ppm", "b-x.ppm"]
        );
        assert!(
            planned(&["a.kdl"], Some("{step}.png"))
                .unwrap_err()
                .contains("{step}")
        );
    }

    #[test]
    fn one_file_is_not_written_twice() {
        let error = planned(&["a/room.kdl", "b/room.kdl"], None).unwrap_err();
        assert!(error.contains("both be written to room.png"), "{error}");
        assert!(planned(&["a.kdl", "b.kdl"], Some("./x.png")).is_err());
    }

    #[test]
    fn a_scene_is_not_overwritten_and_folders_must_exist() {
        assert!(planned(&["Cargo.toml"], Some("Cargo.toml")).is_err());
        assert!(planned(&["a.kdl"], Some("no-such-folder/a.png")).is_err());
        assert!(
            planned(&["a.kdl"], Some("a.gif"))
                .unwrap_err()
                .contains(".png, .ppm or .pfm")
        );
    }
}
