//! The parser from tokens to blocks.

use super::block::{Block, Given};
use super::tokens::{Token, Tokens};
use super::words::{Entity, Word};
use super::{entities, errors, values};
use crate::language::Diagnostic;

/// Parses blocks and reports their errors.
#[derive(Debug)]
pub(super) struct Parser<'a, 'd> {
    pub(super) tokens: Tokens<'a>,
    pub(super) diagnostics: &'d mut Vec<Diagnostic>,
}

impl<'a> Parser<'a, '_> {
    /// All blocks of supported entities.
    pub(super) fn blocks(mut self) -> Vec<Block> {
        let mut blocks = Vec::new();
        while let Some(word) = self.tokens.next() {
            blocks.extend(self.block(word));
        }
        blocks
    }

    /// The block that a token begins; `None` if it begins none of a supported entity.
    fn block(&mut self, word: Token<'a>) -> Option<Block> {
        if word.is_brace() {
            self.diagnostics.push(errors::stray_brace(word));
            return None;
        }
        if self.skip_comment(word) {
            return None;
        }
        let Some(entity) = entities::find(word.text) else {
            self.diagnostics.push(errors::unknown_entity(word));
            self.skip_block();
            return None;
        };
        let before = self.diagnostics.len();
        let mut block = Block {
            entity,
            name: None,
            given: Vec::new(),
            head: word.at,
            line: word.line,
            valid: true,
            incomplete: false,
        };
        if self.head(&mut block, word) {
            self.body(&mut block, word);
            self.check_required(&block);
        }
        block.valid = self.diagnostics.len() == before;
        Some(block)
    }

    /// Reports and skips a comment; false for other tokens.
    fn skip_comment(&mut self, token: Token<'a>) -> bool {
        let is_comment = token.begins_comment();
        if is_comment {
            self.diagnostics.push(errors::comment(token));
            self.tokens.skip_line(token.line);
        }
        is_comment
    }

    /// Skips the rest of an unknown entity.
    fn skip_block(&mut self) {
        let opens = |token: Option<Token<'_>>| token.is_some_and(|token| token.text == "{");
        if opens(self.tokens.peek(1)) {
            self.tokens.next();
        }
        self.tokens.take("{");
        while let Some(token) = self.tokens.peek(0) {
            let is_unnamed = entities::find(token.text).is_some() && opens(self.tokens.peek(1));
            if self.tokens.entity_begins() || is_unnamed {
                return;
            }
            self.tokens.next();
            if token.text == "}" {
                return;
            }
        }
    }

    /// Parses the name and the opening brace; false if no attributes can follow.
    fn head(&mut self, block: &mut Block, word: Token<'a>) -> bool {
        match self.tokens.peek(0) {
            Some(name) if !name.is_brace() => {
                self.tokens.next();
                block.name = Some(name.text.to_owned());
                block.head = word.to(name);
            }
            token => {
                self.diagnostics.push(errors::nameless(word));
                self.tokens.next();
                return token.is_some_and(|brace| brace.text == "{");
            }
        }
        if self.tokens.take("{") {
            return true;
        }
        self.diagnostics.push(errors::not_opened(block));
        block.incomplete = true;
        self.tokens.peek(0).is_some() && !self.tokens.entity_begins()
    }

    /// Parses the attributes and the closing brace.
    fn body(&mut self, block: &mut Block, word: Token<'a>) {
        loop {
            let Some(token) = self.tokens.peek(0) else {
                let last = self.tokens.last().unwrap_or(word);
                self.diagnostics.push(errors::cut_short(block, last));
                block.incomplete = true;
                return;
            };
            if self.tokens.take("}") {
                return;
            }
            if self.tokens.entity_begins() {
                self.diagnostics.push(errors::not_closed(block, token));
                block.incomplete = true;
                return;
            }
            self.tokens.next();
            if let Some(word) = block.entity.word(token.text) {
                self.attribute(block, word, token);
            } else if token.is_brace() {
                self.diagnostics.push(errors::stray_brace(token));
            } else if !self.skip_comment(token) {
                self.diagnostics
                    .push(errors::unknown_attribute(block, token));
                block.incomplete = true;
                self.skip_values(block.entity);
            }
        }
    }

    /// Parses the value of an attribute.
    fn attribute(&mut self, block: &mut Block, word: &'static Word, token: Token<'a>) {
        let read = values::read(block.entity, word, token, &mut self.tokens);
        let at = token.to(self.tokens.last().unwrap_or(token));
        let value = read.unwrap_or_else(|error| {
            self.diagnostics.push(error);
            self.skip_values(block.entity);
            None
        });
        match block.find(word.means) {
            Some(earlier) => self.diagnostics.push(errors::twice(word, earlier.word, at)),
            None => block.given.push(Given { word, value, at }),
        }
    }

    /// Skips tokens up to a brace, a comment, or a known word.
    fn skip_values(&mut self, entity: &Entity) {
        while let Some(token) = self.tokens.peek(0) {
            let is_known = token.is_brace()
                || self.tokens.entity_begins()
                || entity.word(token.text).is_some()
                || token.begins_comment();
            if is_known {
                return;
            }
            self.tokens.next();
        }
    }

    /// Checks that a block has all required attributes, if none can be hidden.
    fn check_required(&mut self, block: &Block) {
        let words = block.entity.words();
        let missing: Vec<_> = words
            .filter(|word| word.required && block.find(word.means).is_none())
            .map(|word| word.word)
            .collect();
        if !missing.is_empty() && !block.incomplete {
            self.diagnostics.push(errors::missing(block, &missing));
        }
    }
}
