//! Lists as sentences have them.

/// Parts of a sentence with commas between them, and a word before the last: `a, b and c`.
#[must_use]
pub fn joined(parts: &[String], word: &str) -> String {
    match parts {
        [most @ .., last] if !most.is_empty() => format!("{} {word} {last}", most.join(", ")),
        _ => parts.concat(),
    }
}
