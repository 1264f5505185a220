//! `SamplePositions` of pictures, decided for all scenes before the first is rendered.

use std::collections::HashMap;
use std::io::{ErrorKind, IsTerminal};
use std::path::{MAIN_SEPARATOR, Path, PathBuf};

use super::asked::Asked;
use super::error::CommandError;
use super::input::{DASH, title};
use crate::film::{BitDepth, Format};

/// The place of one scene's picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Output {
    /// The file; `None` for standard output.
    pub(super) path: Option<PathBuf>,
    pub(super) format: Format,
}

impl Output {
    /// The place's name in messages.
    pub(super) fn title(&self) -> String {
        let path = self.path.as_ref();
        path.map_or("stdout".to_owned(), |path| path.display().to_string())
    }
}

/// The outputs that the command line leaves possible for one scene; the scene's depth chooses.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Outputs {
    /// At least one; of those with the same depth, the usual one first.
    formats: Vec<Format>,
    /// The file; `None` for standard output.
    path: Option<PathBuf>,
    /// True if the format's ending is added to the path.
    is_stem: bool,
}

impl Outputs {
    /// The output for a picture of this depth, or the usual one if no format has it.
    pub(super) fn of_depth(&self, depth: BitDepth) -> Output {
        let mut formats = self.formats.iter();
        let fitting = formats.find(|format| format.depth() == depth);
        let format = *fitting.unwrap_or(&self.formats[0]);
        let mut path = self.path.clone();
        if let Some(path) = path.as_mut().filter(|_| self.is_stem) {
            path.as_mut_os_string().push(".");
            path.as_mut_os_string().push(format.extension());
        }
        Output { path, format }
    }
}

/// The outputs of a list of scenes, in their order.
///
/// # Errors
/// Refuses two pictures in one file, a picture in place of a scene, an unknown format, options that
/// contradict each other, and a missing folder.
pub(super) fn plan(scenes: &[PathBuf], asked: Asked<'_>) -> Result<Vec<Outputs>, CommandError> {
    if asked.pattern == Some(DASH) {
        return to_standard_output(scenes, asked);
    }
    let mut all = Vec::new();
    let mut taken: HashMap<PathBuf, usize> = HashMap::new();
    for (number, scene) in scenes.iter().enumerate() {
        let outputs = outputs(scene, asked)?;
        let possible = BitDepth::ALL.map(|depth| outputs.of_depth(depth));
        for path in possible.into_iter().filter_map(|output| output.path) {
            let place = place(&path)?;
            let is_place = |scene: &PathBuf| scene.canonicalize().is_ok_and(|it| it == place);
            let name = path.display();
            if scenes.iter().any(is_place) {
                let reason = format!("a picture {name} would replace a scene");
                return Err(CommandError::usage(reason));
            }
            let other = taken.insert(place, number).filter(|other| *other != number);
            if let Some(other) = other {
                let [one, other] = [scene, &scenes[other]].map(|scene| scene.display());
                return Err(CommandError::usage(format!(
                    "{other} and {one} would both be written to {name}; put {{stem}} into the \
                     output's name"
                )));
            }
        }
        all.push(outputs);
    }
    Ok(all)
}

fn to_standard_output(scenes: &[PathBuf], asked: Asked<'_>) -> Result<Vec<Outputs>, CommandError> {
    if scenes.len() > 1 {
        let reason = "only one picture can go to standard output";
        return Err(CommandError::usage(reason));
    }
    if std::io::stdout().is_terminal() {
        let reason = "a terminal cannot show a picture; redirect standard output to a file";
        return Err(CommandError::usage(reason));
    }
    Ok(vec![Outputs {
        formats: asked.formats(None)?,
        path: None,
        is_stem: false,
    }])
}

fn outputs(scene: &Path, asked: Asked<'_>) -> Result<Outputs, CommandError> {
    let stem = match scene.file_stem() {
        Some(stem) if scene.as_os_str() != DASH => stem.to_string_lossy().into_owned(),
        _ => title(scene),
    };
    let pattern = asked.pattern.unwrap_or_default();
    let path = PathBuf::from(filled(pattern, &stem)?);
    let is_stem = asked.pattern.is_none() || path.is_dir() || pattern.ends_with(MAIN_SEPARATOR);
    let formats = asked.formats(Some(&path).filter(|_| !is_stem).map(PathBuf::as_path))?;
    let path = Some(if is_stem { path.join(stem) } else { path });
    Ok(Outputs {
        formats,
        path,
        is_stem,
    })
}

/// The pattern with `{stem}` replaced.
///
/// # Errors
/// Refuses other words in braces.
fn filled(pattern: &str, stem: &str) -> Result<String, CommandError> {
    let mut text = String::new();
    let mut rest = pattern;
    while let Some(open) = rest.find('{') {
        let (before, from_brace) = rest.split_at(open);
        let Some(close) = from_brace.find('}') else {
            break;
        };
        let word = &from_brace[1..close];
        if word != "stem" {
            return Err(CommandError::usage(format!(
                "{{{word}}} in the output's name is unknown; only {{stem}} is known"
            )));
        }
        text += before;
        text += stem;
        rest = &from_brace[close + 1..];
    }
    Ok(text + rest)
}

/// The canonical path of a file that need not exist; its folder must.
pub(super) fn place(path: &Path) -> Result<PathBuf, CommandError> {
    if let Ok(place) = path.canonicalize() {
        return Ok(place);
    }
    let parent = path.parent();
    let parent = parent.filter(|parent| !parent.as_os_str().is_empty());
    let folder = parent.unwrap_or(Path::new("."));
    let place = folder.canonicalize().map_err(|error| match error.kind() {
        ErrorKind::NotFound => CommandError::io(format!("there is no folder {}", folder.display())),
        _ => CommandError::write(path.display(), error),
    })?;
    Ok(place.join(path.file_name().unwrap_or_default()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(scenes: &[&str], asked: Asked<'_>, depth: BitDepth) -> Result<Vec<String>, String> {
        let scenes: Vec<_> = scenes.iter().map(PathBuf::from).collect();
        let all = plan(&scenes, asked).map_err(|error| format!("{error:?}"))?;
        let outputs = all.iter().map(|outputs| outputs.of_depth(depth));
        let named = outputs.map(|output| format!("{} {:?}", output.title(), output.format));
        Ok(named.collect())
    }

    fn planned(scenes: &[&str], pattern: Option<&str>) -> Result<Vec<String>, String> {
        let asked = Asked {
            pattern,
            ..Asked::default()
        };
        named(scenes, asked, BitDepth::Eight)
    }

    #[test]
    fn the_default_is_the_scenes_stem_here() {
        assert_eq!(
            planned(&["deep/room.kdl", "-"], None).unwrap(),
            ["room.png Png8", "stdin.png Png8"]
        );
    }

    #[test]
    fn the_stem_is_filled_in() {
        assert_eq!(
            planned(&["a.kdl", "b.kdl"], Some("{stem}-x.ppm")).unwrap(),
            ["a-x.ppm Ppm", "b-x.ppm Ppm"]
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
        assert!(planned(&["a.kdl", "a.kdl"], None).is_err());
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

    /// What a scene of each depth becomes, or why nothing.
    fn by_depth(
        pattern: Option<&str>,
        format: Option<Format>,
        depth: Option<BitDepth>,
    ) -> Result<Vec<String>, String> {
        let asked = Asked {
            pattern,
            format,
            depth,
        };
        let of = |depth| Ok(named(&["a.kdl"], asked, depth)?.concat());
        BitDepth::ALL.into_iter().map(of).collect()
    }

    #[test]
    fn the_scenes_depth_chooses_what_the_command_line_leaves_open() {
        for (pattern, format, expected) in [
            (None, None, ["a.png Png8", "a.png Png16", "a.pfm Pfm"]),
            (
                Some("x.PNG"),
                None,
                ["x.PNG Png8", "x.PNG Png16", "x.PNG Png8"],
            ),
            (Some("x.ppm"), None, ["x.ppm Ppm"; 3]),
            (Some("x.pfm"), None, ["x.pfm Pfm"; 3]),
            (None, Some(Format::Png8), ["a.png Png8"; 3]),
            (None, Some(Format::Png16), ["a.png Png16"; 3]),
            (None, Some(Format::Ppm), ["a.ppm Ppm"; 3]),
            (None, Some(Format::Pfm), ["a.pfm Pfm"; 3]),
            (Some("x"), Some(Format::Pfm), ["x Pfm"; 3]),
        ] {
            let all = by_depth(pattern, format, None).unwrap();
            assert_eq!(all, expected, "{pattern:?} {format:?}");
        }
        let folder = by_depth(Some("src"), None, None).unwrap();
        assert_eq!(
            folder,
            ["src/a.png Png8", "src/a.png Png16", "src/a.pfm Pfm"]
        );
    }

    #[test]
    fn a_depth_that_is_asked_for_is_kept_or_refused() {
        let (eight, sixteen, float) = (BitDepth::Eight, BitDepth::Sixteen, BitDepth::Float);
        for (pattern, format, depth, expected) in [
            (None, None, eight, "a.png Png8"),
            (None, None, sixteen, "a.png Png16"),
            (None, None, float, "a.pfm Pfm"),
            (Some("x.png"), None, eight, "x.png Png8"),
            (Some("x.png"), None, sixteen, "x.png Png16"),
            (Some("x.ppm"), None, eight, "x.ppm Ppm"),
            (Some("x.pfm"), None, float, "x.pfm Pfm"),
            (None, Some(Format::Ppm), eight, "a.ppm Ppm"),
            (Some("x"), Some(Format::Png16), sixteen, "x Png16"),
        ] {
            let all = by_depth(pattern, format, Some(depth)).unwrap();
            assert_eq!(all, [expected; 3], "{pattern:?} {format:?} {depth:?}");
        }
        for (pattern, depth, expected) in [
            (
                "x.png",
                float,
                "x.png cannot have a depth of float; use the ending .pfm,",
            ),
            (
                "x.ppm",
                sixteen,
                "x.ppm cannot have a depth of 16; use the ending .png,",
            ),
            ("x.ppm", float, "use the ending .pfm,"),
            ("x.pfm", eight, "use the ending .png or .ppm,"),
            ("x.pfm", sixteen, "use the ending .png,"),
            ("x", sixteen, "names no picture format"),
        ] {
            let error = by_depth(Some(pattern), None, Some(depth)).unwrap_err();
            assert!(error.contains(expected), "{error}");
        }
        for format in Format::ALL {
            for depth in BitDepth::ALL.into_iter().filter(|it| *it != format.depth()) {
                let error = by_depth(None, Some(format), Some(depth)).unwrap_err();
                let other = format.depth().word();
                let expected = format!("contradicts --format, which has a depth of {other};");
                assert!(error.contains(&expected), "{error}");
            }
        }
    }
}
