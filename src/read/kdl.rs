//! Nodes of KDL 2 texts.

use std::collections::HashSet;
use std::ops::Range;

use kdl::{KdlDiagnostic, KdlNode};

use super::entries::Reader;
use super::files::Files;
use super::pieces::{Piece, Pieces};
use super::schemas::INCLUDE;
use super::{include, syntax};
use crate::language::{Diagnostic, Location, Node};

/// The nodes of a text and of the texts that it includes.
#[derive(Debug)]
pub(super) struct Nodes {
    pub(super) nodes: Vec<Node>,
    /// False if a part of a text could not be read, so that nodes may be missing.
    pub(super) complete: bool,
}

/// Reads the nodes of a text and of the texts that it includes.
pub(super) fn read(source: usize, files: &mut Files, diagnostics: &mut Vec<Diagnostic>) -> Nodes {
    let text = files.get(source).text.clone();
    let pieces = Pieces::of(&text);
    let mut all = Nodes {
        nodes: Vec::new(),
        complete: pieces.mistakes.is_empty(),
    };
    for (mistake, range) in pieces.mistakes {
        diagnostics.push(syntax::mistake(mistake, location(source, range)));
    }
    for piece in &pieces.nodes {
        let Some(kdl) = parse(source, &text, piece, diagnostics) else {
            all.complete = false;
            continue;
        };
        if piece.commented {
            continue;
        }
        let mut reader = Reader {
            source,
            offset: piece.range.start,
            files,
            diagnostics,
        };
        match reader.node(&kdl) {
            Some(node) if node.schema == &INCLUDE => include(&node, files, diagnostics, &mut all),
            Some(node) => all.nodes.push(node),
            None => {}
        }
    }
    all
}

/// Parses one node with the `kdl` crate.
fn parse(
    source: usize,
    text: &str,
    piece: &Piece,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<KdlNode> {
    let error = match text[piece.range.clone()].parse::<KdlNode>() {
        Ok(node) => return Some(node),
        Err(error) => error,
    };
    // All braces of a piece are closed. Another mistake before it makes one seem open.
    let is_open = |found: &&KdlDiagnostic| syntax::is_open_brace(&words(found));
    let mut found: Vec<_> = error.diagnostics.iter().collect();
    if !found.iter().all(is_open) {
        found.retain(|found| !is_open(found));
    }
    found.sort_by_key(|found| found.span.offset());
    // The crate reports a mistake in several ways. The first of each line is enough.
    let mut lines = HashSet::new();
    for found in &found {
        let start = piece.range.start + found.span.offset();
        let at = location(source, start..start + found.span.len());
        if lines.insert(text[..at.start].rfind('\n')) {
            diagnostics.push(syntax::error(text, at, &words(found)));
        }
        if text[at.start..].starts_with("\"\"\"") {
            break;
        }
    }
    if found.is_empty() {
        let at = location(source, piece.range.clone());
        diagnostics.push(syntax::error(text, at, ""));
    }
    None
}

/// Message and label of a diagnostic of the crate.
fn words(found: &KdlDiagnostic) -> String {
    let words = [&found.message, &found.label].map(|words| words.as_deref().unwrap_or(""));
    words.join(" ")
}

fn location(source: usize, range: Range<usize>) -> Location {
    Location {
        source,
        start: range.start,
        length: range.len(),
    }
}

/// Adds the nodes of an included file.
fn include(node: &Node, files: &mut Files, diagnostics: &mut Vec<Diagnostic>, all: &mut Nodes) {
    match include::open(node, files) {
        Ok(source) => {
            let included = read(source, files, diagnostics);
            all.nodes.extend(included.nodes);
            all.complete &= included.complete;
        }
        Err(error) => {
            // The limit of files is reported once.
            let is_new = |error: &Diagnostic| {
                let mut others = diagnostics.iter();
                others.all(|other| other.message != error.message)
            };
            let error = error.filter(is_new);
            diagnostics.extend(error);
            all.complete = false;
        }
    }
}
