//! Tokens of a text, separated by spaces and braces.

use crate::language::Location;

/// A text without spaces, or a brace.
#[derive(Debug, Clone, Copy)]
pub(super) struct Token<'a> {
    pub(super) text: &'a str,
    /// Its place.
    pub(super) at: Location,
    /// Its line, from 1.
    pub(super) line: usize,
}

impl Token<'_> {
    /// True for `{` and `}`.
    pub(super) fn is_brace(&self) -> bool {
        matches!(self.text, "{" | "}")
    }

    /// True if it resembles a comment, which the grammar does not have.
    pub(super) fn begins_comment(&self) -> bool {
        let marks = ["#", "//", "/*"];
        marks.iter().any(|mark| self.text.starts_with(mark))
    }

    /// Its number as C reads with `%lf`, but no hexadecimal number, infinity or NaN.
    pub(super) fn number(&self) -> Option<f64> {
        let decimal = |character: char| character.is_ascii_digit() || "+-.eE".contains(character);
        let number = self.text.chars().all(decimal).then(|| self.text.parse());
        number.and_then(Result::ok)
    }

    /// The place from this token to a later one.
    pub(super) fn to(&self, last: Token<'_>) -> Location {
        Location {
            length: last.at.start + last.at.length - self.at.start,
            ..self.at
        }
    }
}

/// The tokens of a text, read from the front.
#[derive(Debug)]
pub(super) struct Tokens<'a> {
    all: Vec<Token<'a>>,
    read: usize,
}

impl<'a> Tokens<'a> {
    /// The tokens of the text with this index.
    pub(super) fn new(source: usize, text: &'a str) -> Self {
        Self {
            all: cut(source, text),
            read: 0,
        }
    }

    /// The token a number of tokens ahead; 0 is the next one.
    pub(super) fn peek(&self, ahead: usize) -> Option<Token<'a>> {
        self.all.get(self.read + ahead).copied()
    }

    /// Takes the next token.
    pub(super) fn next(&mut self) -> Option<Token<'a>> {
        let token = self.peek(0)?;
        self.read += 1;
        Some(token)
    }

    /// Takes the next token if it equals a text.
    pub(super) fn take(&mut self, text: &str) -> bool {
        let found = self.peek(0).is_some_and(|token| token.text == text);
        self.read += usize::from(found);
        found
    }

    /// Skips the rest of a line.
    pub(super) fn skip_line(&mut self, line: usize) {
        while self.peek(0).is_some_and(|token| token.line == line) {
            self.read += 1;
        }
    }

    /// True if the next tokens begin an entity: two words and a brace.
    pub(super) fn entity_begins(&self) -> bool {
        let is_word = |ahead| self.peek(ahead).is_some_and(|token| !token.is_brace());
        is_word(0) && is_word(1) && self.peek(2).is_some_and(|token| token.text == "{")
    }

    /// The token before the next one.
    pub(super) fn last(&self) -> Option<Token<'a>> {
        self.all.get(self.read.checked_sub(1)?).copied()
    }
}

/// Separates the tokens of a text, and the numbers of vectors such as `<4,3,4>`.
///
/// One late course wrote vectors like that.
fn cut(source: usize, text: &str) -> Vec<Token<'_>> {
    let token = |start: usize, end: usize, line: usize| Token {
        text: &text[start..end],
        at: Location {
            source,
            start,
            length: end - start,
        },
        line,
    };
    let mut tokens = Vec::new();
    let (mut line, mut start, mut in_vector) = (1, None, false);
    for (at, character) in text.char_indices() {
        let opens = character == '<' && start.is_none() && text[at + 1..].starts_with(in_a_number);
        let closes = in_vector && matches!(character, ',' | '>');
        let brace = matches!(character, '{' | '}');
        if !(character.is_whitespace() || brace || opens || closes) {
            start.get_or_insert(at);
            continue;
        }
        tokens.extend(start.take().map(|start| token(start, at, line)));
        if brace {
            tokens.push(token(at, at + 1, line));
        }
        line += usize::from(character == '\n');
        in_vector = opens || (in_vector && !brace && character != '>');
    }
    tokens.extend(start.map(|start| token(start, text.len(), line)));
    tokens
}

fn in_a_number(character: char) -> bool {
    character.is_ascii_digit() || matches!(character, '+' | '-' | '.' | ' ')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(text: &str) -> Vec<&str> {
        cut(0, text).iter().map(|token| token.text).collect()
    }

    #[test]
    fn braces_stand_alone_even_without_spaces() {
        assert_eq!(
            texts("light a{b 1}c"),
            ["light", "a", "{", "b", "1", "}", "c"]
        );
    }

    #[test]
    fn vectors_in_angle_brackets_are_numbers() {
        assert_eq!(
            texts("point <4,-3,.5> normal < 0, 0, 1 >"),
            ["point", "4", "-3", ".5", "normal", "0", "0", "1"]
        );
        assert_eq!(texts("a <name> b,c"), ["a", "<name>", "b,c"]);
        assert_eq!(texts("p <1,2} q,r"), ["p", "1", "2", "}", "q,r"]);
    }

    #[test]
    fn lines_are_counted() {
        let lines: Vec<_> = cut(0, "a b\n\r\nc")
            .iter()
            .map(|token| token.line)
            .collect();
        assert_eq!(lines, [1, 1, 3]);
    }

    #[test]
    fn numbers_are_plain_decimals() {
        let number = |text: &str| cut(0, text)[0].number();
        for (text, value) in [("1.", 1.0), (".5", 0.5), ("+1", 1.0), ("-1e3", -1000.0)] {
            assert_eq!(number(text), Some(value), "{text}");
        }
        for text in ["nan", "inf", "0x10", "1,5", "-", ".", "1e", "e", "1f"] {
            assert_eq!(number(text), None, "{text}");
        }
    }
}
