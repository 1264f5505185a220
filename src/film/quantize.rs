//! From values between code values to one of them.

/// How a value between two code values becomes one of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rounding {
    /// To the nearest code value, halves upward.
    #[default]
    Nearest,
    /// To the next lower one, as the course's programs did.
    Truncate,
}

impl Rounding {
    /// All of them, the default first.
    pub const ALL: [Self; 2] = [Self::Nearest, Self::Truncate];
    /// Their words in a scene and on the command line, in the same order.
    pub const WORDS: [&'static str; 2] = ["round", "truncate"];

    /// The word for it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Nearest => Self::WORDS[0],
            Self::Truncate => Self::WORDS[1],
        }
    }

    /// The rounding with this word.
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        let mut all = Self::ALL.into_iter();
        all.find(|rounding| rounding.word() == word)
    }

    /// The smallest value that becomes a code, in units of half a code.
    pub(super) fn halves(self, code: u16) -> u32 {
        match self {
            Self::Nearest => (2 * u32::from(code)).saturating_sub(1),
            Self::Truncate => 2 * u32::from(code),
        }
    }
}
