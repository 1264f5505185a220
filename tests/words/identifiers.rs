//! Names in Rust code, without comments and texts.

use std::collections::BTreeSet;

/// All names in a piece of code.
pub(crate) fn identifiers(source: &str) -> BTreeSet<String> {
    let code = code(source);
    let words = code.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
    let names = words.filter(|word| {
        !word.is_empty() && !word.starts_with(|letter: char| letter.is_ascii_digit())
    });
    names.map(str::to_owned).collect()
}

/// The code alone, with a space in place of each comment, text and letter in quotes.
fn code(source: &str) -> String {
    let mut code = String::new();
    let mut rest = source;
    while let Some(letter) = rest.chars().next() {
        match length_of_text(rest, code.chars().last()) {
            0 => {
                code.push(letter);
                rest = &rest[letter.len_utf8()..];
            }
            length => {
                code.push(' ');
                rest = &rest[length..];
            }
        }
    }
    code
}

/// The bytes of the comment, text or quoted letter at the beginning of a source; 0 if it is code.
fn length_of_text(source: &str, before: Option<char>) -> usize {
    let until = |mark: &str, from: usize| {
        source[from..]
            .find(mark)
            .map_or(source.len(), |at| from + at + mark.len())
    };
    if source.starts_with("//") {
        return source.find('\n').unwrap_or(source.len());
    }
    if source.starts_with("/*") {
        return until("*/", 2);
    }
    let in_name = before.is_some_and(|letter| letter.is_alphanumeric() || letter == '_');
    if let Some(raw) = source
        .strip_prefix('r')
        .filter(|_| !in_name || before == Some('b'))
    {
        let hashes = &raw[..raw.len() - raw.trim_start_matches('#').len()];
        if raw[hashes.len()..].starts_with('"') {
            return until(&format!("\"{hashes}"), hashes.len() + 2);
        }
    }
    if source.starts_with('"') {
        return escaped(source, '"');
    }
    // A letter in quotes; otherwise the mark begins a lifetime.
    let mut letters = source
        .strip_prefix('\'')
        .map(str::chars)
        .into_iter()
        .flatten();
    match (letters.next(), letters.next()) {
        (Some('\\'), _) => escaped(source, '\''),
        (Some(letter), Some('\'')) => letter.len_utf8() + 2,
        _ => 0,
    }
}

/// The bytes up to the closing mark, past those behind a backslash.
fn escaped(source: &str, mark: char) -> usize {
    let mut is_escaped = false;
    for (at, letter) in source.char_indices().skip(1) {
        if is_escaped {
            is_escaped = false;
        } else if letter == '\\' {
            is_escaped = true;
        } else if letter == mark {
            return at + 1;
        }
    }
    source.len()
}

#[test]
fn names_are_found_in_code_only() {
    let source = r##"
        /// Comment::of
        fn one<'a>(two: &'a str) -> char { /* three */
            let four = "five \" six"; let seven = r#"eight " nine"#; let ten = b"eleven";
            if four == '\'' || seven == '"' { twelve("thirteen", 14) } else { 'x' }
        }
    "##;
    let found = identifiers(source);
    let found: Vec<_> = found.iter().map(String::as_str).collect();
    let expected = [
        "a", "b", "char", "else", "fn", "four", "if", "let", "one", "seven", "str", "ten",
        "twelve", "two",
    ];
    assert_eq!(found, expected);
}
