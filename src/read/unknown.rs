//! Errors about unknown words, with suggestions.

use super::say;
use super::schemas::schemas;
use crate::language::{Attribute, Diagnostic, Location, Schema, did_you_mean};

/// The error for a word that begins no node.
pub(super) fn node(word: &str, at: Location) -> Diagnostic {
    let message = format!("there is no node `{}`", say::shown(word));
    let error = Diagnostic::error(at, message, "expected a word that begins a node");
    let owners: Vec<_> = schemas()
        .filter(|schema| has_attribute(schema, word))
        .map(|schema| schema.word)
        .collect();
    if !owners.is_empty() {
        let owners = alternatives(&owners);
        return error.help(format!(
            "`{word}` stands between the braces of {owners}; was a brace closed too early?"
        ));
    }
    let words = || schemas().map(|schema| schema.word);
    match did_you_mean(word, words()) {
        None => error.help(format!("the nodes are {}", say::words(words()))),
        suggestion => error.suggest(suggestion),
    }
}

/// The error for a word that is no attribute of its node.
pub(super) fn attribute(word: &str, of: &'static Schema, at: Location) -> Diagnostic {
    let (node, shown) = (of.word, say::shown(word));
    let message = format!("`{node}` has no attribute `{shown}`");
    let error = Diagnostic::error(at, message, format!("expected an attribute of `{node}`"));
    let words = || of.all_attributes().map(|known| known.word);
    if of.properties.iter().any(|known| known.word == word) {
        let help = format!("`{word}` stands on the node's own line: `{node} … {word}=…`");
        return error.help(help);
    }
    if schemas().any(|schema| schema.word == word) {
        return error.help(format!(
            "`{word}` is a node of its own; is a `}}` missing before it?"
        ));
    }
    match did_you_mean(word, words()) {
        None if words().next().is_none() => {
            error.help(format!("`{node}` has no attributes; remove its braces"))
        }
        None => error.help(format!("it has {}", say::words(words()))),
        suggestion => error.suggest(suggestion),
    }
}

/// The error for a key that is no property of its line.
///
/// `node` is the line's node; `None` for the line of an attribute.
pub(super) fn property(
    key: &str,
    line: &str,
    known: &'static [Attribute],
    node: Option<&'static Schema>,
    at: Location,
) -> Diagnostic {
    let shown = say::shown(key);
    let message = format!("`{line}` has no property `{shown}`");
    let error = Diagnostic::error(at, message, format!("expected a property of `{line}`"));
    if node.is_some_and(|schema| has_attribute(schema, key)) {
        return error.help(format!(
            "`{key}` stands between the braces: `{line} {{ {key} … }}`"
        ));
    }
    let words = || known.iter().map(|known| known.word);
    match did_you_mean(key, words()) {
        None if known.is_empty() => error.help("it has no properties; remove this one"),
        None => error.help(format!("it has {}", say::words(words()))),
        suggestion => error.suggest(suggestion),
    }
}

fn has_attribute(schema: &Schema, word: &str) -> bool {
    schema.all_attributes().any(|known| known.word == word)
}

/// The first nodes that have an attribute.
fn alternatives(words: &[&str]) -> String {
    const MOST: usize = 3;
    let quoted = words.iter().take(MOST).map(|word| format!("`{word}`"));
    let shown = quoted.collect::<Vec<_>>().join(", ");
    if words.len() > MOST {
        format!("{shown} and other nodes")
    } else {
        shown
    }
}
