//! One entity: `word name { attributes }`.

use super::entities::UNSUPPORTED;
use super::mistakes as mistake;
use super::tokens::{Token, Tokens};
use super::values;
use super::words::{Entity, Word};
use crate::language::{Location, Problem, Value};

/// An entity as it stands in the text.
#[derive(Debug)]
pub(super) struct Block {
    /// Its kind.
    pub(super) entity: &'static Entity,
    /// Its name.
    pub(super) name: Option<String>,
    /// Its attributes.
    pub(super) given: Vec<Given>,
    /// Where its word and name stand.
    pub(super) head: Location,
    /// The line they stand in, counted from 1.
    pub(super) line: usize,
    /// Whether all of it was understood.
    pub(super) sound: bool,
    /// Whether an attribute may have been lost because it was not recognised.
    lost: bool,
}

/// An attribute as it stands in the text.
#[derive(Debug)]
pub(super) struct Given {
    /// Which one.
    pub(super) word: &'static Word,
    /// Its value; `None` for a wrong one.
    pub(super) value: Option<Value>,
    /// Where it stands, from its word to the end of its value.
    pub(super) at: Location,
}

impl Block {
    /// The value of the attribute that means this.
    pub(super) fn value(&self, means: &str) -> Option<&Value> {
        self.find(means).and_then(|given| given.value.as_ref())
    }

    /// The attribute that means this.
    pub(super) fn find(&self, means: &str) -> Option<&Given> {
        self.given.iter().find(|given| given.word.means == means)
    }
}

/// Takes the next entity.
///
/// `None` if what comes next is no entity, or not one that is drawn; it is taken all the same.
pub(super) fn read(tokens: &mut Tokens<'_>, problems: &mut Vec<Problem>) -> Option<Block> {
    let word = tokens.next()?;
    if word.is_brace() {
        problems.push(mistake::stray_brace(tokens, word));
        return None;
    }
    if comment(word, tokens, problems) {
        return None;
    }
    let Some(entity) = Entity::find(word.text) else {
        problems.push(
            match UNSUPPORTED.iter().find(|(known, _)| *known == word.text) {
                Some((_, instead)) => mistake::unsupported(tokens, word, instead),
                None => mistake::unknown_entity(tokens, word),
            },
        );
        skip_block(tokens);
        return None;
    };
    let before = problems.len();
    let mut block = Block {
        entity,
        name: None,
        given: Vec::new(),
        head: tokens.at(word),
        line: word.line,
        sound: true,
        lost: false,
    };
    if head(&mut block, word, tokens, problems) {
        body(&mut block, word, tokens, problems);
        missing(&block, problems);
    }
    block.sound = problems.len() == before;
    Some(block)
}

/// Takes a comment, which the grammar does not have, if that is what a token begins.
fn comment<'a>(token: Token<'a>, tokens: &mut Tokens<'a>, problems: &mut Vec<Problem>) -> bool {
    let found = token.begins_comment();
    if found {
        problems.push(mistake::comment(tokens, token));
        tokens.skip_line(token.line);
    }
    found
}

/// Takes what is left of an entity whose word is not known.
fn skip_block(tokens: &mut Tokens<'_>) {
    let opens = |token: Option<Token<'_>>| token.is_some_and(|token| token.text == "{");
    if opens(tokens.peek(1)) {
        tokens.next();
    }
    tokens.take("{");
    while let Some(token) = tokens.peek(0) {
        let entity_begins =
            tokens.entity_begins() || (Entity::find(token.text).is_some() && opens(tokens.peek(1)));
        if entity_begins {
            return;
        }
        tokens.next();
        if token.text == "}" {
            return;
        }
    }
}

/// Takes the name and the opening brace; tells whether attributes can follow.
fn head<'a>(
    block: &mut Block,
    word: Token<'a>,
    tokens: &mut Tokens<'a>,
    problems: &mut Vec<Problem>,
) -> bool {
    match tokens.peek(0) {
        Some(name) if !name.is_brace() => {
            tokens.next();
            block.name = Some(name.text.to_owned());
            block.head = tokens.span(word, name);
        }
        Some(brace) => {
            problems.push(mistake::nameless(tokens, word));
            tokens.next();
            return brace.text == "{";
        }
        None => {
            problems.push(mistake::nameless(tokens, word));
            return false;
        }
    }
    if tokens.take("{") {
        return true;
    }
    problems.push(mistake::not_opened(block));
    block.lost = true;
    tokens.peek(0).is_some() && !tokens.entity_begins()
}

/// Takes the attributes and the closing brace.
fn body<'a>(
    block: &mut Block,
    word: Token<'a>,
    tokens: &mut Tokens<'a>,
    problems: &mut Vec<Problem>,
) {
    loop {
        let Some(token) = tokens.peek(0) else {
            problems.push(mistake::cut_short(tokens, block, word));
            block.lost = true;
            return;
        };
        if tokens.take("}") {
            return;
        }
        if tokens.entity_begins() {
            problems.push(mistake::not_closed(tokens, block, token));
            block.lost = true;
            return;
        }
        tokens.next();
        if let Some(word) = block.entity.word(token.text) {
            attribute(block, word, token, tokens, problems);
        } else if token.is_brace() {
            problems.push(mistake::stray_brace(tokens, token));
        } else if !comment(token, tokens, problems) {
            problems.push(mistake::unknown_attribute(tokens, block, token));
            block.lost = true;
            skip_values(block.entity, tokens);
        }
    }
}

/// Takes the value of an attribute.
fn attribute<'a>(
    block: &mut Block,
    word: &'static Word,
    token: Token<'a>,
    tokens: &mut Tokens<'a>,
    problems: &mut Vec<Problem>,
) {
    let read = values::read(block.entity, word, token, tokens);
    let at = tokens.span(token, tokens.last().unwrap_or(token));
    let value = read.unwrap_or_else(|problem| {
        problems.push(problem);
        skip_values(block.entity, tokens);
        None
    });
    match block.find(word.means) {
        Some(earlier) => problems.push(mistake::twice(word, earlier.word, at)),
        None => block.given.push(Given { word, value, at }),
    }
}

/// Takes what cannot be understood until something that can.
fn skip_values(entity: &Entity, tokens: &mut Tokens<'_>) {
    while let Some(token) = tokens.peek(0) {
        let understood = token.is_brace()
            || tokens.entity_begins()
            || entity.word(token.text).is_some()
            || token.begins_comment();
        if understood {
            return;
        }
        tokens.next();
    }
}

fn missing(block: &Block, problems: &mut Vec<Problem>) {
    let words = block.entity.words();
    let missing: Vec<_> = words
        .filter(|word| word.needed && block.find(word.means).is_none())
        .map(|word| word.word)
        .collect();
    // A word that was misspelt is not also missing.
    if !missing.is_empty() && !block.lost {
        problems.push(mistake::missing(block, &missing));
    }
}
