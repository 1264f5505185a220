//! Texts compared with the ones that are kept; `SNAPSHOTS=overwrite` rewrites those.

use std::fs;
use std::path::Path;

use snapbox::assert::DEFAULT_ACTION_ENV;
use snapbox::data::DataFormat;
use snapbox::{Assert, Data};

/// Compares a text with the file that is kept of it, character by character.
///
/// # Errors
///
/// Shows the lines that differ.
pub fn compare(kept: impl AsRef<Path>, text: &str) -> Result<(), String> {
    let expected = Data::read_from(kept.as_ref(), Some(DataFormat::Text)).raw();
    let assert = Assert::new().action_env(DEFAULT_ACTION_ENV);
    let compared = assert.try_eq(Some(&"now"), Data::text(text), expected);
    compared.map_err(|differs| differs.to_string())
}

/// The part of a document between two marks, each in a line of its own, and what is around it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Section<'a> {
    /// All before the part, the first mark included.
    pub before: &'a str,
    /// The part.
    pub inside: &'a str,
    /// All behind the part, the second mark included.
    pub after: &'a str,
}

impl<'a> Section<'a> {
    /// Finds the part between a line that begins with `start` and the next one that begins with
    /// `end`; `None` if one of them is missing.
    #[must_use]
    pub fn of(document: &'a str, start: &str, end: &str) -> Option<Self> {
        let mark = document.find(&format!("\n{start}"))? + 1;
        let from = mark + document[mark..].find('\n')? + 1;
        let to = from + document[from - 1..].find(&format!("\n{end}"))?;
        Some(Self {
            before: &document[..from],
            inside: &document[from..to],
            after: &document[to..],
        })
    }

    /// The document with another text in place of the part.
    #[must_use]
    pub fn with(&self, text: &str) -> String {
        [self.before, text, self.after].concat()
    }
}

/// Compares the part of a document between two marks with a text.
///
/// # Errors
///
/// Shows the lines that differ, or says which document has lost its marks.
pub fn compare_section(
    document: impl AsRef<Path>,
    [start, end]: [&str; 2],
    text: &str,
) -> Result<(), String> {
    let name = document.as_ref().display();
    let kept = fs::read_to_string(&document).map_err(|error| format!("{name}: {error}"))?;
    let section = Section::of(&kept, start, end);
    let section = section.ok_or_else(|| format!("{name}: no lines {start} … {end}"))?;
    compare(document, &section.with(text))
}
