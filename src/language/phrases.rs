//! Phrases of messages: lists, and the nearest known word.

/// A list as text, with `word` before the last part: `a, b and c`.
#[must_use]
pub fn joined(parts: &[String], word: &str) -> String {
    match parts {
        [most @ .., last] if !most.is_empty() => format!("{} {word} {last}", most.join(", ")),
        _ => parts.concat(),
    }
}

/// The candidate nearest to a mistyped word.
///
/// `None` if more than a third of the letters of each candidate differ, counted by the
/// Damerau–Levenshtein distance without regard to case.
#[must_use]
pub fn did_you_mean<'a>(
    word: &str,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    const LONGEST: usize = 64;
    let length = word.chars().count();
    if length > LONGEST {
        return None;
    }
    let distance = |candidate: &str| {
        strsim::damerau_levenshtein(&word.to_lowercase(), &candidate.to_lowercase())
    };
    let near = candidates.into_iter().filter_map(|candidate| {
        let distance = distance(candidate);
        let longer = length.max(candidate.chars().count());
        (3 * distance <= longer).then_some((distance, candidate))
    });
    let nearest = near.min_by_key(|(distance, _)| *distance);
    nearest.map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::did_you_mean;

    #[test]
    fn a_typing_error_has_a_suggestion_and_another_word_has_none() {
        let words = ["sphere", "plane", "finite-plane"];
        assert_eq!(did_you_mean("shpere", words), Some("sphere"));
        assert_eq!(did_you_mean("Plane", words), Some("plane"));
        assert_eq!(did_you_mean("finite_plane", words), Some("finite-plane"));
        assert_eq!(did_you_mean("torus", words), None);
    }
}
