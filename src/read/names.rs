//! Names of materials and textures, and references to them.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use super::errors::MOST_ERRORS;
use super::say;
use crate::language::{Diagnostic, Location, Node, Reference, Takes, Value, did_you_mean};

/// The parts of one kind by name.
#[derive(Debug)]
pub(super) struct Names<T> {
    kind: &'static str,
    /// `None` for a part with errors.
    known: HashMap<String, Option<Arc<T>>>,
}

impl<T> Names<T> {
    pub(super) fn new(kind: &'static str) -> Self {
        Self {
            kind,
            known: HashMap::new(),
        }
    }

    /// Adds a part, or `None` for one with errors. The first of equal names counts.
    pub(super) fn insert(&mut self, name: &str, part: Option<Arc<T>>) {
        self.known.entry(name.to_owned()).or_insert(part);
    }

    /// The part that an attribute names; `None` if it is missing or has errors.
    pub(super) fn find(&self, node: &Node, word: &str) -> Option<Arc<T>> {
        self.known.get(&node.text(word))?.clone()
    }

    /// The error for a name without a part.
    fn unknown(&self, name: &str, at: Location) -> Option<Diagnostic> {
        if self.known.contains_key(name) {
            return None;
        }
        let kind = self.kind;
        let message = format!("there is no {kind} {}", say::quoted(name));
        let error = Diagnostic::error(at, message, format!("expected the name of a {kind}"));
        let mut names: Vec<_> = self.known.keys().map(String::as_str).collect();
        names.sort_unstable();
        Some(match did_you_mean(name, names.iter().copied()) {
            None if names.is_empty() => error.help(format!("the scene has no {kind} yet; add one")),
            None => error.help(format!("the scene has {}", say::names(&names))),
            suggestion => error.suggest_name(suggestion),
        })
    }
}

/// Reports references to missing parts, each name once.
pub(super) fn check_references(
    nodes: &[Node],
    textures: &Names<impl Sized>,
    materials: &Names<impl Sized>,
    diagnostics: &mut Vec<Diagnostic>,
) {
    let mut checked = HashSet::new();
    for entry in nodes.iter().flat_map(|node| &node.attributes) {
        let (Takes::Name(reference), Some(Value::Text(name)), Some(at)) =
            (entry.attribute.takes, &entry.value, entry.location)
        else {
            continue;
        };
        let is_first = checked.insert((reference.word(), name));
        // Errors beyond the limit are not shown, and a suggestion takes time.
        if is_first && diagnostics.len() <= MOST_ERRORS {
            diagnostics.extend(match reference {
                Reference::Texture => textures.unknown(name, at),
                Reference::Material => materials.unknown(name, at),
            });
        }
    }
}

/// Reports equal names of nodes of one kind.
pub(super) fn check_unique<'a>(
    nodes: impl IntoIterator<Item = &'a Node>,
    diagnostics: &mut Vec<Diagnostic>,
    position: impl Fn(Location) -> String,
) {
    let mut first: HashMap<&str, Option<Location>> = HashMap::new();
    for node in nodes {
        let Some(name) = node.name.as_deref() else {
            continue;
        };
        let Some(earlier) = first.get(name) else {
            first.insert(name, node.location);
            continue;
        };
        let (Some(at), Some(earlier)) = (node.location, earlier) else {
            continue;
        };
        let message = format!("the name {} is given twice", say::quoted(name));
        let (here, there) = (position(at), position(*earlier));
        let (label, help) = if here == there {
            let label = "this file is included twice".to_owned();
            (label, "remove one of the includes")
        } else {
            let label = format!("the first is at {there}");
            (label, "give one of them another name")
        };
        diagnostics.push(Diagnostic::error(at, message, label).help(help));
    }
}
