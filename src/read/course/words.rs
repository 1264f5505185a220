//! The course's words and what they are in the scene language.

use super::entities::ENTITIES;
use crate::language::{Schema, Takes};

/// One kind of entity.
#[derive(Debug)]
pub(super) struct Entity {
    /// Its word.
    pub(super) word: &'static str,
    /// The kind of node that it is.
    pub(super) schema: &'static Schema,
    /// The kind of node that it is without a certain attribute of that schema.
    pub(super) without: Option<(&'static str, &'static Schema)>,
    words: &'static [&'static [Word]],
}

/// One attribute of an entity.
#[derive(Debug)]
pub(super) struct Word {
    /// Its word.
    pub(super) word: &'static str,
    /// The attribute of the schema that it is or belongs to.
    pub(super) means: &'static str,
    /// What becomes of its value.
    pub(super) role: Role,
    /// The type of its value, if it is not that of the schema.
    takes: Option<Takes>,
    /// Whether the entity makes no sense without it.
    pub(super) needed: bool,
}

/// What becomes of an attribute's value.
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
    /// The number of a way to lay a texture over a plane.
    Mode,
    /// The number of a formula.
    Shader,
    /// Nothing: other attributes say the same.
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

    /// The same entity, which is a node of this kind without a certain attribute.
    pub(super) const fn without(self, word: &'static str, schema: &'static Schema) -> Self {
        Self {
            without: Some((word, schema)),
            ..self
        }
    }

    /// The kind with this word.
    pub(super) fn find(word: &str) -> Option<&'static Self> {
        ENTITIES.iter().find(|entity| entity.word == word)
    }

    /// The attributes that it may have.
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
            needed: true,
        }
    }

    pub(super) const fn optional(self) -> Self {
        Self {
            needed: false,
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
