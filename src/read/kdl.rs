//! KDL 2 to nodes.

use std::path::{Path, PathBuf};

use kdl::{KdlDocument, KdlEntry, KdlNode, KdlValue};
use miette::SourceSpan;

use super::check::{self, Raw};
use super::{Files, nesting};
use crate::language::{
    Attribute, Entry, Location, Naming, Node, Problem, Schema, Source, Takes, Value, did_you_mean,
};
use crate::scene::Scene;

/// The `include` node, which only files have.
pub(crate) const INCLUDE: Schema = Schema {
    word: "include",
    about: "Another scene file, whose nodes take this node's place.",
    naming: Naming::None,
    value: Some(&Attribute::new(
        "file",
        Takes::Path,
        "a KDL file, relative to this file",
    )),
    properties: &[],
    attributes: &[],
};

/// The most files that one scene may consist of; files that include one another twice over would
/// otherwise never end.
const MOST_FILES: usize = 1000;

/// Reads the nodes of a text and of all that it includes.
pub(super) fn read(source: usize, files: &mut Files, problems: &mut Vec<Problem>) -> Vec<Node> {
    let text = files.get(source).text.clone();
    if let Some(start) = nesting::too_deep(&text) {
        let message = format!("nested deeper than {} levels", nesting::DEEPEST);
        let at = Location {
            source,
            start,
            length: 1,
        };
        let problem = Problem::error(at, message, "one level too many");
        problems.push(problem.help("a scene needs no more than two levels; is a brace missing?"));
        return Vec::new();
    }
    let document = match KdlDocument::parse_v2(&text) {
        Ok(document) => document,
        Err(error) => {
            problems.extend(
                error
                    .diagnostics
                    .iter()
                    .map(|found| syntax_error(source, found)),
            );
            return Vec::new();
        }
    };
    let mut nodes = Vec::new();
    for kdl in document.nodes() {
        let mut reader = Reader { source, problems };
        let Some(node) = reader.node(kdl) else {
            continue;
        };
        if node.schema == &INCLUDE {
            nodes.extend(include(&node, files, problems));
        } else {
            nodes.push(node);
        }
    }
    nodes
}

fn syntax_error(source: usize, found: &kdl::KdlDiagnostic) -> Problem {
    let at = location(source, found.span);
    let message = found
        .message
        .clone()
        .unwrap_or_else(|| "this is not KDL".to_owned());
    let message = message.trim_end_matches('.').to_owned();
    let label = found
        .label
        .clone()
        .unwrap_or_else(|| "not understood".to_owned());
    let problem = Problem::error(at, message, label);
    match &found.help {
        Some(help) => problem.help(help.clone()),
        None => problem,
    }
}

fn location(source: usize, span: SourceSpan) -> Location {
    Location {
        source,
        start: span.offset(),
        length: span.len(),
    }
}

/// The nodes of an included file.
fn include(node: &Node, files: &mut Files, problems: &mut Vec<Problem>) -> Vec<Node> {
    let (Some(at), Some(Value::Text(file))) = (node.location, &node.value) else {
        return Vec::new();
    };
    let path = files.locate(at.source, file);
    match open(&path, at, files) {
        Ok(source) => {
            let directory = path.parent().map(Path::to_owned).unwrap_or_default();
            let source = files.add(source, vec![directory]);
            read(source, files, problems)
        }
        Err(problem) => {
            problems.push(problem);
            Vec::new()
        }
    }
}

/// The text of an included file, if it is not part of the chain of files that includes it.
fn open(path: &Path, at: Location, files: &Files) -> Result<Source, Problem> {
    let error = |message, label| Problem::error(at, message, label);
    let chain = files.sources().include_chain(at);
    let including = std::iter::once(at)
        .chain(chain)
        .map(|at| &files.get(at.source).name);
    if including
        .map(PathBuf::from)
        .any(|name| same_file(&name, path))
    {
        let message = format!("{} includes itself", path.display());
        return Err(error(message, "this closes the circle").help("remove one of the includes"));
    }
    if files.sources().len() >= MOST_FILES {
        let message = format!("the scene consists of more than {MOST_FILES} files");
        return Err(error(message, "one too many").help("is a file included again and again?"));
    }
    let bytes = std::fs::read(path).map_err(|reason| {
        let message = format!("cannot read {}: {reason}", path.display());
        error(message, "included here").help("file names are relative to the including file")
    })?;
    let text = super::files::text_of(bytes)
        .map_err(|reason| error(format!("{}: {reason}", path.display()), "included here"))?;
    Ok(Source {
        name: path.display().to_string(),
        text: text.into(),
        included_at: Some(at),
    })
}

fn same_file(a: &Path, b: &Path) -> bool {
    match (a.canonicalize(), b.canonicalize()) {
        (Ok(a), Ok(b)) => a == b,
        _ => a == b,
    }
}

/// Turns the `kdl` crate's nodes into ours, and notes what does not fit.
#[derive(Debug)]
struct Reader<'a> {
    source: usize,
    problems: &'a mut Vec<Problem>,
}

impl Reader<'_> {
    fn node(&mut self, kdl: &KdlNode) -> Option<Node> {
        let word = kdl.name().value();
        let Some(schema) = schemas().find(|schema| schema.word == word) else {
            let problem = Problem::error(
                self.at(kdl.name().span()),
                format!("there is no node `{word}`"),
                "not a word of the scene language",
            );
            let suggestion = did_you_mean(word, schemas().map(|schema| schema.word));
            self.problems.push(problem.suggest(suggestion));
            return None;
        };
        let before = self.problems.len();
        let mut node = Node::new(schema, None);
        node.location = Some(self.head(kdl));
        self.annotation(kdl.ty());

        let mut arguments: Vec<_> = kdl
            .entries()
            .iter()
            .filter(|entry| entry.name().is_none())
            .collect();
        node.name = self.name(schema, kdl, &mut arguments);
        match schema.value {
            Some(attribute) => node.value = self.value(attribute, kdl, &arguments),
            None => self.no_more(word, &arguments),
        }
        node.properties = self.properties(word, schema.properties, kdl);
        if let Some(children) = kdl.children() {
            self.attributes(&mut node, children);
        }
        self.missing(&node, kdl);
        node.sound = self.problems.len() == before;
        Some(node)
    }

    /// The name of a node, taken from the front of its arguments.
    fn name(
        &mut self,
        schema: &Schema,
        kdl: &KdlNode,
        arguments: &mut Vec<&KdlEntry>,
    ) -> Option<String> {
        let first = arguments.first().map(|entry| (entry.value(), entry.span()));
        match (schema.naming, first) {
            (Naming::None, _) | (Naming::Optional, None) => None,
            (_, Some((KdlValue::String(name), span))) => {
                arguments.remove(0);
                if name.is_empty() {
                    let problem =
                        Problem::error(self.at(span), "a name is empty", "expected a name");
                    self.problems.push(problem);
                }
                Some(name.clone())
            }
            (_, Some((_, span))) => {
                arguments.remove(0);
                let message = format!("the name of a `{}` is not a text", schema.word);
                let problem = Problem::error(self.at(span), message, "expected a name in quotes");
                self.problems.push(problem);
                None
            }
            (Naming::Required, None) => {
                let message = format!("a `{}` needs a name", schema.word);
                let at = self.at(kdl.name().span());
                let help = format!("write, for example, `{} \"oak\"`", schema.word);
                self.problems
                    .push(Problem::error(at, message, "expected a name").help(help));
                None
            }
        }
    }

    fn attributes(&mut self, node: &mut Node, children: &KdlDocument) {
        for child in children.nodes() {
            let word = child.name().value();
            let schema = node.schema;
            let Some(attribute) = schema.all_attributes().find(|known| known.word == word) else {
                let words: Vec<_> = schema.all_attributes().map(|known| known.word).collect();
                let at = self.at(child.name().span());
                self.unknown("attribute", word, schema.word, &words, at);
                continue;
            };
            self.annotation(child.ty());
            let at = self.head(child);
            if let Some(earlier) = node.entry(word) {
                self.twice(word, at, earlier.location);
                continue;
            }
            if let Some(grandchildren) = child.children() {
                let message = format!("`{word}` has no braces of its own");
                let at = self.at(grandchildren.span());
                self.problems
                    .push(Problem::error(at, message, "not expected here"));
            }
            let arguments: Vec<_> = child
                .entries()
                .iter()
                .filter(|entry| entry.name().is_none())
                .collect();
            let value = self.value(attribute, child, &arguments);
            let properties = self.properties(word, attribute.properties, child);
            node.attributes.push(Entry {
                attribute,
                value,
                properties,
                location: Some(at),
            });
        }
    }

    fn properties(&mut self, word: &str, known: &'static [Attribute], kdl: &KdlNode) -> Vec<Entry> {
        let mut entries: Vec<Entry> = Vec::new();
        for entry in kdl.entries() {
            let Some(key) = entry.name() else { continue };
            let at = self.at(entry.span());
            let Some(attribute) = known.iter().find(|known| known.word == key.value()) else {
                let words: Vec<_> = known.iter().map(|known| known.word).collect();
                self.unknown("property", key.value(), word, &words, at);
                continue;
            };
            let earlier = entries
                .iter()
                .find(|entry| entry.attribute.word == key.value());
            if let Some(earlier) = earlier {
                self.twice(key.value(), at, earlier.location);
                continue;
            }
            match check::value(attribute, &[(raw(entry.value()), at)], at) {
                Ok(value) => {
                    let location = Some(at);
                    entries.push(Entry {
                        attribute,
                        value,
                        properties: Vec::new(),
                        location,
                    });
                }
                Err(problem) => self.problems.push(problem),
            }
            self.annotation(entry.ty());
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
            .map(|entry| (raw(entry.value()), self.at(entry.span())))
            .collect();
        check::value(attribute, &raws, self.at(kdl.name().span())).unwrap_or_else(|problem| {
            self.problems.push(problem);
            None
        })
    }

    fn no_more(&mut self, word: &str, arguments: &[&KdlEntry]) {
        if let Some(stray) = arguments.first() {
            let message = format!("`{word}` takes no value here");
            let at = self.at(stray.span());
            let problem = Problem::error(at, message, "not expected");
            self.problems
                .push(problem.help("attributes stand between braces: `{ word value }`"));
        }
    }

    fn missing(&mut self, node: &Node, kdl: &KdlNode) {
        use crate::language::Default::Required;
        let all = node.schema.all_attributes();
        let missing: Vec<_> = all
            .filter(|known| known.default == Required && node.entry(known.word).is_none())
            .map(|known| format!("`{}`", known.word))
            .collect();
        // A word that was misspelt is not also missing.
        let unread = kdl.children().map_or(0, |children| children.nodes().len());
        if !missing.is_empty() && unread == node.attributes.len() {
            let word = node.schema.word;
            let message = format!("this `{word}` lacks {}", missing.join(", "));
            let at = self.at(kdl.name().span());
            self.problems
                .push(Problem::error(at, message, "expected between its braces"));
        }
    }

    fn unknown(&mut self, what: &str, word: &str, of: &str, known: &[&str], at: Location) {
        let message = format!("`{of}` has no {what} `{word}`");
        let problem = Problem::error(at, message, "not known here");
        let suggestion = did_you_mean(word, known.iter().copied());
        self.problems.push(match suggestion {
            None if !known.is_empty() => problem.help(format!("it has {}", known.join(", "))),
            suggestion => problem.suggest(suggestion),
        });
    }

    fn twice(&mut self, word: &str, at: Location, earlier: Option<Location>) {
        let message = format!("`{word}` is given twice");
        let problem = Problem::error(at, message, "the second time");
        debug_assert!(earlier.is_some(), "entries of this reader have places");
        self.problems.push(problem.help("keep one of them"));
    }

    /// Type annotations mean nothing in scenes.
    fn annotation(&mut self, annotation: Option<&kdl::KdlIdentifier>) {
        if let Some(annotation) = annotation {
            let message = format!(
                "the type annotation `({})` means nothing here",
                annotation.value()
            );
            let at = self.at(annotation.span());
            self.problems
                .push(Problem::error(at, message, "not expected").help("remove it"));
        }
    }

    /// The first line of a node: its word and what follows, without the braces.
    fn head(&self, kdl: &KdlNode) -> Location {
        let start = kdl.name().span().offset();
        let spans = kdl.entries().iter().map(KdlEntry::span);
        let ends = spans
            .chain([kdl.name().span()])
            .map(|span| span.offset() + span.len());
        let end = ends.max().unwrap_or(start);
        Location {
            source: self.source,
            start,
            length: end - start,
        }
    }

    fn at(&self, span: SourceSpan) -> Location {
        location(self.source, span)
    }
}

fn schemas() -> impl Iterator<Item = &'static Schema> {
    Scene::schemas().chain([&INCLUDE])
}

fn raw(value: &KdlValue) -> Raw {
    match value {
        KdlValue::String(text) => Raw::Text(text.clone()),
        #[expect(clippy::cast_precision_loss, reason = "scene numbers are doubles")]
        KdlValue::Integer(number) => Raw::Number(*number as f64),
        KdlValue::Float(number) => Raw::Number(*number),
        KdlValue::Bool(flag) => Raw::Flag(*flag),
        KdlValue::Null => Raw::Null,
    }
}
