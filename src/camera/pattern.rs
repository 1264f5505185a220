//! The patterns in which rays go through pixels.

/// How the rays through a pixel are spread over it.
///
/// Where the border of a thing crosses a pixel, the error of `N` rays falls as `N^-0.5` if they are
/// drawn at random, and as `N^-0.75` if they are spread evenly (Mitchell 1996, "Consequences of
/// stratified sampling in graphics").
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Pattern {
    /// One ray, through the centre.
    Center,
    /// Through the centre of each of as many cells as there are rays.
    Grid,
    /// Through a place drawn in each of the cells.
    #[default]
    Stratified,
    /// A Sobol sequence, scrambled for each pixel (Owen 1995): of any power of two of its places
    /// one lies in each cell, however the pixel is cut into as many equal ones.
    Sobol,
    /// Anywhere; for comparison.
    Random,
}

impl Pattern {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Center,
        Self::Grid,
        Self::Stratified,
        Self::Sobol,
        Self::Random,
    ];
    /// Their words in a scene and on the command line, in the same order.
    pub const WORDS: [&'static str; 5] = ["center", "grid", "stratified", "sobol", "random"];

    /// The word for it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Center => Self::WORDS[0],
            Self::Grid => Self::WORDS[1],
            Self::Stratified => Self::WORDS[2],
            Self::Sobol => Self::WORDS[3],
            Self::Random => Self::WORDS[4],
        }
    }

    /// The pattern with this word.
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|pattern| pattern.word() == word)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_means_its_own_pattern() {
        assert_eq!(
            Pattern::WORDS.map(Pattern::from_word),
            Pattern::ALL.map(Some)
        );
        assert_eq!(Pattern::from_word("halton"), None);
    }
}
