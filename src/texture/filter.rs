//! How the texels that a pixel covers become one colour.

/// What is seen of a texture in a pixel.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Filter {
    /// The texel that the ray meets: the chapter's.
    #[default]
    Nearest,
    /// Between the four texels whose middles are nearest.
    Bilinear,
    /// As large as what the pixel covers, from a pyramid of smaller images (Williams 1983, "Pyramidal
    /// Parametrics").
    Mipmap,
    /// Several such colours along the longer axis of what the pixel covers.
    Anisotropic,
    /// The mean over the area that the pixel covers.
    Exact,
}

impl Filter {
    /// All of them, the default first.
    pub const ALL: [Self; 5] = [
        Self::Nearest,
        Self::Bilinear,
        Self::Mipmap,
        Self::Anisotropic,
        Self::Exact,
    ];
    /// Their words in a scene and on the command line, in the same order.
    pub const WORDS: [&'static str; 5] = ["nearest", "bilinear", "mipmap", "anisotropic", "exact"];

    /// The word for it.
    #[must_use]
    pub fn word(self) -> &'static str {
        let number = match self {
            Self::Nearest => 0,
            Self::Bilinear => 1,
            Self::Mipmap => 2,
            Self::Anisotropic => 3,
            Self::Exact => 4,
        };
        Self::WORDS[number]
    }

    /// The filter with this word.
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|filter| filter.word() == word)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_means_its_own_filter() {
        assert_eq!(Filter::WORDS.map(Filter::from_word), Filter::ALL.map(Some));
        assert_eq!(Filter::from_word("trilinear"), None);
        assert_eq!(Filter::default(), Filter::ALL[0]);
    }
}
