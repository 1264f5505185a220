//! Scenes as nodes that can be changed, and films that can be compared.

use std::path::{Path, PathBuf};

use heliodon::film::Film;
use heliodon::language::{Attribute, Node, Schema, Takes, Value, render_diagnostics};
use heliodon::read::{Options, read_bytes};
use heliodon::render::render;
use heliodon::scene::Scene;
use support::files::files;

/// The pictures' size in pixels.
pub(super) const SIZE: [u32; 2] = [64, 48];

/// A scene to be changed: everything that it says, every default spelled out.
#[derive(Debug, Clone)]
pub(super) struct Subject {
    /// What failures call it.
    pub(super) name: String,
    /// All of its nodes, in file order.
    pub(super) nodes: Vec<Node>,
}

/// What an attribute's value is told by.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// The node's kind.
    pub(super) node: &'static Schema,
    /// The attribute or property.
    pub(super) attribute: &'static Attribute,
}

impl Place {
    /// Whether the value is made of lengths: a point, a size, a distance.
    pub(super) fn is_length(self) -> bool {
        self.attribute.unit == "world units"
    }

    /// Whether the value is a point in the world.
    pub(super) fn is_point(self) -> bool {
        self.is_length() && self.attribute.takes == Takes::Triple
    }

    /// Whether the value is a point of the camera's.
    pub(super) fn is_of_camera(self) -> bool {
        self.is_point() && self.node.word == "camera"
    }

    /// Whether the value is a direction in the world; an ellipsoid's factors look like one.
    pub(super) fn is_direction(self) -> bool {
        self.attribute.is_direction() && self.attribute.word != "scale"
    }
}

impl Subject {
    /// The scene of a text that names files as those in `scenes` do.
    #[track_caller]
    pub(super) fn new(name: &str, text: &str) -> Self {
        Self::from_scene(name, &read(name, text, &Options::default()))
    }

    /// Every scene in `scenes`, as a picture of [`SIZE`].
    pub(super) fn all() -> Vec<Self> {
        let paths = files(folder(), "kdl");
        assert!(!paths.is_empty(), "the folder of scenes is empty");
        let options = Options {
            size: Some(SIZE),
            ..Options::default()
        };
        let subjects = paths.iter().map(|path| {
            let name = path.file_stem().unwrap().to_string_lossy();
            let text = std::fs::read_to_string(path).unwrap();
            Self::from_scene(&name, &read(&name, &text, &options))
        });
        subjects.collect()
    }

    fn from_scene(name: &str, scene: &Scene) -> Self {
        Self {
            name: name.to_owned(),
            nodes: scene.describe(),
        }
    }

    /// The same scene with every number changed that the closure changes.
    pub(super) fn changed(&self, mut change: impl FnMut(Place, &mut [f64])) -> Self {
        self.with_values(|place, value| match value {
            Value::Number(number) => change(place, std::slice::from_mut(number)),
            Value::Pair(numbers) => change(place, numbers),
            Value::Triple(numbers) => change(place, numbers),
            Value::Text(text) if matches!(place.attribute.takes, Takes::NumberOrPair(_)) => {
                let mut numbers: Vec<f64> = text
                    .split_whitespace()
                    .map(|word| word.parse().unwrap())
                    .collect();
                change(place, &mut numbers);
                *text = Value::Pair([numbers[0], numbers[1]]).to_string();
            }
            Value::Text(_) | Value::Flag(_) => {}
        })
    }

    /// The same scene with every value changed that the closure changes.
    pub(super) fn with_values(&self, mut change: impl FnMut(Place, &mut Value)) -> Self {
        let mut changed = self.clone();
        for node in &mut changed.nodes {
            let schema = node.schema;
            let mut change = |attribute, value: &mut Option<Value>| {
                let place = Place {
                    node: schema,
                    attribute,
                };
                value.iter_mut().for_each(|value| change(place, value));
            };
            for entry in node.properties.iter_mut().chain(&mut node.attributes) {
                change(entry.attribute, &mut entry.value);
                for property in &mut entry.properties {
                    change(property.attribute, &mut property.value);
                }
            }
        }
        changed
    }

    /// Whether some node of a kind has an attribute; with this text or this property, if one is given.
    pub(super) fn says(&self, node: &str, attribute: &str, text: Option<&str>) -> bool {
        let nodes = self.nodes.iter().filter(|found| found.schema.word == node);
        let mut entries = nodes.filter_map(|node| node.entry(attribute));
        entries.any(|entry| {
            let found = entry.value.as_ref().map_or("", Value::text);
            let property = |text| {
                entry
                    .properties
                    .iter()
                    .any(|own| own.attribute.word == text)
            };
            text.is_none_or(|text| text == found || property(text))
        })
    }

    /// The scene in KDL; a text that begins with `=` stands there without its quotes.
    pub(super) fn text(&self) -> String {
        let written: String = self.nodes.iter().map(Node::to_string).collect();
        let mut pieces = written.split("\"=");
        let mut text = pieces.next().unwrap_or_default().to_owned();
        for piece in pieces {
            text.push_str(&piece.replacen('"', "", 1));
        }
        text
    }

    /// The scene, read from its text.
    #[track_caller]
    pub(super) fn scene(&self) -> Scene {
        read(&self.name, &self.text(), &Options::default())
    }

    /// The scene's picture.
    #[track_caller]
    pub(super) fn film(&self) -> Film {
        film(&self.scene())
    }
}

/// A scene's picture.
pub(super) fn film(scene: &Scene) -> Film {
    render(scene, &|_| ()).unwrap().0
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes")
}

#[track_caller]
fn read(name: &str, text: &str, options: &Options) -> Scene {
    match read_bytes(name, text.into(), folder(), options) {
        Ok(reading) => reading.scene,
        Err(no) => panic!(
            "{name}\n{text}\n{}",
            render_diagnostics(&no.diagnostics, &no.sources, false, 100)
        ),
    }
}

/// Says how two films differ, if they do in a single bit.
pub(super) fn difference(title: &str, expected: &Film, found: &Film) -> Option<String> {
    let bits = |film: &Film, index: usize| film.pixels()[index].channels().map(f64::to_bits);
    differing(title, expected, found, |index| {
        bits(expected, index) != bits(found, index)
    })
}

/// How much of a colour may be rounding where hits are computed from other points of a plane.
const ROUNDING: f64 = 1e-12;

/// The first pixel in which two pictures differ by more than rounding, and how many do.
pub(super) fn difference_beyond_rounding(
    title: &str,
    expected: &Film,
    found: &Film,
) -> Option<String> {
    differing(title, expected, found, |index| {
        let [one, other] = [expected, found].map(|film| film.pixels()[index].channels());
        let mut channels = one.into_iter().zip(other);
        channels.any(|(one, other)| (one - other).abs() > ROUNDING * one.abs())
    })
}

fn differing(
    title: &str,
    expected: &Film,
    found: &Film,
    differs: impl Fn(usize) -> bool,
) -> Option<String> {
    assert_eq!(
        [expected.width(), expected.height()],
        [found.width(), found.height()],
        "{title}: the pictures' sizes"
    );
    let all = 0..expected.pixels().len();
    let unlike: Vec<_> = all.filter(|index| differs(*index)).collect();
    let first = *unlike.first()?;
    let (column, row) = (first % expected.width(), first / expected.width());
    let [expected, found] = [expected, found].map(|film| film.pixels()[first].channels());
    Some(format!(
        "{title}: {} pixels differ, the first in column {column}, row {row}: \
         {found:?} instead of {expected:?}",
        unlike.len()
    ))
}

/// Fails with all complaints, not only with the first.
#[track_caller]
pub(super) fn fail_on(complaints: impl IntoIterator<Item = String>) {
    let complaints: Vec<_> = complaints.into_iter().collect();
    let count = complaints.len();
    assert!(count == 0, "\n{}\n{count} in all\n", complaints.join("\n"));
}
