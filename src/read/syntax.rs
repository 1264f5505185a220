//! Messages about texts that are not valid KDL.
//!
//! The tests pin the English sentences of the `kdl` crate that are matched here.

use super::pieces::Mistake;
use super::say;
use crate::language::{Diagnostic, Location, did_you_mean};

/// The error for a brace, a quote or a comment.
pub(super) fn mistake(mistake: Mistake, at: Location) -> Diagnostic {
    let (message, label, help) = match mistake {
        Mistake::OpenBrace => (
            "a brace is not closed",
            "there is no `}` for this one",
            "add a `}` where the node ends",
        ),
        Mistake::StrayBrace => (
            "a brace closes nothing",
            "there is no `{` for this one",
            "remove it, or add the `{` that it should close",
        ),
        Mistake::LooseBrace => (
            "a brace opens after nothing",
            "expected a node's word before it",
            "the `{` stands on the same line as its node: `plane {`",
        ),
        Mistake::OpenText => (
            "a text is not closed",
            "expected a quote at its end",
            "close it on the same line; a text of several lines stands in `\"\"\"`",
        ),
        Mistake::OpenComment => (
            "a comment is not closed",
            "there is no `*/` for this one",
            "add a `*/` where the comment ends",
        ),
        Mistake::OpenSlashdash => SLASHDASH,
        Mistake::TooDeep => (
            "the text is nested too deeply",
            "one level too many",
            "a scene needs no more than two levels; is a `}` missing?",
        ),
    };
    Diagnostic::error(at, message, label).help(help)
}

/// True if the `kdl` crate reports an open brace.
pub(super) fn is_open_brace(said: &str) -> bool {
    said.contains("losing '}'")
}

/// The error at a place where the `kdl` crate reports one.
///
/// `text` is the whole text, `said` the message and label of the crate.
pub(super) fn error(text: &str, at: Location, mut said: &str) -> Diagnostic {
    let mut at = at;
    let pointed = &text[at.start..at.start + at.length];
    at.start += pointed.len() - pointed.trim_start().len();
    if said.contains("property value") {
        // The crate points to everything from the node on. The value is at the end.
        let property = pointed.trim_end();
        let start = property
            .rfind(char::is_whitespace)
            .map_or(0, |space| space + 1);
        let key = property[start..]
            .find('=')
            .filter(|key| start + key + 1 < property.len());
        at.start += start + key.map_or(0, |key| key + 1);
        said = if key.is_some() { "" } else { said };
    }
    let rest = &text[at.start..];
    let token = rest.split(char::is_whitespace).next().unwrap_or_default();
    let length = match token.find([';', '}']) {
        Some(end) if end > 0 => end,
        _ => token.len(),
    };
    let token = &token[..length];
    at.length = length;
    let before = text[..at.start].trim_end_matches([' ', '\t']);
    let (message, label, help) = explained(token, before, said);
    Diagnostic::error(at, message, label).help(help)
}

const SLASHDASH: (&str, &str, &str) = (
    "a `/-` comments out nothing",
    "expected something after it",
    "it stands before the node, the value or the braces that it comments out",
);

const SPACES: &str = "numbers are separated by spaces alone: `0 1 0`";

/// Message, label and help for an invalid token.
fn explained(token: &str, before: &str, said: &str) -> (String, String, String) {
    let shown = say::shown(token);
    let is_name = said.contains("node name");
    let say = |message: &str, label: &str, help: &str| {
        (message.to_owned(), label.to_owned(), help.to_owned())
    };
    let first = token.chars().next().unwrap_or_default();
    let digits = token.trim_start_matches(['+', '-']);
    let unpointed = digits.strip_prefix('.').unwrap_or(digits);
    match first {
        _ if token.is_empty() => say(
            "a node is not complete",
            "expected more before this",
            "complete it, or remove it",
        ),
        _ if said.contains("property value") => say(
            "a property has no value",
            "expected a value after the `=`",
            "write the value right after the `=`: `samples=4`",
        ),
        _ if before.ends_with('}') => say(
            "a node goes on after its `}`",
            "expected a new line before this",
            "begin each node on its own line, or put a `;` before it",
        ),
        '=' => say(
            "`=` does not belong here",
            "expected a value",
            "attributes are written without `=`: `radius 2`",
        ),
        '{' => say(
            "a brace opens after nothing",
            "expected a node's word before it",
            "the `{` stands on the same line as its node: `plane {`",
        ),
        '(' | ')' | '[' | ']' | ',' => say(
            &format!("`{first}` does not belong here"),
            "expected a word, a number or a text",
            SPACES,
        ),
        '"' | '#' if token.contains("\"\"\"") || said.contains("ulti") => say(
            "a text of several lines is not written right",
            "expected a new line after the `\"\"\"`, and equal indentation",
            "the text begins on the line below the first `\"\"\"`, \
             and is indented like the last one at least",
        ),
        '"' if token.contains('\\') => say(
            "a `\\` in a text means nothing here",
            "expected a known escape, such as `\\\\`",
            "write `/` in file names, and `\\\\` for a backslash",
        ),
        '"' => say(
            "a text runs into what follows it",
            "expected a space after the closing quote",
            "put a space there; a quote within a text is written `\\\"`",
        ),
        '#' if token == "#" => say(
            "`#` does not belong here",
            "expected a node, or `//` before a comment",
            "comments begin with `//`",
        ),
        '/' if token.starts_with("/-") => say(SLASHDASH.0, SLASHDASH.1, SLASHDASH.2),
        '#' => say(
            &format!("`{shown}` is not a value"),
            "expected #true, #false, a number or a text",
            &match did_you_mean(token, ["#true", "#false"]) {
                Some(meant) => format!("did you mean {meant}?"),
                None => "yes and no are written #true and #false".to_owned(),
            },
        ),
        '\\' => say(
            "a `\\` does not belong here",
            "expected nothing after it on this line",
            "a `\\` at the end of a line joins the next line to it",
        ),
        _ if is_name && digits.starts_with(|c: char| c.is_ascii_digit()) => say(
            "a node begins with a number",
            "expected a word",
            "is a `\\` missing at the end of the line above?",
        ),
        _ if unpointed.starts_with(|c: char| c.is_ascii_digit()) => number(token, digits),
        _ => word(token, &shown),
    }
}

const INVISIBLE: &str = "is there an invisible character in it? type it again";

/// The error for a token that begins like a number.
fn number(token: &str, digits: &str) -> (String, String, String) {
    let help = if token.contains(',') {
        SPACES.to_owned()
    } else if digits.starts_with('.') && token.parse::<f64>().is_ok() {
        format!(
            "write a digit before the point: `{}`",
            token.replacen('.', "0.", 1)
        )
    } else if token.ends_with('.') && token.parse::<f64>().is_ok() {
        format!("write a digit after the point: `{token}0`")
    } else if digits.bytes().all(|byte| byte.is_ascii_digit()) {
        let message = format!("`{}` is too large", say::shown(token));
        let help = "write numbers as large as this with an exponent: `1e50`";
        return (
            message,
            "expected a smaller number".to_owned(),
            help.to_owned(),
        );
    } else if !token.is_ascii() {
        INVISIBLE.to_owned()
    } else {
        "numbers are written like 2, -0.5 or 1e-3, and without a unit".to_owned()
    };
    let message = format!("`{}` is not a number", say::shown(token));
    (message, "expected a number".to_owned(), help)
}

/// The error for another token.
fn word(token: &str, shown: &str) -> (String, String, String) {
    let (label, help) = if let "true" | "false" = token {
        (
            "expected a `#` before it",
            format!("did you mean `#{token}`?"),
        )
    } else if let "inf" | "-inf" | "nan" = token {
        let help = "there are no infinite numbers in scenes; a name like this needs quotes";
        ("expected a finite number", help.to_owned())
    } else if let Some((word, _)) = token.split_once('"') {
        let help = format!("put a space after `{}`", say::shown(word));
        ("expected a space before the quote", help)
    } else if token.contains(char::is_control) || !token.is_ascii() {
        ("expected a word, a number or a text", INVISIBLE.to_owned())
    } else {
        let help = format!("a text with such characters needs quotes: `\"{shown}\"`");
        ("expected a word, a number or a text in quotes", help)
    };
    (
        format!("`{shown}` is not understood"),
        label.to_owned(),
        help,
    )
}

#[cfg(test)]
mod tests {
    use kdl::KdlNode;

    /// Message and label of each diagnostic of the crate.
    fn said(text: &str) -> Vec<(String, String)> {
        let error = text.parse::<KdlNode>().expect_err("no valid node");
        let diagnostics = error.diagnostics.into_iter();
        diagnostics
            .map(|it| (it.message.unwrap_or_default(), it.label.unwrap_or_default()))
            .collect()
    }

    /// A new version of the crate may word them differently; then the messages here are worse.
    #[test]
    fn the_matched_sentences_are_those_of_the_kdl_crate() {
        let sentences = [
            ("a { b 1, 2 }", "Expected integer", "not integer"),
            ("a b=", "Expected property value", "not property value"),
            ("a { 1 2 }", "Found invalid node name", "not node name"),
            (
                "a \"\"\"b\"\"\"",
                "Multi-line string opening quotes must be immediately followed by a newline",
                "not quoted string",
            ),
            (
                "a \"\"\"\n  b\n c\n  \"\"\"",
                "matching multiline string prefix",
                "not quoted string",
            ),
        ];
        for (text, message, label) in sentences {
            let first = said(text).into_iter().next();
            assert_eq!(
                first,
                Some((message.to_owned(), label.to_owned())),
                "{text}"
            );
        }
    }
}
