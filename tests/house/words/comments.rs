//! Doc comments of Rust sources.

use super::blocks::{Block, blocks};
use super::sentences::sentences;

/// The most characters in the first line of an item's comment.
pub(crate) const LONGEST: usize = 80;
/// The most characters in the first line of a file.
pub(crate) const LONGEST_OPENING: usize = 100;

/// A doc comment: consecutive lines with `///` or `//!`.
pub(crate) struct Comment<'a> {
    /// The number of its first line, from 1.
    pub(crate) line: usize,
    /// Its lines without the marks.
    lines: Vec<&'a str>,
    /// The line of code below it and its attributes; none for a file's own comment.
    item: Option<&'a str>,
}

impl<'a> Comment<'a> {
    /// Its paragraphs, list items and other blocks.
    pub(crate) fn blocks(&self) -> Vec<Block> {
        let lines = self.lines.iter().enumerate();
        blocks(lines.map(|(index, line)| (self.line + index, *line)))
    }

    /// Whether it belongs to something that other modules can see.
    pub(crate) fn is_public(&self) -> bool {
        self.item
            .is_some_and(|item| item.starts_with("pub ") || item.starts_with("pub("))
    }

    /// The fault of its first line, which must be a short statement that ends there.
    pub(crate) fn fault(&self) -> Option<&'static str> {
        let first = self.lines[0].trim();
        let goes_on = self
            .lines
            .get(1)
            .is_some_and(|line| !line.trim().is_empty());
        let last = sentences(first).last().map_or("", |sentence| sentence.text);
        if first.chars().count() > LONGEST {
            Some("is longer than 80 characters")
        } else if first.starts_with("This ") {
            Some("begins with \"This\"")
        } else if goes_on && !last.ends_with(['.', '?', '!', ':']) {
            Some("does not end its sentence")
        } else {
            None
        }
    }
}

/// The doc comments of a source file.
pub(crate) fn comments(source: &str) -> Vec<Comment<'_>> {
    let mut found: Vec<Comment> = Vec::new();
    let (mut is_open, mut depth) = (false, 0);
    for (index, line) in source.lines().map(str::trim).enumerate() {
        let outer = line
            .strip_prefix("///")
            .filter(|rest| !rest.starts_with('/'));
        if let Some(text) = outer.or_else(|| line.strip_prefix("//!")) {
            let text = text.strip_prefix(' ').unwrap_or(text);
            match found.last_mut() {
                Some(last) if is_open => last.lines.push(text),
                _ => found.push(Comment {
                    line: index + 1,
                    lines: vec![text],
                    item: None,
                }),
            }
            (is_open, depth) = (true, 0);
            continue;
        }
        is_open = false;
        if depth > 0 || line.starts_with("#[") {
            depth += line.matches('[').count();
            depth -= line.matches(']').count().min(depth);
        } else if let Some(last) = found.last_mut()
            && last.item.is_none()
            && !line.is_empty()
        {
            last.item = Some(line);
        }
    }
    found
}

/// The fault of a file's first line, which must be one plain sentence about the file.
pub(crate) fn fault_of_opening(source: &str) -> Option<&'static str> {
    let first = source.lines().next().unwrap_or_default();
    match first.strip_prefix("//! ") {
        None => Some("does not open with a line of //!"),
        Some(_) if first.chars().count() > LONGEST_OPENING => {
            Some("opens with more than 100 characters")
        }
        Some(text) if !text.ends_with('.') => {
            Some("opens with a line that does not end in a full stop")
        }
        Some(_) => None,
    }
}

#[test]
fn comments_are_found_with_their_items() {
    let source = "//! A file.\n//!\n//! - more\n\n/// One\n/// two.\n#[derive(\n    [A],\n)]\npub struct B;\n\
                  //// no\n    /// Three.\n    fn c();\n";
    let comments = comments(source);
    let lines: Vec<_> = comments
        .iter()
        .map(|comment| (comment.line, comment.lines.len()))
        .collect();
    assert_eq!(lines, [(1, 3), (5, 2), (12, 1)]);
    assert_eq!(comments[1].item, Some("pub struct B;"));
    assert_eq!(comments[2].item, Some("fn c();"));
    assert!(comments[1].is_public() && !comments[2].is_public());
    assert_eq!(comments[0].blocks()[1].line, 3);
}

#[test]
fn first_lines_are_judged() {
    let fault = |source| comments(source)[0].fault();
    assert_eq!(fault("/// Short.\npub fn f();"), None);
    assert_eq!(fault("/// A phrase\npub fn f();"), None);
    assert_eq!(
        fault("/// A phrase.\n///\n/// This is more.\npub fn f();"),
        None
    );
    assert_eq!(
        fault("/// A statement.\n/// Another that goes\n/// on.\npub fn f();"),
        None
    );
    assert_eq!(
        fault("/// A sentence that goes\n/// on.\npub fn f();"),
        Some("does not end its sentence")
    );
    assert_eq!(
        fault("/// This is it.\npub fn f();"),
        Some("begins with \"This\"")
    );
    let long = format!("/// {}.\npub fn f();", "x".repeat(LONGEST));
    assert_eq!(fault(&long), Some("is longer than 80 characters"));
}

#[test]
fn openings_of_files_are_judged() {
    assert_eq!(fault_of_opening("//! A file.\n\nfn f() {}"), None);
    assert!(fault_of_opening("fn f() {}").is_some());
    assert!(fault_of_opening("//! A file that\n//! goes on.\n").is_some());
    assert!(fault_of_opening(&format!("//! {}.\n", "x".repeat(96))).is_some());
    assert!(fault_of_opening(&format!("//! {}.\n", "x".repeat(95))).is_none());
}
