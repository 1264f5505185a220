//! Nodes of the scene language from nodes of the `kdl` crate.

use kdl::{KdlDocument, KdlEntry, KdlIdentifier, KdlNode, KdlValue};
use miette::SourceSpan;

use super::check::{self, Raw};
use super::files::Files;
use super::schemas::schemas;
use super::{say, unknown};
use crate::language::{
    Attribute, Default, Diagnostic, Entry, Location, Naming, Node, Schema, Value, did_you_mean,
};

/// Converts one top-level node and reports its errors.
#[derive(Debug)]
pub(super) struct Reader<'a> {
    pub(super) source: usize,
    /// First byte of the node's piece in the text.
    pub(super) offset: usize,
    pub(super) files: &'a Files,
    pub(super) diagnostics: &'a mut Vec<Diagnostic>,
}

impl Reader<'_> {
    /// The node; `None` if its word is unknown and resembles no known word.
    pub(super) fn node(&mut self, kdl: &KdlNode) -> Option<Node> {
        let word = kdl.name().value();
        let Some(schema) = schemas().find(|schema| schema.word == word) else {
            let at = self.at(kdl.name().span());
            self.report(unknown::node(word, at));
            return self.misspelt(kdl);
        };
        let before = self.diagnostics.len();
        let mut node = Node::new(schema, None);
        node.location = Some(self.head(kdl));
        self.check_untyped(kdl.ty());

        let mut arguments = arguments(kdl);
        node.name = self.name(schema, kdl, &mut arguments);
        match schema.value {
            Some(attribute) if arguments.is_empty() => self.report_no_value(schema, attribute, kdl),
            Some(attribute) => {
                let before = self.diagnostics.len();
                node.value = self.value(attribute, kdl, &arguments);
                // The word of this attribute does not appear in scenes.
                let value = format!("`{}`", attribute.word);
                let clear = format!("the {} of this `{word}`", attribute.word);
                for diagnostic in &mut self.diagnostics[before..] {
                    diagnostic.message = diagnostic.message.replacen(&value, &clear, 1);
                }
            }
            None => self.check_no_value(schema, &arguments),
        }
        node.properties = self.properties(word, schema.properties, Some(schema), kdl);
        let misspelt = kdl
            .children()
            .map(|children| self.attributes(&mut node, children))
            .unwrap_or_default();
        self.check_required(&node, &misspelt, kdl);
        node.valid = self.diagnostics.len() == before;
        Some(node)
    }

    /// The node that a misspelt word resembles, invalid.
    ///
    /// References to it cause no further errors.
    fn misspelt(&self, kdl: &KdlNode) -> Option<Node> {
        let word = did_you_mean(kdl.name().value(), schemas().map(|schema| schema.word))?;
        let schema = schemas().find(|schema| schema.word == word)?;
        let arguments = arguments(kdl);
        let name = arguments
            .first()
            .and_then(|entry| entry.value().as_string());
        let mut node = Node::new(schema, name.filter(|_| schema.naming != Naming::None));
        node.location = Some(self.head(kdl));
        node.valid = false;
        Some(node)
    }

    /// The name of a node, removed from its arguments.
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
                let error = Diagnostic::error(at, message, "expected a name after it");
                self.report(error.help(format!("write, for example, `{word} \"oak\"`")));
                return None;
            }
            (_, Some(first)) => (first.value(), self.at(first.span())),
        };
        let entry = arguments.remove(0);
        self.check_untyped(entry.ty());
        let KdlValue::String(name) = first else {
            let message = format!("the name of this `{word}` is not a text");
            let error = Diagnostic::error(at, message, "expected a name in quotes");
            self.report(error.help("a name comes first; other values stand between the braces"));
            return None;
        };
        if name.is_empty() {
            let message = format!("the name of this `{word}` is empty");
            self.report(Diagnostic::error(at, message, "expected a name"));
        }
        Some(name.clone())
    }

    /// Reads the attributes between a node's braces.
    ///
    /// Returns the words that misspelt ones resemble.
    fn attributes(&mut self, node: &mut Node, children: &KdlDocument) -> Vec<&'static str> {
        let schema = node.schema;
        let mut misspelt = Vec::new();
        for child in children.nodes() {
            let word = child.name().value();
            let word_at = self.at(child.name().span());
            let Some(attribute) = schema.all_attributes().find(|known| known.word == word) else {
                let words = schema.all_attributes().map(|known| known.word);
                misspelt.extend(did_you_mean(word, words));
                self.report(unknown::attribute(word, schema, word_at));
                continue;
            };
            if let Some(earlier) = node.entry(word) {
                self.report_twice(word, word_at, earlier.location);
                continue;
            }
            self.check_untyped(child.ty());
            if let Some(grandchildren) = child.children() {
                self.report_braces(word, self.at(grandchildren.span()));
            }
            let value = self.value(attribute, child, &arguments(child));
            let properties = self.properties(word, attribute.properties, None, child);
            node.attributes.push(Entry {
                attribute,
                value,
                properties,
                location: Some(self.head(child)),
            });
        }
        misspelt
    }

    /// The settings on a line.
    ///
    /// `schema` is the line's node; `None` for the line of an attribute.
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
                self.report(unknown::property(key, word, known, schema, key_at));
                continue;
            };
            let earlier = entries.iter().find(|entry| entry.attribute.word == key);
            if let Some(earlier) = earlier {
                self.report_twice(key, key_at, earlier.location);
                continue;
            }
            self.check_untyped(entry.ty());
            let read = check::value(attribute, &[(raw(entry), value_of(entry, at))], at);
            entries.push(Entry {
                attribute,
                value: self.or_report(read),
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
            self.check_untyped(argument.ty());
        }
        let raws: Vec<_> = arguments
            .iter()
            .map(|entry| (raw(entry), value_of(entry, self.at(entry.span()))))
            .collect();
        let read = check::value(attribute, &raws, self.at(kdl.name().span()));
        self.or_report(read)
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    fn or_report(&mut self, read: Result<Option<Value>, Diagnostic>) -> Option<Value> {
        read.unwrap_or_else(|error| {
            self.report(error);
            None
        })
    }

    /// Reports a node without the value on its line.
    fn report_no_value(&mut self, schema: &Schema, attribute: &Attribute, kdl: &KdlNode) {
        let (word, value, takes) = (schema.word, attribute.word, attribute.takes.words());
        let message = format!("this `{word}` has no {value}");
        let label = format!("expected {takes} after it");
        let error = Diagnostic::error(self.head(kdl), message, label);
        self.report(match schema.naming {
            Naming::None => error.help(format!("`{word}` takes {takes}: {}", attribute.about)),
            _ => error.help(format!("`{word}` takes a name, and then {takes}")),
        });
    }

    /// Checks that a node without a value has no arguments after its name.
    fn check_no_value(&mut self, schema: &Schema, arguments: &[&KdlEntry]) {
        let Some(first) = arguments.first() else {
            return;
        };
        let word = schema.word;
        let message = match schema.naming {
            Naming::None => format!("`{word}` takes no value"),
            Naming::Optional | Naming::Required => format!("`{word}` takes one name and no value"),
        };
        let at = self.at(first.span());
        let error = Diagnostic::error(at, message, "not expected here");
        self.report(error.help(format!("attributes stand between braces: `{word} {{ … }}`")));
    }

    fn report_braces(&mut self, word: &str, at: Location) {
        let at = Location { length: 1, ..at };
        let message = format!("`{word}` has no braces of its own");
        let error = Diagnostic::error(at, message, "not expected here");
        self.report(error.help("remove the braces; values follow the word on its line"));
    }

    /// Checks that a node has all required attributes, except misspelt ones.
    fn check_required(&mut self, node: &Node, misspelt: &[&str], kdl: &KdlNode) {
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
        let error = Diagnostic::error(at, message, "expected between its braces");
        let takes = |known: &&Attribute| {
            let (word, takes, about) = (known.word, known.takes.words(), known.about);
            format!("`{word}` takes {takes}: {about}")
        };
        let help: Vec<_> = missing.iter().map(takes).collect();
        self.report(error.help(help.join("\n")));
    }

    fn report_twice(&mut self, word: &str, at: Location, earlier: Option<Location>) {
        let message = format!("`{word}` is given twice");
        let label = earlier.map_or_else(String::new, |earlier| {
            format!("the first is at {}", self.files.sources().position(earlier))
        });
        self.report(Diagnostic::error(at, message, label).help("keep one of them"));
    }

    /// Checks that there is no type annotation, which scenes do not have.
    fn check_untyped(&mut self, annotation: Option<&KdlIdentifier>) {
        let Some(annotation) = annotation else { return };
        let shown = say::shown(annotation.value());
        let message = format!("the type annotation `({shown})` is not supported");
        let error = Diagnostic::error(self.at(annotation.span()), message, "not expected");
        self.report(error.help("remove it with its parentheses"));
    }

    /// The word of a node and the values after it, without properties and braces.
    fn head(&self, kdl: &KdlNode) -> Location {
        let word = self.at(kdl.name().span());
        let last = arguments(kdl).last().map(|last| self.at(last.span()));
        let last = last.unwrap_or(word);
        Location {
            length: last.start + last.length - word.start,
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

/// The place of an entry's value, at the end of the entry.
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
