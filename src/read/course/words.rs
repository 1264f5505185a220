//! The course's words, and their meanings in the scene language.

use crate::language::{Schema, Takes};

/// A kind of entity.
#[derive(Debug)]
pub(super) struct Entity {
    /// Its word.
    pub(super) word: &'static str,
    /// The kind of its node.
    pub(super) schema: &'static Schema,
    /// The kind of its node if an attribute is missing: the attribute and the kind.
    pub(super) without: Option<(&'static str, &'static Schema)>,
    words: &'static [&'static [Word]],
}

/// An attribute of a kind of entity.
#[derive(Debug)]
pub(super) struct Word {
    /// Its word.
    pub(super) word: &'static str,
    /// Its meaning: the attribute of the schema.
    pub(super) means: &'static str,
    /// The use of its value.
    pub(super) role: Role,
    /// The type of its value, if it differs from the schema's.
    takes: Option<Takes>,
    /// True if it must be given.
    pub(super) required: bool,
}

/// The use of an attribute's value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// An attribute of the node.
    Attribute,
    /// The picture's size.
    PictureSize,
    /// The file of a texture.
    File,
    /// A texture's name, or a file.
    Texture,
    /// The number of a texture mode.
    Mode,
    /// The number of a formula.
    Shader,
    /// None: other attributes have the same information.
    Ignored,
}

impl Entity {
    pub(super) const fn new(
        word: &'static str,
        schema: &'static Schema,
        words: &'static [&'static [Word]],
    ) -> Self {
        Self {
            word,
            schema,
            without: None,
            words,
        }
    }

    /// The same entity with another kind of node if an attribute is missing.
    pub(super) const fn without(self, word: &'static str, schema: &'static Schema) -> Self {
        Self {
            without: Some((word, schema)),
            ..self
        }
    }

    /// Its attributes.
    pub(super) fn words(&self) -> impl Iterator<Item = &'static Word> {
        self.words.iter().copied().flatten()
    }

    /// The attribute with this word.
    pub(super) fn word(&self, word: &str) -> Option<&'static Word> {
        self.words().find(|known| known.word == word)
    }
}

impl Word {
    pub(super) const fn new(word: &'static str) -> Self {
        Self {
            word,
            means: word,
            role: Role::Attribute,
            takes: None,
            required: true,
        }
    }

    pub(super) const fn optional(self) -> Self {
        Self {
            required: false,
            ..self
        }
    }

    pub(super) const fn means(self, means: &'static str) -> Self {
        Self { means, ..self }
    }

    pub(super) const fn takes_a(self, takes: Takes) -> Self {
        Self {
            takes: Some(takes),
            ..self
        }
    }

    pub(super) const fn role(self, role: Role) -> Self {
        Self { role, ..self }
    }

    /// The type of its value.
    pub(super) fn takes(&self, entity: &Entity) -> Takes {
        let known = entity
            .schema
            .all_attributes()
            .find(|known| known.word == self.means);
        self.takes
            .or(known.map(|known| known.takes))
            .unwrap_or(Takes::Nothing)
    }
}
