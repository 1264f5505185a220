//! Entities of a text: `word name { attributes }`.

use super::words::{Entity, Word};
use crate::language::{Location, Value};

/// An entity of a text.
#[derive(Debug)]
pub(super) struct Block {
    /// Its kind.
    pub(super) entity: &'static Entity,
    /// Its name.
    pub(super) name: Option<String>,
    /// Its attributes.
    pub(super) given: Vec<Given>,
    /// The place of its word and name.
    pub(super) head: Location,
    /// The line of its word, from 1.
    pub(super) line: usize,
    /// False if it has an error.
    pub(super) valid: bool,
    /// True if an error may have hidden an attribute.
    pub(super) incomplete: bool,
}

/// An attribute of a text.
#[derive(Debug)]
pub(super) struct Given {
    /// Its kind.
    pub(super) word: &'static Word,
    /// Its value; `None` if it has an error.
    pub(super) value: Option<Value>,
    /// Its place, from its word to the end of its value.
    pub(super) at: Location,
}

impl Block {
    /// The attribute with a meaning.
    pub(super) fn find(&self, means: &str) -> Option<&Given> {
        self.given.iter().find(|given| given.word.means == means)
    }

    /// The value of the attribute with a meaning.
    pub(super) fn value(&self, means: &str) -> Option<&Value> {
        self.find(means).and_then(|given| given.value.as_ref())
    }

    /// Word and name in quotes, for messages.
    pub(super) fn title(&self) -> String {
        let word = self.entity.word;
        match &self.name {
            Some(name) => format!("`{word} {name}`"),
            None => format!("this `{word}`"),
        }
    }
}
