//! Why a part of a scene cannot exist.

use std::fmt;

/// What a constructor says when its arguments make no sense together.
///
/// It names the attribute at fault, so that a reader can point at it in the scene file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ValueError {
    /// The word of the attribute at fault.
    pub word: &'static str,
    /// What is wrong, as a sentence without a full stop.
    pub reason: String,
    /// What to do about it.
    pub advice: String,
    /// What was expected there, if it is more than the attribute's type.
    pub expected: Option<String>,
}

impl ValueError {
    /// A refusal of the attribute `word`.
    pub fn new(word: &'static str, reason: impl Into<String>, advice: impl Into<String>) -> Self {
        Self {
            word,
            reason: reason.into(),
            advice: advice.into(),
            expected: None,
        }
    }

    /// The same refusal, which says what was expected.
    #[must_use]
    pub fn expected(self, expected: impl Into<String>) -> Self {
        Self {
            expected: Some(expected.into()),
            ..self
        }
    }
}

impl fmt::Display for ValueError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}: {}", self.word, self.reason)
    }
}

impl std::error::Error for ValueError {}
