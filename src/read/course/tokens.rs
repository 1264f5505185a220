//! A text cut at its spaces and braces.

use crate::language::Location;

/// A stretch of text without spaces, or a brace.
#[derive(Debug, Clone, Copy)]
pub(super) struct Token<'a> {
    pub(super) text: &'a str,
    /// Its first byte.
    pub(super) start: usize,
    /// The line it stands in, counted from 1.
    pub(super) line: usize,
}

impl Token<'_> {
    /// Whether it is `{` or `}`.
    pub(super) fn is_brace(&self) -> bool {
        matches!(self.text, "{" | "}")
    }

    /// Whether it looks like the beginning of a comment, which the grammar does not have.
    pub(super) fn begins_comment(&self) -> bool {
        let marks = ["#", "//", "/*"];
        marks.iter().any(|mark| self.text.starts_with(mark))
    }

    /// The number that it is in the course's writing: what C reads with `%lf`, but for hexadecimal
    /// numbers, infinities and not-a-number.
    pub(super) fn number(&self) -> Option<f64> {
        let decimal = |character: char| character.is_ascii_digit() || "+-.eE".contains(character);
        let number = self.text.chars().all(decimal).then(|| self.text.parse());
        number.and_then(Result::ok)
    }
}

/// The tokens of a text, read from the front.
#[derive(Debug)]
pub(super) struct Tokens<'a> {
    source: usize,
    all: Vec<Token<'a>>,
    read: usize,
}

impl<'a> Tokens<'a> {
    /// The tokens of the text with this index.
    pub(super) fn new(source: usize, text: &'a str) -> Self {
        let all = cut(text);
        let read = 0;
        Self { source, all, read }
    }

    /// The token so many places ahead.
    pub(super) fn peek(&self, ahead: usize) -> Option<Token<'a>> {
        self.all.get(self.read + ahead).copied()
    }

    /// Takes the next token.
    pub(super) fn next(&mut self) -> Option<Token<'a>> {
        let token = self.peek(0)?;
        self.read += 1;
        Some(token)
    }

    /// Takes the next token if it is this text.
    pub(super) fn take(&mut self, text: &str) -> bool {
        let found = self.peek(0).is_some_and(|token| token.text == text);
        self.read += usize::from(found);
        found
    }

    /// Takes the tokens that are left in a line.
    pub(super) fn skip_line(&mut self, line: usize) {
        while self.peek(0).is_some_and(|token| token.line == line) {
            self.read += 1;
        }
    }

    /// Whether the next tokens can only be the beginning of an entity, because a brace opens after
    /// them: attributes have none.
    pub(super) fn entity_begins(&self) -> bool {
        let is_word = |ahead| self.peek(ahead).is_some_and(|token| !token.is_brace());
        is_word(0) && is_word(1) && self.peek(2).is_some_and(|token| token.text == "{")
    }

    /// The last token before the next one.
    pub(super) fn last(&self) -> Option<Token<'a>> {
        self.all.get(self.read.checked_sub(1)?).copied()
    }

    /// Where a token stands.
    pub(super) fn at(&self, token: Token<'a>) -> Location {
        self.span(token, token)
    }

    /// Where the text from one token to another stands.
    pub(super) fn span(&self, first: Token<'a>, last: Token<'a>) -> Location {
        Location {
            source: self.source,
            start: first.start,
            length: last.start + last.text.len() - first.start,
        }
    }
}

/// Cuts a text. One late course wrote vectors as `<4,3,4>`; they are cut at their commas.
fn cut(text: &str) -> Vec<Token<'_>> {
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
        tokens.extend(start.take().map(|start: usize| Token {
            text: &text[start..at],
            start,
            line,
        }));
        if brace {
            let text = &text[at..=at];
            tokens.push(Token {
                text,
                start: at,
                line,
            });
        }
        line += usize::from(character == '\n');
        in_vector = opens || (in_vector && !brace && character != '>');
    }
    tokens.extend(start.map(|start| Token {
        text: &text[start..],
        start,
        line,
    }));
    tokens
}

fn in_a_number(character: char) -> bool {
    character.is_ascii_digit() || matches!(character, '+' | '-' | '.' | ' ')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(text: &str) -> Vec<&str> {
        cut(text).iter().map(|token| token.text).collect()
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
        let lines: Vec<_> = cut("a b\n\r\nc").iter().map(|token| token.line).collect();
        assert_eq!(lines, [1, 1, 3]);
    }

    #[test]
    fn numbers_are_plain_decimals() {
        let number = |text: &str| cut(text)[0].number();
        for (text, value) in [("1.", 1.0), (".5", 0.5), ("+1", 1.0), ("-1e3", -1000.0)] {
            assert_eq!(number(text), Some(value), "{text}");
        }
        for text in ["nan", "inf", "0x10", "1,5", "-", ".", "1e", "e", "1f"] {
            assert_eq!(number(text), None, "{text}");
        }
    }
}
