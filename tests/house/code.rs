//! Rust code without what is no code.

/// The code alone, with a space in place of each comment, text and letter in quotes; lines stay
/// lines.
pub(crate) fn code_of(source: &str) -> String {
    let mut code = String::new();
    let mut rest = source;
    while let Some(letter) = rest.chars().next() {
        let length = length_of_text(rest, code.chars().last());
        if length == 0 {
            code.push(letter);
            rest = &rest[letter.len_utf8()..];
        } else {
            code.push(' ');
            code.extend(rest[..length].chars().filter(|c| *c == '\n'));
            rest = &rest[length..];
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

/// The code without what is made for tests only.
pub(crate) fn without_tests(code: &str) -> String {
    const MARK: &str = "#[cfg(test)]";
    let Some((before, after)) = code.split_once(MARK) else {
        return code.to_owned();
    };
    let mut depth = 0;
    for (index, c) in after.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 && (c == '}' || c == ';') {
            return format!("{before}{}", without_tests(&after[index + 1..]));
        }
    }
    before.to_owned()
}
