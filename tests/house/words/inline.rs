//! Text inside of a block: code spans, links, and the words alone.

/// A part of a block's text and the byte at which it begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Span<'a> {
    pub(crate) offset: usize,
    pub(crate) text: &'a str,
}

/// The code spans of a text, without their backticks.
pub(crate) fn code_spans(text: &str) -> Vec<Span<'_>> {
    let mut spans = Vec::new();
    let mut at = 0;
    while let Some(found) = text[at..].find('`') {
        let start = at + found;
        let rest = &text[start..];
        let mark = &rest[..rest.len() - rest.trim_start_matches('`').len()];
        let offset = start + mark.len();
        match text[offset..].find(mark) {
            Some(length) => {
                let text = &text[offset..offset + length];
                spans.push(Span { offset, text });
                at = offset + length + mark.len();
            }
            None => at = offset,
        }
    }
    spans
}

/// The targets of all links and images of a text.
pub(crate) fn targets(text: &str) -> Vec<Span<'_>> {
    let hidden = without_code(text);
    let starts = hidden.match_indices("](").map(|(at, mark)| at + mark.len());
    let found = starts.filter_map(|offset| {
        let length = text[offset..].find(')')?;
        let target = text[offset..offset + length].split_whitespace().next()?;
        Some(Span {
            offset,
            text: target,
        })
    });
    found.collect()
}

/// The text with `x` in place of every byte of its code, so that offsets stay.
fn without_code(text: &str) -> String {
    let mut hidden = text.to_owned();
    for span in code_spans(text) {
        hidden.replace_range(
            span.offset..span.offset + span.text.len(),
            &"x".repeat(span.text.len()),
        );
    }
    hidden
}

/// The words alone: a code span is the word `code`, a link its text, an address nothing.
pub(crate) fn words_alone(text: &str) -> String {
    let mut plain = text.to_owned();
    for span in code_spans(text).into_iter().rev() {
        plain.replace_range(span.offset..span.offset + span.text.len(), "code");
    }
    plain = plain.replace('`', "");
    while let Some(start) = plain.find("](") {
        let end = plain[start..]
            .find(')')
            .map_or(plain.len(), |length| start + length + 1);
        plain.replace_range(start..end, "]");
    }
    while let Some(start) = plain.find("<http") {
        let end = plain[start..]
            .find('>')
            .map_or(plain.len(), |length| start + length + 1);
        plain.replace_range(start..end, "");
    }
    plain.replace("![", "").replace(['[', ']'], "")
}

#[test]
fn code_is_found() {
    let texts = |text| {
        code_spans(text)
            .iter()
            .map(|span| span.text)
            .collect::<Vec<_>>()
    };
    assert_eq!(texts("a `b` c `d e`"), ["b", "d e"]);
    assert_eq!(texts("``a ` b`` c"), ["a ` b"]);
    assert_eq!(texts("no ` end"), [""; 0]);
    assert_eq!(code_spans("ab `c`")[0].offset, 4);
}

#[test]
fn links_are_found_but_not_in_code() {
    let texts = |text| {
        targets(text)
            .iter()
            .map(|span| span.text)
            .collect::<Vec<_>>()
    };
    assert_eq!(texts("[a](b.md#c) and `[d](e)`"), ["b.md#c"]);
    assert_eq!(texts("[![alt](x.png)](y.kdl)"), ["x.png", "y.kdl"]);
    assert_eq!(texts("[a](b \"title\")"), ["b"]);
}

#[test]
fn words_stay() {
    assert_eq!(
        words_alone("A [b c](d.md) `e f` <https://g.h>."),
        "A b c code ."
    );
    assert_eq!(words_alone("![A red ball](ball.png)"), "A red ball");
}
