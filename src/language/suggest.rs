//! "Did you mean …?"

/// The candidate nearest to a mistyped word, if one is near enough to be meant.
///
/// Near enough: at most a third of the letters wrong (Damerau–Levenshtein distance).
#[must_use]
pub fn did_you_mean<'a>(
    word: &str,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    const LONGEST: usize = 64;
    if word.chars().count() > LONGEST {
        return None;
    }
    let wrong = |candidate: &str| {
        strsim::damerau_levenshtein(&word.to_lowercase(), &candidate.to_lowercase())
    };
    let letters = |candidate: &str| word.chars().count().max(candidate.chars().count());
    candidates
        .into_iter()
        .map(|candidate| (wrong(candidate), candidate))
        .filter(|(wrong, candidate)| 3 * wrong <= letters(candidate))
        .min_by_key(|(wrong, _)| *wrong)
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::did_you_mean;

    #[test]
    fn a_slip_is_understood_and_another_word_is_not() {
        let words = ["sphere", "plane", "finite-plane"];
        assert_eq!(did_you_mean("shpere", words), Some("sphere"));
        assert_eq!(did_you_mean("Plane", words), Some("plane"));
        assert_eq!(did_you_mean("finite_plane", words), Some("finite-plane"));
        assert_eq!(did_you_mean("torus", words), None);
    }
}
