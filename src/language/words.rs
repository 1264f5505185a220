//! Words of closed sets in scenes and on the command line.

/// Implements `ALL`, `WORDS`, `word` and `from_word` for an enum.
///
/// `words!(BitDepth { Eight: "8", Sixteen: "16", Float: "float" })` gives each value the word that
/// scenes, messages and the command line use. A value without a word does not compile.
macro_rules! words {
    ($Set:ident { $($Value:ident: $word:literal),+ $(,)? }) => {
        impl $Set {
            /// All values.
            pub const ALL: [Self; [$($word),+].len()] = [$(Self::$Value),+];
            /// Their words, in the same order.
            pub const WORDS: [&'static str; Self::ALL.len()] = [$($word),+];

            /// The word in scenes and on the command line.
            #[must_use]
            pub const fn word(self) -> &'static str {
                match self {
                    $(Self::$Value => $word),+
                }
            }

            /// The value with this word.
            #[must_use]
            pub fn from_word(word: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|it| it.word() == word)
            }
        }
    };
}

pub(crate) use words;

#[cfg(test)]
mod tests {
    use crate::language::Reference;

    #[test]
    fn every_word_means_its_own_value() {
        assert_eq!(Reference::WORDS, ["material", "texture"]);
        assert_eq!(Reference::ALL, [Reference::Material, Reference::Texture]);
        assert_eq!(Reference::ALL.map(Reference::word), Reference::WORDS);
        let meant = Reference::WORDS.map(Reference::from_word);
        assert_eq!(meant, Reference::ALL.map(Some));
        assert_eq!(Reference::from_word("light"), None);
    }
}
