//! What can be wrong with an entity, in words.

use super::entities::ENTITIES;
use super::entity::Block;
use super::tokens::{Token, Tokens};
use super::words::Word;
use crate::language::{Location, Problem, Value, did_you_mean};

pub(super) fn stray_brace(tokens: &Tokens<'_>, brace: Token<'_>) -> Problem {
    let text = brace.text;
    let label = if text == "}" {
        "closes nothing"
    } else {
        "opens nothing"
    };
    Problem::error(
        tokens.at(brace),
        format!("there is a `{text}` too many"),
        label,
    )
    .help("an entity is written `word name { attributes }`")
}

pub(super) fn comment(tokens: &Tokens<'_>, token: Token<'_>) -> Problem {
    let label = "not an attribute, not an entity";
    Problem::error(
        tokens.at(token),
        "the course's grammar has no comments",
        label,
    )
    .help("remove it; a scene that is converted to KDL may have comments")
}

pub(super) fn unsupported(tokens: &Tokens<'_>, word: Token<'_>, instead: &str) -> Problem {
    let message = format!("`{}` is not supported yet", word.text);
    Problem::error(tokens.at(word), message, "cannot be drawn")
        .help(format!("remove it, or draw {instead} instead"))
}

pub(super) fn unknown_entity(tokens: &Tokens<'_>, word: Token<'_>) -> Problem {
    let message = format!("there is no entity `{}`", word.text);
    let problem = Problem::error(
        tokens.at(word),
        message,
        "not a word of the course's grammar",
    );
    let words = || ENTITIES.iter().map(|entity| entity.word);
    let same = ENTITIES
        .iter()
        .find(|entity| entity.schema.word == word.text);
    let suggestion = same
        .map(|entity| entity.word)
        .or_else(|| did_you_mean(word.text, words()));
    match suggestion {
        None => problem.help(format!(
            "there are {}",
            words().collect::<Vec<_>>().join(", ")
        )),
        suggestion => problem.suggest(suggestion),
    }
}

pub(super) fn nameless(tokens: &Tokens<'_>, word: Token<'_>) -> Problem {
    let text = word.text;
    Problem::error(
        tokens.at(word),
        format!("this `{text}` has no name"),
        "expected a name after it",
    )
    .help(format!("write, for example, `{text} {text}1 {{`"))
}

pub(super) fn not_opened(block: &Block) -> Problem {
    let message = format!("{} is not opened", called(block));
    Problem::error(block.head, message, "expected `{` after it")
}

pub(super) fn not_closed(tokens: &Tokens<'_>, block: &Block, next: Token<'_>) -> Problem {
    let message = format!("{} is not closed", called(block));
    Problem::error(tokens.at(next), message, "expected `}` before this")
        .help(format!("it begins in line {}", block.line))
}

pub(super) fn cut_short(tokens: &Tokens<'_>, block: &Block, word: Token<'_>) -> Problem {
    let message = format!("the file ends before {} is closed", called(block));
    let last = tokens.last().unwrap_or(word);
    Problem::error(tokens.at(last), message, "expected `}` after this").help(format!(
        "it begins in line {}; is a `}}` missing there, or the rest of the file?",
        block.line
    ))
}

/// An entity by its word and name.
fn called(block: &Block) -> String {
    let word = block.entity.word;
    match &block.name {
        Some(name) => format!("`{word} {name}`"),
        None => format!("this `{word}`"),
    }
}

pub(super) fn unknown_attribute(tokens: &Tokens<'_>, block: &Block, token: Token<'_>) -> Problem {
    let (entity, text) = (block.entity, token.text);
    let at = tokens.at(token);
    if let (Some(_), Some(before)) = (token.number(), block.given.last()) {
        let message = format!("`{}` is followed by a stray number", before.word.word);
        return Problem::error(at, message, "expected an attribute's word or `}`");
    }
    let message = format!("`{}` has no attribute `{text}`", entity.word);
    let problem = Problem::error(at, message, "not known here");
    let same = entity
        .words()
        .find(|word| word.means == text)
        .map(|word| word.word);
    let suggestion = same.or_else(|| did_you_mean(text, entity.words().map(|word| word.word)));
    let after_name = block
        .given
        .last()
        .is_some_and(|last| matches!(last.value, Some(Value::Text(_))));
    match suggestion {
        None if after_name => problem.help(format!(
            "it has {}; a name ends at the first space",
            listed(block)
        )),
        None => problem.help(format!("it has {}", listed(block))),
        suggestion => problem.suggest(suggestion),
    }
}

/// The attributes of an entity, each under its usual name.
fn listed(block: &Block) -> String {
    let mut words: Vec<&Word> = Vec::new();
    for word in block.entity.words() {
        if !words.iter().any(|known| known.means == word.means) {
            words.push(word);
        }
    }
    words
        .iter()
        .map(|word| word.word)
        .collect::<Vec<_>>()
        .join(", ")
}

pub(super) fn twice(word: &Word, earlier: &Word, at: Location) -> Problem {
    let message = if word.word == earlier.word {
        format!("`{}` is given twice", word.word)
    } else {
        format!("`{}` and `{}` mean the same", earlier.word, word.word)
    };
    Problem::error(at, message, "the second time").help("keep one of them")
}

pub(super) fn missing(block: &Block, words: &[&str]) -> Problem {
    let quoted: Vec<_> = words.iter().map(|word| format!("`{word}`")).collect();
    let message = format!("this `{}` lacks {}", block.entity.word, quoted.join(", "));
    Problem::error(block.head, message, "expected between its braces")
}
