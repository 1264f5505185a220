//! Errors in entities.

use super::block::Block;
use super::entities::{ENTITIES, UNSUPPORTED};
use super::tokens::Token;
use super::words::Word;
use crate::language::{Diagnostic, Location, Value, did_you_mean};
use crate::read::say;

pub(super) fn stray_brace(brace: Token<'_>) -> Diagnostic {
    let text = brace.text;
    let label = if text == "}" {
        "closes nothing"
    } else {
        "opens nothing"
    };
    Diagnostic::error(brace.at, format!("there is a `{text}` too many"), label)
        .help("an entity is written `word name { attributes }`")
}

pub(super) fn comment(token: Token<'_>) -> Diagnostic {
    let message = "the course's grammar has no comments";
    Diagnostic::error(token.at, message, "not an attribute, not an entity")
        .help("remove it; a scene that is converted to KDL may have comments")
}

pub(super) fn unknown_entity(word: Token<'_>) -> Diagnostic {
    let text = word.text;
    if let Some((_, instead)) = UNSUPPORTED.iter().find(|(known, _)| *known == text) {
        let message = format!("`{text}` is not supported yet");
        return Diagnostic::error(word.at, message, "cannot be drawn")
            .help(format!("remove it, or draw {instead} instead"));
    }
    let message = format!("there is no entity `{text}`");
    let error = Diagnostic::error(word.at, message, "not a word of the course's grammar");
    let words = || ENTITIES.iter().map(|entity| entity.word);
    let equivalent = ENTITIES.iter().find(|entity| entity.schema.word == text);
    let equivalent = equivalent.map(|entity| entity.word);
    match equivalent.or_else(|| did_you_mean(text, words())) {
        None => error.help(format!("the entities are {}", say::words(words()))),
        suggestion => error.suggest(suggestion),
    }
}

pub(super) fn nameless(word: Token<'_>) -> Diagnostic {
    let text = word.text;
    let message = format!("this `{text}` has no name");
    Diagnostic::error(word.at, message, "expected a name after it")
        .help(format!("write, for example, `{text} {text}1 {{`"))
}

pub(super) fn not_opened(block: &Block) -> Diagnostic {
    let message = format!("{} is not opened", block.title());
    Diagnostic::error(block.head, message, "expected `{` after it")
}

pub(super) fn not_closed(block: &Block, next: Token<'_>) -> Diagnostic {
    let message = format!("{} is not closed", block.title());
    Diagnostic::error(next.at, message, "expected `}` before this")
        .help(format!("it begins in line {}", block.line))
}

pub(super) fn cut_short(block: &Block, last: Token<'_>) -> Diagnostic {
    let message = format!("the file ends before {} is closed", block.title());
    Diagnostic::error(last.at, message, "expected `}` after this").help(format!(
        "it begins in line {}; is a `}}` missing there, or the rest of the file?",
        block.line
    ))
}

pub(super) fn unknown_attribute(block: &Block, token: Token<'_>) -> Diagnostic {
    let (entity, text) = (block.entity, token.text);
    let last = block.given.last();
    if let (Some(_), Some(last)) = (token.number(), last) {
        let message = format!("a number follows the value of `{}`", last.word.word);
        return Diagnostic::error(token.at, message, "expected an attribute's word or `}`");
    }
    let message = format!("`{}` has no attribute `{text}`", entity.word);
    let error = Diagnostic::error(token.at, message, "not known here");
    let equivalent = entity.words().find(|word| word.means == text);
    let equivalent = equivalent.map(|word| word.word);
    let words = entity.words().map(|word| word.word);
    match equivalent.or_else(|| did_you_mean(text, words)) {
        None => {
            let is_after_text = last.is_some_and(|it| matches!(it.value, Some(Value::Text(_))));
            let advice = if is_after_text {
                "; a name ends at the first space"
            } else {
                ""
            };
            error.help(format!("it has {}{advice}", attributes(block)))
        }
        suggestion => error.suggest(suggestion),
    }
}

/// The attributes of an entity, each with its usual word.
fn attributes(block: &Block) -> String {
    let mut usual: Vec<&Word> = Vec::new();
    for word in block.entity.words() {
        if !usual.iter().any(|known| known.means == word.means) {
            usual.push(word);
        }
    }
    say::words(usual.iter().map(|word| word.word))
}

pub(super) fn twice(word: &Word, earlier: &Word, at: Location) -> Diagnostic {
    let message = if word.word == earlier.word {
        format!("`{}` is given twice", word.word)
    } else {
        format!("`{}` and `{}` mean the same", earlier.word, word.word)
    };
    Diagnostic::error(at, message, "the second time").help("keep one of them")
}

pub(super) fn missing(block: &Block, words: &[&str]) -> Diagnostic {
    let words = say::words(words.iter().copied());
    let message = format!("this `{}` lacks {words}", block.entity.word);
    Diagnostic::error(block.head, message, "expected between its braces")
}
