//! The value of one attribute.

use super::tokens::{Token, Tokens};
use super::words::{Entity, Role, Word};
use crate::language::{Attribute, Location, Problem, Takes, Value};
use crate::read::check::{self, Raw};

/// Takes the value that follows an attribute's word.
///
/// # Errors
/// What is wrong with it; the rest of it may then be left among the tokens.
pub(super) fn read<'a>(
    entity: &Entity,
    word: &Word,
    at: Token<'a>,
    tokens: &mut Tokens<'a>,
) -> Result<Option<Value>, Problem> {
    let takes = word.takes(entity);
    if let Takes::Name(_) | Takes::Path = takes {
        let name = name(entity, tokens);
        return name
            .map(|name| Some(Value::from(name)))
            .ok_or_else(|| no_name(word, takes, tokens.at(at)));
    }
    let numbers = numbers(entity, takes, tokens);
    let attribute = Attribute::new(word.word, takes, "");
    check::value(&attribute, &numbers, tokens.at(at)).map_err(|problem| match word.role {
        Role::Mode => problem.help("0 stretches the image over the plane, 1 tiles it"),
        _ => problem,
    })
}

/// Takes one token, unless it belongs to what follows.
fn name<'a>(entity: &Entity, tokens: &mut Tokens<'a>) -> Option<&'a str> {
    let name = tokens.peek(0)?;
    let is_word = |token: Token<'_>| entity.word(token.text).is_some();
    // Anything may be a name, even an attribute's word; but then another one follows it.
    let next = tokens.peek(1);
    let word_with_value =
        is_word(name) && next.is_some_and(|next| !next.is_brace() && !is_word(next));
    if name.is_brace() || tokens.entity_begins() || word_with_value {
        return None;
    }
    tokens.next().map(|token| token.text)
}

fn no_name(word: &Word, takes: Takes, at: Location) -> Problem {
    let expected = match (word.role, takes) {
        (Role::Texture, _) => "the name of a texture, or a file".to_owned(),
        (_, Takes::Path) => "the name of a file".to_owned(),
        (_, takes) => takes.words(),
    };
    Problem::error(
        at,
        format!("`{}` has no value", word.word),
        format!("expected {expected}"),
    )
}

/// Takes all numbers that follow, and what stands in the place of one.
fn numbers(entity: &Entity, takes: Takes, tokens: &mut Tokens<'_>) -> Vec<(Raw, Location)> {
    let expected = match takes {
        Takes::Triple => 3,
        Takes::Pair(_) => 2,
        _ => 1,
    };
    let mut raws = Vec::new();
    let mut all_numbers = true;
    while let Some(token) = tokens.peek(0) {
        let number = token.number();
        let enough = raws.len() >= expected;
        let ends = match number {
            Some(_) => enough && !all_numbers,
            None => {
                enough
                    || token.is_brace()
                    || token.begins_comment()
                    || entity.word(token.text).is_some()
            }
        };
        if ends || tokens.entity_begins() {
            break;
        }
        all_numbers &= number.is_some();
        let raw = number.map_or_else(|| Raw::Text(token.text.to_owned()), Raw::Number);
        raws.push((raw, tokens.at(token)));
        tokens.next();
    }
    raws
}
