//! The arithmetic that decides what a ray meets.

/// Which algorithm and which numbers say where rays meet surfaces.
///
/// The classic ones are the chapter's own algorithm; they are kept so that tests and costs have
/// something to be measured against.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Numerics {
    /// No offset and no tolerance: a ray cannot meet the sheet that it leaves.
    #[default]
    Robust,
    /// The chapter's algorithm in world coordinates and 64-bit floats, with a small offset.
    Classic,
    /// The same in 32-bit floats.
    ClassicF32,
}

impl Numerics {
    /// All of them, the default first.
    pub const ALL: [Self; 3] = [Self::Robust, Self::Classic, Self::ClassicF32];
    /// Their words in a scene and on the command line, in the same order.
    pub const WORDS: [&'static str; 3] = ["robust", "classic", "classic-f32"];

    /// The word for it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Robust => Self::WORDS[0],
            Self::Classic => Self::WORDS[1],
            Self::ClassicF32 => Self::WORDS[2],
        }
    }

    /// The numerics with this word.
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|numerics| numerics.word() == word)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_means_its_own_numerics() {
        assert_eq!(
            Numerics::WORDS.map(Numerics::from_word),
            Numerics::ALL.map(Some)
        );
        assert_eq!(Numerics::from_word("exact"), None);
        assert_eq!(Numerics::default(), Numerics::ALL[0]);
    }
}
