//! Top-level nodes of a KDL text, found without recursion.
//!
//! The `kdl` crate recurses for each level of nesting, and for each mistake of a broken text. A
//! file of a few thousand braces would overflow the stack. So the crate gets one node at a time,
//! and its depth is limited here. A missing brace or quote is reported here at its own place: it
//! would change the meaning of the text after it.

use std::ops::Range;

/// The deepest nesting of braces. Scenes need two levels.
///
/// The crate's time doubles with each level that is commented out.
pub(super) const DEEPEST: usize = 4;

/// The deepest nesting of block comments.
const DEEPEST_COMMENT: usize = 32;

/// The pieces of a text.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Pieces {
    /// The complete top-level nodes.
    pub(super) nodes: Vec<Piece>,
    /// The mistakes in the others.
    pub(super) mistakes: Vec<(Mistake, Range<usize>)>,
}

/// One top-level node, with the spaces and comments around it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Piece {
    /// Its bytes.
    pub(super) range: Range<usize>,
    /// True if it is commented out with `/-`.
    pub(super) commented: bool,
}

/// Mistakes in braces, quotes and comments.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Mistake {
    /// A `{` without its `}`.
    OpenBrace,
    /// A `}` without its `{`.
    StrayBrace,
    /// A `{` without a node's word before it.
    LooseBrace,
    /// A text without its closing quote.
    OpenText,
    /// A `/*` without its `*/`.
    OpenComment,
    /// A `/-` with nothing after it.
    OpenSlashdash,
    /// Braces, comments or slashdashes that are nested too deeply.
    TooDeep,
}

impl Pieces {
    /// The pieces of a text.
    pub(super) fn of(text: &str) -> Self {
        let mut scanner = Scanner::new(text);
        while let Some(character) = scanner.rest().chars().next() {
            if scanner.step(character).is_none() {
                return scanner.pieces;
            }
        }
        if let Some(&open) = scanner.open.last() {
            scanner.mistake(Mistake::OpenBrace, open..open + 1);
        }
        if scanner.commented && !scanner.filled {
            scanner.mistake(Mistake::OpenSlashdash, scanner.start - 2..scanner.start);
        }
        scanner.end_piece();
        scanner.pieces
    }
}

/// A position in a text, and the state of its piece.
#[derive(Debug)]
struct Scanner<'a> {
    text: &'a str,
    at: usize,
    /// The start of the piece.
    start: usize,
    /// True if the piece has more than spaces and comments.
    filled: bool,
    /// True if the piece is commented out.
    commented: bool,
    /// True if the piece has a mistake.
    broken: bool,
    /// The positions of open braces.
    open: Vec<usize>,
    /// The number of slashdashes since the last word.
    slashdashes: usize,
    /// True if a `\` joins the next line to this one.
    joined: bool,
    pieces: Pieces,
}

impl<'a> Scanner<'a> {
    fn new(text: &'a str) -> Self {
        Self {
            text,
            at: 0,
            start: 0,
            filled: false,
            commented: false,
            broken: false,
            open: Vec::new(),
            slashdashes: 0,
            joined: false,
            pieces: Pieces::default(),
        }
    }

    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    /// Skips a token; `None` if the rest of the text has no meaning.
    fn step(&mut self, character: char) -> Option<()> {
        let rest = self.rest();
        if rest.starts_with("//") {
            self.at += rest.find(is_newline).unwrap_or(rest.len());
        } else if rest.starts_with("/*") {
            self.comment()?;
        } else if rest.starts_with("/-") {
            self.slashdash()?;
        } else if character == '\\' {
            self.joined = true;
            self.at += 1;
        } else if is_newline(character) || character == ';' {
            self.separator(character);
        } else if character.is_whitespace() {
            self.at += character.len_utf8();
        } else {
            let first = !self.filled && self.open.is_empty();
            (self.filled, self.joined, self.slashdashes) = (true, false, 0);
            match character {
                '{' => self.open_brace(first)?,
                '}' => self.close_brace(),
                '"' | '#' if self.quoted() => {}
                other => self.at += other.len_utf8(),
            }
        }
        Some(())
    }

    fn mistake(&mut self, mistake: Mistake, range: Range<usize>) {
        self.broken = true;
        self.pieces.mistakes.push((mistake, range));
    }

    /// Ends the piece here.
    fn end_piece(&mut self) {
        if self.filled && !self.broken {
            self.pieces.nodes.push(Piece {
                range: self.start..self.at,
                commented: self.commented,
            });
        }
        self.start = self.at;
        (self.filled, self.commented, self.broken) = (false, false, false);
    }

    /// Skips a newline or a semicolon, which ends a node outside of braces.
    fn separator(&mut self, character: char) {
        let goes_on = character != ';' && (self.joined || self.slashdashes > 0);
        if self.open.is_empty() && !goes_on {
            self.end_piece();
            self.start += character.len_utf8();
        }
        self.joined = false;
        self.at += character.len_utf8();
    }

    fn slashdash(&mut self) -> Option<()> {
        self.slashdashes += 1;
        if self.slashdashes > DEEPEST {
            self.mistake(Mistake::TooDeep, self.at..self.at + 2);
            return None;
        }
        self.at += 2;
        if self.open.is_empty() && !self.filled && !self.commented {
            self.commented = true;
            self.start = self.at;
        }
        Some(())
    }

    fn open_brace(&mut self, first: bool) -> Option<()> {
        if first {
            // The brace belongs to the node on the line before.
            self.pieces.nodes.pop();
            self.mistake(Mistake::LooseBrace, self.at..self.at + 1);
        }
        if self.open.len() == DEEPEST {
            self.mistake(Mistake::TooDeep, self.at..self.at + 1);
            return None;
        }
        self.open.push(self.at);
        self.at += 1;
        Some(())
    }

    fn close_brace(&mut self) {
        if self.open.pop().is_none() {
            // Nodes without braces probably belong between these.
            let text = self.text;
            let nodes = &mut self.pieces.nodes;
            while nodes
                .last()
                .is_some_and(|node| !text[node.range.clone()].contains('{'))
            {
                nodes.pop();
            }
            self.mistake(Mistake::StrayBrace, self.at..self.at + 1);
        }
        self.at += 1;
    }

    /// Skips a block comment and nested ones.
    fn comment(&mut self) -> Option<()> {
        let start = self.at;
        let mut depth = 0;
        loop {
            let rest = self.rest();
            if rest.starts_with("/*") {
                depth += 1;
                if depth > DEEPEST_COMMENT {
                    self.mistake(Mistake::TooDeep, self.at..self.at + 2);
                    return None;
                }
                self.at += 2;
            } else if rest.starts_with("*/") {
                depth -= 1;
                self.at += 2;
                if depth == 0 {
                    return Some(());
                }
            } else if let Some(character) = rest.chars().next() {
                self.at += character.len_utf8();
            } else {
                self.mistake(Mistake::OpenComment, start..start + 2);
                return None;
            }
        }
    }

    /// Skips a quoted text; false if there is none.
    ///
    /// It can be plain, multi-line (`"""`) or raw (`#"…"#`).
    fn quoted(&mut self) -> bool {
        let rest = self.rest();
        let hashes = rest.len() - rest.trim_start_matches('#').len();
        let quote = match &rest[hashes..] {
            lines if lines.starts_with("\"\"\"") => "\"\"\"",
            line if line.starts_with('"') => "\"",
            _ => return false,
        };
        let start = self.at;
        self.at += hashes + quote.len();
        let end = format!("{quote}{}", "#".repeat(hashes));
        while let Some(character) = self.rest().chars().next() {
            if self.rest().starts_with(&end) {
                self.at += end.len();
                return true;
            } else if hashes == 0 && character == '\\' {
                self.escape();
            } else if quote.len() == 1 && is_newline(character) {
                break;
            } else {
                self.at += character.len_utf8();
            }
        }
        self.mistake(Mistake::OpenText, start..self.at);
        // A brace at the end of such a text is probably meant as one.
        if quote.len() == 1 && self.text[start..self.at].trim_end().ends_with('{') {
            self.open.push(self.at - 1);
        }
        true
    }

    /// Skips a backslash in a text with the character or the spaces that it escapes.
    fn escape(&mut self) {
        self.at += 1;
        let spaces = self.rest().len() - self.rest().trim_start().len();
        let escaped = self.rest().chars().next().map_or(0, char::len_utf8);
        self.at += spaces.max(escaped);
    }
}

/// The characters that end a line in KDL.
fn is_newline(character: char) -> bool {
    matches!(
        character,
        '\n' | '\r' | '\u{b}' | '\u{c}' | '\u{85}' | '\u{2028}' | '\u{2029}'
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn nodes(text: &str, expected: &[&str]) {
        let pieces = Pieces::of(text);
        assert_eq!(pieces.mistakes, []);
        let nodes = pieces.nodes.iter().filter(|piece| !piece.commented);
        let nodes: Vec<_> = nodes
            .map(|piece| text[piece.range.clone()].trim())
            .collect();
        assert_eq!(nodes, expected);
    }

    #[track_caller]
    fn mistake(text: &str, mistake: Mistake, at: usize) {
        let found = Pieces::of(text).mistakes;
        let found: Vec<_> = found.iter().map(|(what, at)| (*what, at.start)).collect();
        assert_eq!(found, [(mistake, at)]);
    }

    #[test]
    fn nodes_end_with_their_line_or_a_semicolon() {
        nodes("a 1\nb 2; c 3\r\n\n", &["a 1", "b 2", "c 3"]);
        nodes("a {\n b; c\n}\nd", &["a {\n b; c\n}", "d"]);
        nodes(
            "a \\\n 1\nb \\ // why\n 2",
            &["a \\\n 1", "b \\ // why\n 2"],
        );
        nodes("\n// nothing\n/* at\nall */\n;", &[]);
        nodes("a /* b\n */ c", &["a /* b\n */ c"]);
        nodes("a /- \n{ b }\nc", &["a /- \n{ b }", "c"]);
    }

    #[test]
    fn a_slashdash_comments_out_the_next_node_even_on_another_line() {
        nodes("/- a {\n b\n}\nc", &["c"]);
        nodes("/-\n// here\na\nc", &["c"]);
        assert_eq!(Pieces::of("/-a").nodes[0].range, 2..3);
    }

    #[test]
    fn braces_in_texts_and_comments_are_none() {
        for text in [
            "a \"{{{\"",
            "a #\"{\"{\"#",
            "a ##\"\"#{\"##",
            "a \"\"\"\n{{\n\"\"\"",
            "a \"\\\"{\"",
            "a \"b \\\n {\"",
            "a /* { /* { */ */",
        ] {
            nodes(text, &[text]);
        }
        nodes("// {{\na", &["a"]);
    }

    #[test]
    fn what_is_not_closed_is_found_where_it_was_opened() {
        mistake("a {\n b 1\n", Mistake::OpenBrace, 2);
        mistake("a { b { }\nc", Mistake::OpenBrace, 2);
        mistake("a }\nb", Mistake::StrayBrace, 2);
        mistake("a \"b {\n c\n}\nd", Mistake::OpenText, 2);
        mistake("a #\"b\"\nd", Mistake::OpenText, 2);
        mistake("a \"\"\"\nb\nc", Mistake::OpenText, 2);
        mistake("a /* b /* */\nd", Mistake::OpenComment, 2);
        mistake("a \"\\", Mistake::OpenText, 2);
        mistake("a\n{\n b\n}", Mistake::LooseBrace, 2);
        mistake("a\n/- // b\n", Mistake::OpenSlashdash, 2);
    }

    #[test]
    fn the_good_nodes_of_a_broken_text_are_kept() {
        let pieces = Pieces::of("a { }\nb \"c\nd }\ne");
        assert_eq!(pieces.nodes.len(), 2);
        assert_eq!(pieces.mistakes.len(), 2);
    }

    #[test]
    fn what_is_nested_too_deep_is_found() {
        mistake(&"a {".repeat(3_000), Mistake::TooDeep, 3 * DEEPEST + 2);
        mistake(&"/*".repeat(30_000), Mistake::TooDeep, 64);
        mistake(&"/-".repeat(10_000), Mistake::TooDeep, 2 * DEEPEST);
        mistake(&"/- ".repeat(10_000), Mistake::TooDeep, 3 * DEEPEST);
    }
}
