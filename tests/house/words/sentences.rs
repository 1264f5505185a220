//! Sentences and their lengths.

use super::inline::Span;

/// Words whose full stop does not end a sentence.
const ABBREVIATIONS: [&str; 12] = [
    "e.g", "i.e", "cf", "vs", "etc", "fig", "sec", "eq", "approx", "resp", "no", "al",
];

/// The sentences of a text; a full stop ends one if a space follows it.
pub(crate) fn sentences(text: &str) -> Vec<Span<'_>> {
    let mut found = Vec::new();
    let mut start = 0;
    for (at, mark) in text
        .char_indices()
        .filter(|(_, letter)| ".!?".contains(*letter))
    {
        let after = &text[at + mark.len_utf8()..];
        let rest = after.trim_start_matches(|letter: char| ")\"'”’*_".contains(letter));
        let ends = rest.is_empty() || rest.starts_with(char::is_whitespace);
        if at >= start && ends && !is_abbreviated(&text[start..at], rest) {
            let end = text.len() - rest.len();
            push(&mut found, text, start, end);
            start = end;
        }
    }
    push(&mut found, text, start, text.len());
    found
}

fn push<'a>(found: &mut Vec<Span<'a>>, text: &'a str, start: usize, end: usize) {
    let sentence = &text[start..end];
    let offset = end - sentence.trim_start().len();
    let text = sentence.trim();
    if !text.is_empty() {
        found.push(Span { offset, text });
    }
}

/// Whether the full stop between two texts belongs to a short form such as "e.g." or "M. Pharr".
fn is_abbreviated(before: &str, after: &str) -> bool {
    let word = before
        .rsplit(|letter: char| letter.is_whitespace() || "(*_".contains(letter))
        .next()
        .unwrap_or_default();
    let is_initial = word.len() == 1 && word.chars().all(char::is_uppercase);
    let known = ABBREVIATIONS.contains(&word.to_lowercase().as_str());
    let goes_on = after
        .trim_start()
        .starts_with(|letter: char| letter.is_lowercase() || letter.is_ascii_digit());
    // "etc." and "no." end a sentence if a capital follows; an initial is followed by one.
    is_initial || known && (goes_on || word.contains('.'))
}

/// The number of words; signs that stand alone are not words.
pub(crate) fn count_words(sentence: &str) -> usize {
    sentence
        .split_whitespace()
        .filter(|word| word.contains(char::is_alphanumeric))
        .count()
}

#[test]
fn sentences_end_at_full_stops() {
    let texts = |text| {
        sentences(text)
            .iter()
            .map(|sentence| sentence.text)
            .collect::<Vec<_>>()
    };
    assert_eq!(
        texts("One. Two! Three? Four"),
        ["One.", "Two!", "Three?", "Four"]
    );
    assert_eq!(
        texts("It is 0.5 (see e.g. the table). Next."),
        ["It is 0.5 (see e.g. the table).", "Next."]
    );
    assert_eq!(
        texts("**Bold.** Then *it.* ends"),
        ["**Bold.**", "Then *it.*", "ends"]
    );
    assert_eq!(
        texts("By M. Pharr et al. 2016. Yes."),
        ["By M. Pharr et al. 2016.", "Yes."]
    );
    assert_eq!(texts("A, b etc. Then."), ["A, b etc.", "Then."]);
    assert_eq!(
        texts("Version 1.95\nis 1.\nNext"),
        ["Version 1.95\nis 1.", "Next"]
    );
    assert_eq!(sentences("One.\n Two.")[1].offset, 6);
}

#[test]
fn words_are_counted() {
    assert_eq!(count_words("*v* = 12.92 *x*, up to\nthe 1/2 – point."), 8);
    assert_eq!(count_words("… + –"), 0);
}
