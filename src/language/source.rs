//! Source texts of a scene, and places in them.

use std::sync::Arc;

/// A range of bytes of one source text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Location {
    /// Index of the text in [`Sources`].
    pub source: usize,
    /// First byte.
    pub start: usize,
    /// Length in bytes.
    pub length: usize,
}

/// The text of a scene file or an included file.
#[derive(Debug, Clone)]
pub struct Source {
    /// The file's name in messages.
    pub name: String,
    /// Its text.
    pub text: Arc<str>,
    /// Place of the `include` node, if it is included.
    pub included_at: Option<Location>,
}

/// The texts of a scene; the first is the scene file itself.
#[derive(Debug, Clone, std::default::Default)]
pub struct Sources(Vec<Source>);

impl Sources {
    /// Adds a text and returns its index.
    pub fn add(&mut self, source: Source) -> usize {
        self.0.push(source);
        self.0.len() - 1
    }

    /// The text with this index.
    #[must_use]
    pub fn get(&self, index: usize) -> &Source {
        &self.0[index]
    }

    /// All texts, the scene file first.
    pub fn iter(&self) -> impl Iterator<Item = &Source> {
        self.0.iter()
    }

    /// The number of texts.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// True if there is no text.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// `file:line:column` of a location's first byte, from 1, columns in characters.
    #[must_use]
    pub fn position(&self, location: Location) -> String {
        let source = self.get(location.source);
        let (line, column) = source.line_and_column(location.start);
        format!("{}:{line}:{column}", source.name)
    }

    /// The `include` nodes that lead to the text of a location, innermost first.
    #[must_use]
    pub fn include_chain(&self, location: Location) -> Vec<Location> {
        std::iter::successors(self.get(location.source).included_at, |at| {
            self.get(at.source).included_at
        })
        .collect()
    }
}

impl Source {
    /// True if a location's line and `around` lines on both sides are short.
    #[must_use]
    pub fn lines_are_short(&self, at: Location, around: usize) -> bool {
        const LONGEST: usize = 400;
        let (before, after) = self.text.split_at(self.text.floor_char_boundary(at.start));
        let mut lines = before.rsplit('\n').take(around + 1);
        let mut others = after.split('\n').take(around + 1);
        lines.all(|line| line.len() <= LONGEST) && others.all(|line| line.len() <= LONGEST)
    }

    /// Line and column of a byte, from 1, columns in characters.
    #[must_use]
    pub fn line_and_column(&self, byte: usize) -> (usize, usize) {
        let end = self.text.floor_char_boundary(byte);
        let before = &self.text[..end];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let line = before.matches('\n').count() + 1;
        (line, before[line_start..].chars().count() + 1)
    }
}
