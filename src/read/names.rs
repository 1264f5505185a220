//! Names and what they stand for.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use super::{MOST_ERRORS, say};
use crate::language::{Location, Node, Problem, Reference, Takes, Value, did_you_mean};

/// The things of one kind that have names, in file order.
#[derive(Debug)]
pub(super) struct Names<T> {
    kind: &'static str,
    /// `None` for a thing that has a name but could not be made.
    known: HashMap<String, Option<Arc<T>>>,
}

impl<T> Names<T> {
    pub(super) fn new(kind: &'static str) -> Self {
        Self {
            kind,
            known: HashMap::new(),
        }
    }

    /// Gives a thing its name; it may be missing because it could not be made.
    pub(super) fn insert(&mut self, name: &str, thing: Option<Arc<T>>) {
        self.known.entry(name.to_owned()).or_insert(thing);
    }

    /// The thing that an attribute of a node names, if it could be made.
    pub(super) fn find(&self, node: &Node, word: &str) -> Option<Arc<T>> {
        self.known.get(&node.text(word))?.clone()
    }

    /// The problem if nothing has this name.
    fn missing(&self, name: &str, at: Location) -> Option<Problem> {
        if self.known.contains_key(name) {
            return None;
        }
        let kind = self.kind;
        let message = format!("there is no {kind} {}", say::quoted(name));
        let problem = Problem::error(at, message, format!("expected the name of a {kind}"));
        let mut names: Vec<_> = self.known.keys().map(String::as_str).collect();
        names.sort_unstable();
        Some(match did_you_mean(name, names.iter().copied()) {
            None if names.is_empty() => {
                problem.help(format!("the scene has no {kind} yet; add one"))
            }
            None => problem.help(format!("the scene has {}", say::names(&names))),
            suggestion => problem.suggest_name(suggestion),
        })
    }
}

/// Reports the names that stand for nothing, each once however often it is used.
pub(super) fn refuse_unknown(
    nodes: &[Node],
    textures: &Names<impl Sized>,
    materials: &Names<impl Sized>,
    problems: &mut Vec<Problem>,
) {
    let mut seen = HashSet::new();
    for entry in nodes.iter().flat_map(|node| &node.attributes) {
        let (Takes::Name(reference), Some(Value::Text(name)), Some(at)) =
            (entry.attribute.takes, &entry.value, entry.location)
        else {
            continue;
        };
        let first = seen.insert((reference.word(), name));
        // One that is not shown need not be explained.
        if first && problems.len() <= MOST_ERRORS {
            problems.extend(match reference {
                Reference::Texture => textures.missing(name, at),
                Reference::Material => materials.missing(name, at),
            });
        }
    }
}

/// Reports names that two nodes of one kind share.
pub(super) fn refuse_duplicates<'a>(
    nodes: impl IntoIterator<Item = &'a Node>,
    problems: &mut Vec<Problem>,
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
        problems.push(if here == there {
            Problem::error(at, message, "this file is included twice")
                .help("remove one of the includes")
        } else {
            Problem::error(at, message, format!("the first is at {there}"))
                .help("give one of them another name")
        });
    }
}
