//! The `kdl` crate's nodes to ours: words, values and what does not fit.

use kdl::{KdlDocument, KdlEntry, KdlNode, KdlValue};
use miette::SourceSpan;

use super::check::{self, Raw};
use super::schemas;
use super::{Files, say, unknown};
use crate::language::{
    Attribute, Default, Entry, Location, Naming, Node, Problem, Schema, Value, did_you_mean,
};

/// Turns one top-level node into ours, and notes what does not fit.
#[derive(Debug)]
pub(super) struct Reader<'a> {
    source: usize,
    /// Where in its text the node's piece starts.
    offset: usize,
    files: &'a Files,
    problems: &'a mut Vec<Problem>,
}

impl<'a> Reader<'a> {
    pub(super) fn new(
        source: usize,
        offset: usize,
        files: &'a Files,
        problems: &'a mut Vec<Problem>,
    ) -> Self {
        Self {
            source,
            offset,
            files,
            problems,
        }
    }

    /// The node; `None` if its word is not even nearly known.
    pub(super) fn node(&mut self, kdl: &KdlNode) -> Option<Node> {
        let word = kdl.name().value();
        let Some(schema) = schemas().find(|schema| schema.word == word) else {
            let at = self.at(kdl.name().span());
            self.problems.push(unknown::node(word, at));
            return self.meant(kdl);
        };
        let before = self.problems.len();
        let mut node = Node::new(schema, None);
        node.location = Some(self.head(kdl));
        self.annotation(kdl.ty());

        let mut arguments = arguments(kdl);
        node.name = self.name(schema, kdl, &mut arguments);
        match schema.value {
            Some(attribute) if arguments.is_empty() => self.no_value(schema, attribute, kdl),
            Some(attribute) => {
                let before = self.problems.len();
                node.value = self.value(attribute, kdl, &arguments);
                // Its word is not written in scenes.
                let value = format!("`{}`", attribute.word);
                let clear = format!("the {} of this `{word}`", attribute.word);
                for problem in &mut self.problems[before..] {
                    problem.message = problem.message.replacen(&value, &clear, 1);
                }
            }
            None => self.no_more(schema, &arguments),
        }
        node.properties = self.properties(word, schema.properties, Some(schema), kdl);
        let misspelt = kdl
            .children()
            .map(|children| self.attributes(&mut node, children))
            .unwrap_or_default();
        self.missing(&node, &misspelt, kdl);
        node.sound = self.problems.len() == before;
        Some(node)
    }

    /// The unsound node that a misspelt word probably means, so that nothing else misses it.
    fn meant(&self, kdl: &KdlNode) -> Option<Node> {
        let word = did_you_mean(kdl.name().value(), schemas().map(|schema| schema.word))?;
        let schema = schemas().find(|schema| schema.word == word)?;
        let name = arguments(kdl)
            .first()
            .and_then(|entry| entry.value().as_string());
        let mut node = Node::new(schema, name.filter(|_| schema.naming != Naming::None));
        node.location = Some(self.head(kdl));
        node.sound = false;
        Some(node)
    }

    /// The name of a node, taken from the front of its arguments.
    fn name(
        &mut self,
        schema: &Schema,
        kdl: &KdlNode,
        arguments: &mut Vec<&KdlEntry>,
    ) -> Option<String> {
        let word = schema.word;
        let (first, at) = match (schema.naming, arguments.first()) {
            (Naming::None, _) | (Naming::Optional, None) => return None,
            (Naming::Required, None) => {
                let at = self.at(kdl.name().span());
                let message = format!("this `{word}` has no name");
                let problem = Problem::error(at, message, "expected a name after it");
                self.problems
                    .push(problem.help(format!("write, for example, `{word} \"oak\"`")));
                return None;
            }
            (_, Some(first)) => (first.value(), self.at(first.span())),
        };
        let entry = arguments.remove(0);
        self.annotation(entry.ty());
        let KdlValue::String(name) = first else {
            let message = format!("the name of this `{word}` is not a text");
            let problem = Problem::error(at, message, "expected a name in quotes");
            self.problems
                .push(problem.help("a name comes first; other values stand between the braces"));
            return None;
        };
        if name.is_empty() {
            let message = format!("the name of this `{word}` is empty");
            self.problems
                .push(Problem::error(at, message, "expected a name"));
        }
        Some(name.clone())
    }

    /// Reads the attributes between a node's braces; gives the words that misspelt ones mean.
    fn attributes(&mut self, node: &mut Node, children: &KdlDocument) -> Vec<&'static str> {
        let mut misspelt = Vec::new();
        for child in children.nodes() {
            let word = child.name().value();
            let schema = node.schema;
            let Some(attribute) = schema.all_attributes().find(|known| known.word == word) else {
                let at = self.at(child.name().span());
                let words = schema.all_attributes().map(|known| known.word);
                misspelt.extend(did_you_mean(word, words));
                self.problems.push(unknown::attribute(word, schema, at));
                continue;
            };
            let at = self.head(child);
            if let Some(earlier) = node.entry(word) {
                self.twice(word, self.at(child.name().span()), earlier.location);
                continue;
            }
            self.annotation(child.ty());
            if let Some(grandchildren) = child.children() {
                let brace = self.at(grandchildren.span());
                self.no_braces(
                    word,
                    Location {
                        start: brace.start,
                        ..at
                    },
                );
            }
            let value = self.value(attribute, child, &arguments(child));
            let properties = self.properties(word, attribute.properties, None, child);
            node.attributes.push(Entry {
                attribute,
                value,
                properties,
                location: Some(at),
            });
        }
        misspelt
    }

    /// The settings on a line; `schema` is the line's node if it is one.
    fn properties(
        &mut self,
        word: &str,
        known: &'static [Attribute],
        schema: Option<&'static Schema>,
        kdl: &KdlNode,
    ) -> Vec<Entry> {
        let mut entries: Vec<Entry> = Vec::new();
        for entry in kdl.entries() {
            let Some(name) = entry.name() else { continue };
            let (key, at) = (name.value(), self.at(entry.span()));
            let key_at = self.at(name.span());
            let Some(attribute) = known.iter().find(|known| known.word == key) else {
                let problem = unknown::property(key, word, known, schema, key_at);
                self.problems.push(problem);
                continue;
            };
            let earlier = entries.iter().find(|entry| entry.attribute.word == key);
            if let Some(earlier) = earlier {
                self.twice(key, key_at, earlier.location);
                continue;
            }
            self.annotation(entry.ty());
            let read = check::value(attribute, &[(raw(entry), value_of(entry, at))], at);
            let value = self.or_problem(read);
            entries.push(Entry {
                attribute,
                value,
                properties: Vec::new(),
                location: Some(at),
            });
        }
        entries
    }

    fn value(
        &mut self,
        attribute: &Attribute,
        kdl: &KdlNode,
        arguments: &[&KdlEntry],
    ) -> Option<Value> {
        for argument in arguments {
            self.annotation(argument.ty());
        }
        let raws: Vec<_> = arguments
            .iter()
            .map(|entry| (raw(entry), value_of(entry, self.at(entry.span()))))
            .collect();
        let read = check::value(attribute, &raws, self.at(kdl.name().span()));
        self.or_problem(read)
    }

    fn or_problem(&mut self, read: Result<Option<Value>, Problem>) -> Option<Value> {
        read.unwrap_or_else(|problem| {
            self.problems.push(problem);
            None
        })
    }

    /// Reports that a node lacks the value on its line.
    fn no_value(&mut self, schema: &Schema, attribute: &Attribute, kdl: &KdlNode) {
        let (word, value, takes) = (schema.word, attribute.word, attribute.takes.words());
        let message = format!("this `{word}` has no {value}");
        let label = format!("expected {takes} after it");
        let problem = Problem::error(self.head(kdl), message, label);
        self.problems.push(match schema.naming {
            Naming::None => problem.help(format!("`{word}` takes {takes}: {}", attribute.about)),
            _ => problem.help(format!("`{word}` takes a name, and then {takes}")),
        });
    }

    /// Refuses what follows the name of a node that has no value.
    fn no_more(&mut self, schema: &Schema, arguments: &[&KdlEntry]) {
        let Some(stray) = arguments.first() else {
            return;
        };
        let word = schema.word;
        let message = match schema.naming {
            Naming::None => format!("`{word}` takes no value"),
            Naming::Optional | Naming::Required => format!("`{word}` takes one name and no value"),
        };
        let at = self.at(stray.span());
        let problem = Problem::error(at, message, "not expected here");
        self.problems
            .push(problem.help(format!("attributes stand between braces: `{word} {{ … }}`")));
    }

    fn no_braces(&mut self, word: &str, at: Location) {
        let at = Location { length: 1, ..at };
        let message = format!("`{word}` has no braces of its own");
        let problem = Problem::error(at, message, "not expected here");
        self.problems
            .push(problem.help("remove the braces; values follow the word on its line"));
    }

    /// Reports the attributes that a node needs and lacks, unless they are merely misspelt.
    fn missing(&mut self, node: &Node, misspelt: &[&str], kdl: &KdlNode) {
        let missing: Vec<_> = node
            .schema
            .all_attributes()
            .filter(|known| known.default == Default::Required)
            .filter(|known| node.entry(known.word).is_none() && !misspelt.contains(&known.word))
            .collect();
        if missing.is_empty() {
            return;
        }
        let words = say::words(missing.iter().map(|known| known.word));
        let message = format!("this `{}` lacks {words}", node.schema.word);
        let at = self.at(kdl.name().span());
        let problem = Problem::error(at, message, "expected between its braces");
        let takes = |known: &&Attribute| {
            let (word, takes, about) = (known.word, known.takes.words(), known.about);
            format!("`{word}` takes {takes}: {about}")
        };
        let help: Vec<_> = missing.iter().map(takes).collect();
        self.problems.push(problem.help(help.join("\n")));
    }

    fn twice(&mut self, word: &str, at: Location, earlier: Option<Location>) {
        let message = format!("`{word}` is given twice");
        let label = earlier.map_or_else(String::new, |earlier| {
            format!("the first is at {}", self.files.sources().position(earlier))
        });
        self.problems
            .push(Problem::error(at, message, label).help("keep one of them"));
    }

    /// Type annotations mean nothing in scenes.
    fn annotation(&mut self, annotation: Option<&kdl::KdlIdentifier>) {
        let Some(annotation) = annotation else { return };
        let message = format!(
            "the type `({})` means nothing here",
            say::shown(annotation.value())
        );
        let at = self.at(annotation.span());
        self.problems.push(
            Problem::error(at, message, "not expected").help("remove it with its parentheses"),
        );
    }

    /// The word of a node and the values that follow it, without properties and braces.
    fn head(&self, kdl: &KdlNode) -> Location {
        let word = self.at(kdl.name().span());
        let last = arguments(kdl).last().map(|last| self.at(last.span()));
        let end = last.map_or(word.start + word.length, |last| last.start + last.length);
        Location {
            length: end - word.start,
            ..word
        }
    }

    fn at(&self, span: SourceSpan) -> Location {
        Location {
            source: self.source,
            start: self.offset + span.offset(),
            length: span.len(),
        }
    }
}

/// The values on a node's line that are not properties.
fn arguments(kdl: &KdlNode) -> Vec<&KdlEntry> {
    let entries = kdl.entries().iter();
    entries.filter(|entry| entry.name().is_none()).collect()
}

/// Where the value of an entry stands: at its end, after the key and the `=`.
fn value_of(entry: &KdlEntry, at: Location) -> Location {
    let length = written(entry).map_or(at.length, str::len).min(at.length);
    Location {
        start: at.start + at.length - length,
        length,
        ..at
    }
}

/// The value of an entry as it is written.
fn written(entry: &KdlEntry) -> Option<&str> {
    entry.format().map(|format| format.value_repr.as_str())
}

fn raw(entry: &KdlEntry) -> Raw {
    match entry.value() {
        KdlValue::String(text) => Raw::Text(text.clone()),
        #[expect(clippy::cast_precision_loss, reason = "scene numbers are doubles")]
        KdlValue::Integer(number) => Raw::Number(*number as f64),
        KdlValue::Float(number) => match written(entry) {
            Some(written) if number.is_infinite() && !written.starts_with('#') => {
                Raw::Beyond(written.to_owned())
            }
            _ => Raw::Number(*number),
        },
        KdlValue::Bool(flag) => Raw::Flag(*flag),
        KdlValue::Null => Raw::Null,
    }
}
