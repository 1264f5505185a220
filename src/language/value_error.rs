//! Errors of constructors that build parts of a scene.

use std::fmt;

/// An invalid value of an attribute.
///
/// It names the attribute, so that a reader can point at its place in the scene file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ValueError {
    /// The word of the attribute.
    pub word: &'static str,
    /// The error, as a sentence without a full stop.
    pub reason: String,
    /// Advice.
    pub advice: String,
    /// The expected value, if the attribute's type does not say it.
    pub expected: Option<String>,
}

impl ValueError {
    /// An error in the attribute `word`.
    pub fn new(word: &'static str, reason: impl Into<String>, advice: impl Into<String>) -> Self {
        Self {
            word,
            reason: reason.into(),
            advice: advice.into(),
            expected: None,
        }
    }

    /// The same error with the expected value.
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
