//! Words that are not known where they stand, and what was probably meant.

use super::say;
use super::schemas;
use crate::language::{Attribute, Location, Problem, Schema, did_you_mean};

/// A word that begins no node.
pub(super) fn node(word: &str, at: Location) -> Problem {
    let message = format!("there is no node `{}`", say::shown(word));
    let problem = Problem::error(at, message, "expected a word that begins a node");
    let owners: Vec<_> = schemas()
        .filter(|schema| has_attribute(schema, word))
        .map(|schema| schema.word)
        .collect();
    match did_you_mean(word, schemas().map(|schema| schema.word)) {
        _ if !owners.is_empty() => problem.help(format!(
            "`{word}` stands between the braces of {}; was a brace closed too early?",
            alternatives(&owners),
        )),
        None => {
            let words = say::words(schemas().map(|schema| schema.word));
            problem.help(format!("the nodes are {words}"))
        }
        suggestion => problem.suggest(suggestion),
    }
}

/// A word that is no attribute of its node.
pub(super) fn attribute(word: &str, of: &'static Schema, at: Location) -> Problem {
    let (node, shown) = (of.word, say::shown(word));
    let message = format!("`{node}` has no attribute `{shown}`");
    let problem = Problem::error(at, message, format!("expected an attribute of `{node}`"));
    let mut words = of.all_attributes().map(|known| known.word).peekable();
    if of.properties.iter().any(|known| known.word == word) {
        let help = format!("`{word}` stands on the node's own line: `{node} … {word}=…`");
        return problem.help(help);
    }
    if schemas().any(|schema| schema.word == word) {
        let help = format!("`{word}` is a node of its own; is a `}}` missing before it?");
        return problem.help(help);
    }
    if words.peek().is_none() {
        return problem.help(format!("`{node}` has no attributes; remove its braces"));
    }
    match did_you_mean(word, of.all_attributes().map(|known| known.word)) {
        None => problem.help(format!("it has {}", say::words(words))),
        suggestion => problem.suggest(suggestion),
    }
}

/// A key that is no property of its line; `node` is the line's node if it is one.
pub(super) fn property(
    key: &str,
    line: &str,
    known: &'static [Attribute],
    node: Option<&'static Schema>,
    at: Location,
) -> Problem {
    let shown = say::shown(key);
    let message = format!("`{line}` has no property `{shown}`");
    let problem = Problem::error(at, message, format!("expected a property of `{line}`"));
    if node.is_some_and(|schema| has_attribute(schema, key)) {
        let help = format!("`{key}` stands between the braces: `{line} {{ {key} … }}`");
        return problem.help(help);
    }
    let words = || known.iter().map(|known| known.word);
    match did_you_mean(key, words()) {
        None if known.is_empty() => problem.help("it has no properties; remove this one"),
        None => problem.help(format!("it has {}", say::words(words()))),
        suggestion => problem.suggest(suggestion),
    }
}

fn has_attribute(schema: &Schema, word: &str) -> bool {
    schema.all_attributes().any(|known| known.word == word)
}

/// Some of the nodes that an attribute may belong to.
fn alternatives(words: &[&str]) -> String {
    const MOST: usize = 3;
    let quoted: Vec<_> = words
        .iter()
        .take(MOST)
        .map(|word| format!("`{word}`"))
        .collect();
    let shown = quoted.join(", ");
    if words.len() > MOST {
        format!("{shown} and other nodes")
    } else {
        shown
    }
}
