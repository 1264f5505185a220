//! KDL 2 to nodes.

use std::collections::HashSet;
use std::ops::Range;

use kdl::{KdlDiagnostic, KdlNode};

use super::entries::Reader;
use super::include::{self, INCLUDE};
use super::pieces::{Piece, Pieces};
use super::{Files, syntax};
use crate::language::{Location, Node, Problem};

/// The nodes of a text and of all that it includes, and whether they are all that it says.
#[derive(Debug)]
pub(super) struct Nodes {
    pub(super) nodes: Vec<Node>,
    /// Whether no part of a text is missing here because it could not be read. What is then not
    /// found among the nodes may be there all the same.
    pub(super) complete: bool,
}

/// Reads the nodes of a text and of all that it includes.
pub(super) fn read(source: usize, files: &mut Files, problems: &mut Vec<Problem>) -> Nodes {
    let text = files.get(source).text.clone();
    let pieces = Pieces::of(&text);
    let mut all = Nodes {
        nodes: Vec::new(),
        complete: pieces.mistakes.is_empty(),
    };
    for (mistake, range) in &pieces.mistakes {
        problems.push(syntax::mistake(*mistake, location(source, range.clone())));
    }
    for piece in &pieces.nodes {
        let Some(kdl) = parse(source, &text, piece, problems) else {
            all.complete = false;
            continue;
        };
        if piece.commented {
            continue;
        }
        let node = Reader::new(source, piece.range.start, files, problems).node(&kdl);
        match node {
            Some(node) if node.schema == &INCLUDE => include(&node, files, problems, &mut all),
            Some(node) => all.nodes.push(node),
            None => {}
        }
    }
    all
}

/// One node as the `kdl` crate reads it.
fn parse(source: usize, text: &str, piece: &Piece, problems: &mut Vec<Problem>) -> Option<KdlNode> {
    let error = match text[piece.range.clone()].parse::<KdlNode>() {
        Ok(node) => return Some(node),
        Err(error) => error,
    };
    // All braces are closed; that one seems to be open is because of a mistake before it.
    let open = |found: &&KdlDiagnostic| said(found).contains("losing '}'");
    let mut found: Vec<_> = error.diagnostics.iter().collect();
    if !found.iter().all(open) {
        found.retain(|found| !open(found));
    }
    found.sort_by_key(|found| found.span.offset());
    // The crate finds one mistake in several ways; one for each line is enough.
    let mut lines = HashSet::new();
    for found in &found {
        let at = location(source, range_in(piece, found));
        if lines.insert(text[..at.start].rfind('\n')) {
            problems.push(syntax::error(text, at, &said(found)));
        }
        if text[at.start..].starts_with("\"\"\"") {
            break;
        }
    }
    if found.is_empty() {
        problems.push(syntax::error(
            text,
            location(source, piece.range.clone()),
            "",
        ));
    }
    None
}

/// What the crate says about a mistake.
fn said(found: &KdlDiagnostic) -> String {
    let said = [&found.message, &found.label].map(|said| said.as_deref().unwrap_or(""));
    said.join(" ")
}

/// Where a diagnostic points to in the whole text.
fn range_in(piece: &Piece, found: &KdlDiagnostic) -> Range<usize> {
    let start = piece.range.start + found.span.offset();
    start..start + found.span.len()
}

fn location(source: usize, range: Range<usize>) -> Location {
    Location {
        source,
        start: range.start,
        length: range.len(),
    }
}

/// Adds the nodes of an included file.
fn include(node: &Node, files: &mut Files, problems: &mut Vec<Problem>, all: &mut Nodes) {
    match include::open(node, files) {
        Ok(source) => {
            let included = read(source, files, problems);
            all.nodes.extend(included.nodes);
            all.complete &= included.complete;
        }
        Err(problem) => {
            // Too many files are one mistake, however often they are too many.
            let known = |problem: &Problem| problems.iter().any(|p| p.message == problem.message);
            let problem = problem.filter(|problem| !known(problem));
            problems.extend(problem);
            all.complete = false;
        }
    }
}
