//! Names and what they stand for.

use std::collections::HashMap;
use std::sync::Arc;

use crate::language::{Location, Node, Problem, did_you_mean};

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

    /// The thing that an attribute of a node names.
    ///
    /// `None` if there is none; that is a problem, unless it is one already.
    pub(super) fn find(
        &self,
        node: &Node,
        word: &str,
        problems: &mut Vec<Problem>,
    ) -> Option<Arc<T>> {
        let name = node.text(word);
        if let Some(thing) = self.known.get(&name) {
            return thing.clone();
        }
        let kind = self.kind;
        if let Some(at) = node.place(word) {
            let mut names: Vec<_> = self.known.keys().map(String::as_str).collect();
            names.sort_unstable();
            let suggestion = did_you_mean(&name, names.iter().copied());
            let label = format!("expected the name of a {kind}");
            let problem = Problem::error(at, format!("there is no {kind} {name:?}"), label);
            problems.push(match (suggestion, names.as_slice()) {
                (None, []) => problem.help(format!("the scene has no {kind} yet; add one")),
                (None, names) => problem.help(format!("the scene has {}", listed(names))),
                (suggestion, _) => problem.suggest(suggestion),
            });
        }
        None
    }
}

fn listed(names: &[&str]) -> String {
    const MOST: usize = 8;
    let shown: Vec<_> = names
        .iter()
        .take(MOST)
        .map(|name| format!("{name:?}"))
        .collect();
    let rest = if names.len() > MOST {
        " and others"
    } else {
        ""
    };
    shown.join(", ") + rest
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
        let message = format!("the name {name:?} is given twice");
        let label = format!("already used at {}", position(*earlier));
        problems.push(Problem::error(at, message, label).help("give one of them another name"));
    }
}
