//! The first word of a paragraph: question words and "Of" do not open a statement.

use super::inline::words_alone;
use super::sentences::sentences;

/// Words that open a clause in place of a noun; "when" is judged by the comma after its clause.
const QUESTION_WORDS: [&str; 11] = [
    "what",
    "how",
    "where",
    "which",
    "why",
    "who",
    "whatever",
    "whoever",
    "whichever",
    "wherever",
    "of",
];

/// Whether a paragraph opens with a question word and is not a question.
pub(crate) fn opens_badly(paragraph: &str) -> bool {
    let text = words_alone(paragraph);
    let text =
        text.trim_matches(|letter: char| letter.is_whitespace() || "*_\"'“‘(".contains(letter));
    if text.ends_with('?') {
        return false;
    }
    let word: String = text
        .chars()
        .take_while(|letter| letter.is_alphabetic())
        .collect();
    let word = word.to_lowercase();
    let is_clause = || {
        let first = sentences(text).first().map_or("", |sentence| sentence.text);
        first.contains(',')
    };
    QUESTION_WORDS.contains(&word.as_str()) || word == "when" && !is_clause()
}

#[test]
fn openings_are_judged() {
    for bad in [
        "What is left out knows …",
        "**Where** it stands.",
        "how a colour comes about",
        "Of surfaces in one plane, the first is seen.",
        "When a rung is done.",
        "[Which is best](a.md) tells more.",
        "Whatever it is. Is it?  It is.",
    ] {
        assert!(opens_badly(bad), "{bad}");
    }
    for good in [
        "What is a heliodon?",
        "The way in which it stands.",
        "Whether a ray hits.",
        "`what` is a word of the language.",
        "When a run ends, its file is complete. It stays.",
        "Offsets are kept.",
        "However, it is not.",
    ] {
        assert!(!opens_badly(good), "{good}");
    }
}
