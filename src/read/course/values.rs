//! Values of attributes.

use super::tokens::{Token, Tokens};
use super::words::{Entity, Role, Word};
use crate::language::{Attribute, Diagnostic, Location, Takes, Value};
use crate::read::check::{self, Raw};

/// Takes the value of an attribute, whose word is the token `at`.
///
/// # Errors
/// Returns an error for an invalid value; a part of it may then remain among the tokens.
pub(super) fn read<'a>(
    entity: &Entity,
    word: &Word,
    at: Token<'a>,
    tokens: &mut Tokens<'a>,
) -> Result<Option<Value>, Diagnostic> {
    let takes = word.takes(entity);
    if let Takes::Name(_) | Takes::Path = takes {
        let name = name(entity, tokens);
        return name
            .map(|name| Some(Value::from(name)))
            .ok_or_else(|| no_name(word, takes, at.at));
    }
    let numbers = numbers(entity, takes, tokens);
    let attribute = Attribute::new(word.word, takes, "");
    check::value(&attribute, &numbers, at.at).map_err(|error| match word.role {
        Role::Mode => error.help("0 stretches the image over the plane, 1 repeats it"),
        _ => error,
    })
}

/// Takes a name, unless the token begins the next attribute or entity.
fn name<'a>(entity: &Entity, tokens: &mut Tokens<'a>) -> Option<&'a str> {
    let name = tokens.peek(0)?;
    let is_word = |token: Token<'_>| entity.word(token.text).is_some();
    // A name can equal an attribute's word. Then no value follows it.
    let next = tokens.peek(1);
    let word_with_value =
        is_word(name) && next.is_some_and(|next| !next.is_brace() && !is_word(next));
    if name.is_brace() || tokens.entity_begins() || word_with_value {
        return None;
    }
    tokens.next().map(|token| token.text)
}

fn no_name(word: &Word, takes: Takes, at: Location) -> Diagnostic {
    let expected = match (word.role, takes) {
        (Role::Texture, _) => "the name of a texture, or a file".to_owned(),
        (_, Takes::Path) => "the name of a file".to_owned(),
        (_, takes) => takes.words(),
    };
    Diagnostic::error(
        at,
        format!("`{}` has no value", word.word),
        format!("expected {expected}"),
    )
}

/// Takes all numbers that follow, and other tokens in the place of a number.
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
        raws.push((raw, token.at));
        tokens.next();
    }
    raws
}
