//! Options of the readers.

use super::course;
use crate::scene::Setting;

/// Options of the readers.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Options {
    /// The language; `None` to recognise it by content.
    pub language: Option<Language>,
    /// A picture size in pixels that replaces the scene's.
    pub size: Option<[u32; 2]>,
    /// Settings that replace the scene's.
    pub settings: Vec<Setting>,
}

/// The language of a scene file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Language {
    /// KDL 2 in the chapter's words.
    Kdl,
    /// The course's block grammar.
    Course,
}

impl Language {
    /// The language of a text, recognised by words that only course scenes have.
    #[must_use]
    pub fn of(text: &str) -> Self {
        if course::looks_like(text) {
            Self::Course
        } else {
            Self::Kdl
        }
    }
}
