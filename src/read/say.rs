//! Wording that the messages of the readers share.

use crate::language::joined;

/// A word or a text in a message, shortened, with invisible characters escaped.
pub(super) fn shown(text: &str) -> String {
    const LONGEST: usize = 40;
    let mut shown = String::new();
    for character in text.chars().take(LONGEST) {
        let escaped = character.escape_debug();
        if character == '\\' || escaped.len() <= 2 && !character.is_control() {
            shown.push(character);
        } else {
            shown.extend(escaped);
        }
    }
    if text.chars().nth(LONGEST).is_some() {
        shown.push('…');
    }
    shown
}

/// A text in quotes.
pub(super) fn quoted(text: &str) -> String {
    format!("\"{}\"", shown(text))
}

/// Words of the scene language: `` `a`, `b` and `c` ``.
pub(super) fn words<'a>(words: impl IntoIterator<Item = &'a str>) -> String {
    let words: Vec<_> = words.into_iter().map(|word| format!("`{word}`")).collect();
    joined(&words, "and")
}

/// Names of a scene in quotes, at most eight: `"a", "b" and others`.
pub(super) fn names(names: &[&str]) -> String {
    const MOST: usize = 8;
    let mut shown: Vec<_> = names.iter().take(MOST).map(|name| quoted(name)).collect();
    if names.len() > MOST {
        shown.push("others".to_owned());
    }
    joined(&shown, "and")
}

/// A number up to six in words, others in digits: `two`, `12`.
pub(super) fn count(count: usize) -> String {
    const WORDS: [&str; 7] = ["none", "one", "two", "three", "four", "five", "six"];
    WORDS
        .get(count)
        .map_or_else(|| count.to_string(), |word| (*word).to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_read_like_prose() {
        assert_eq!(words([]), "");
        assert_eq!(words(["a"]), "`a`");
        assert_eq!(words(["a", "b", "c"]), "`a`, `b` and `c`");
        assert_eq!(names(&["a", "b"]), "\"a\" and \"b\"");
        assert!(names(&["a"; 9]).ends_with("\"a\" and others"));
    }

    #[test]
    fn long_and_invisible_texts_are_shown_all_the_same() {
        assert_eq!(shown("a\u{1b}[31m\n"), "a\\u{1b}[31m\\n");
        assert_eq!(shown("1\u{200e} \"ä\\'"), "1\\u{200e} \"ä\\'");
        assert_eq!(shown(&"ä".repeat(41)), format!("{}…", "ä".repeat(40)));
    }
}
