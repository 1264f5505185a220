//! The case files, read.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use kdl::{KdlDocument, KdlNode, KdlValue};

/// The groups in the order of the catalogue, and how many cases each has.
pub(crate) const GROUPS: [(&str, u32); 9] = [
    ("a-plane", 13),
    ("b-edges", 20),
    ("c-input", 13),
    ("d-textures", 15),
    ("e-shadows", 13),
    ("f-mirrors", 8),
    ("g-round", 10),
    ("h-output", 8),
    ("i-scheduling", 8),
];

/// One hard case.
#[derive(Debug)]
pub(crate) struct Case {
    /// Its number, such as `B4`.
    pub(crate) id: String,
    /// What is asked, in words.
    pub(crate) title: String,
    /// What goes wrong with it in most programs.
    pub(crate) why: String,
    /// The truth in words.
    pub(crate) truth: String,
    /// What else there is to say.
    pub(crate) remark: Option<String>,
    /// The scenes by name; the first one is meant where no name is given.
    scenes: Vec<(String, String)>,
    /// What is asked of them.
    pub(crate) questions: Vec<Node>,
}

/// A node with every value as text.
#[derive(Debug, Clone)]
pub(crate) struct Node {
    /// What it is.
    pub(crate) word: String,
    /// What stands after the word.
    pub(crate) values: Vec<String>,
    /// The `key=value` entries.
    pub(crate) properties: Vec<(String, String)>,
    /// The nodes between its braces.
    pub(crate) children: Vec<Self>,
}

impl Node {
    fn from_kdl(node: &KdlNode) -> Self {
        let (named, plain): (Vec<_>, Vec<_>) = node
            .entries()
            .iter()
            .partition(|entry| entry.name().is_some());
        Self {
            word: node.name().value().to_owned(),
            values: plain.iter().map(|entry| text(entry.value())).collect(),
            properties: named
                .iter()
                .map(|entry| {
                    let name = entry.name().map_or("", |name| name.value());
                    (name.to_owned(), text(entry.value()))
                })
                .collect(),
            children: node
                .children()
                .map(|children| children.nodes().iter().map(Self::from_kdl).collect())
                .unwrap_or_default(),
        }
    }

    /// The value of a property, if it is given.
    pub(crate) fn get(&self, property: &str) -> Option<&str> {
        let found = self.properties.iter().find(|(name, _)| name == property);
        found.map(|(_, value)| value.as_str())
    }

    /// The whole number that a property gives.
    pub(crate) fn number<T: std::str::FromStr>(&self, property: &str) -> Option<T> {
        self.get(property).map(|value| {
            let number = value.parse().ok();
            number.unwrap_or_else(|| panic!("{property}={value} is not a whole number"))
        })
    }

    /// The only value.
    pub(crate) fn value(&self) -> &str {
        match self.values.as_slice() {
            [value] => value,
            other => panic!("`{}` has {} values, expected one", self.word, other.len()),
        }
    }

    /// The children with this word.
    pub(crate) fn all<'a>(&'a self, word: &'a str) -> impl Iterator<Item = &'a Self> {
        self.children.iter().filter(move |child| child.word == word)
    }
}

fn text(value: &KdlValue) -> String {
    match value {
        KdlValue::String(text) => text.clone(),
        KdlValue::Integer(number) => number.to_string(),
        KdlValue::Bool(flag) => flag.to_string(),
        other => panic!("{other}: numbers with a point or an exponent stand in quotes"),
    }
}

impl Case {
    fn from_node(node: Node) -> Self {
        let id = node.value().to_owned();
        let one = |word: &str| {
            let mut found = node.all(word).map(|child| child.value().to_owned());
            let first = found.next();
            assert!(found.next().is_none(), "{id} has two of `{word}`");
            first
        };
        let required = |word: &str| one(word).unwrap_or_else(|| panic!("{id} has no `{word}`"));
        let scenes = node
            .all("scene")
            .map(|scene| match scene.values.as_slice() {
                [text] => (String::new(), text.clone()),
                [name, text] => (name.clone(), text.clone()),
                other => panic!("{id}: a scene with {} values", other.len()),
            });
        const ABOUT: [&str; 5] = ["title", "why", "truth", "remark", "scene"];
        Self {
            title: required("title"),
            why: required("why"),
            truth: required("truth"),
            remark: one("remark"),
            scenes: scenes.collect(),
            questions: {
                let children = node.children.iter();
                let questions = children.filter(|child| !ABOUT.contains(&child.word.as_str()));
                questions.cloned().collect()
            },
            id,
        }
    }

    /// The text of the scene that a question is about.
    pub(crate) fn scene(&self, name: Option<&str>) -> &str {
        let found = match name {
            None => self.scenes.first(),
            Some(name) => self.scenes.iter().find(|(known, _)| known == name),
        };
        &found
            .unwrap_or_else(|| panic!("there is no scene {name:?}"))
            .1
    }
}

/// The folder of the case files.
pub(crate) fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/hard_cases")
}

/// Whether a case file was rewritten.
pub(crate) static REWRITTEN: AtomicBool = AtomicBool::new(false);

/// Replaces a text in the case files.
pub(crate) fn replace(old: &str, new: &str) {
    for (file, _) in GROUPS {
        let file = folder().join(file).with_extension("kdl");
        let text = fs::read_to_string(&file).unwrap();
        if text.contains(old) {
            fs::write(&file, text.replace(old, new)).unwrap();
            REWRITTEN.store(true, Ordering::Relaxed);
        }
    }
}

/// All cases, in the order of the catalogue.
pub(crate) fn all() -> Vec<Case> {
    let files = GROUPS
        .iter()
        .map(|(file, _)| folder().join(file).with_extension("kdl"));
    let cases = files.flat_map(|file| {
        let text =
            fs::read_to_string(&file).unwrap_or_else(|no| panic!("{}: {no}", file.display()));
        let document: KdlDocument = text
            .parse()
            .unwrap_or_else(|no| panic!("{}: {no:?}", file.display()));
        let nodes = document.nodes().iter().map(Node::from_kdl);
        nodes.map(Case::from_node).collect::<Vec<_>>()
    });
    cases.collect()
}
