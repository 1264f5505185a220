//! Numbers and tables as text.

use textwrap::{Options, WordSeparator, WordSplitter};

/// Width of a line in a terminal, in columns.
pub(super) const WIDTH: usize = 80;

/// A unit of time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unit {
    pub(super) word: &'static str,
    pub(super) seconds: f64,
}

impl Unit {
    /// The unit for a time: seconds from 1 s on, milliseconds from 0.1 ms on.
    pub(super) fn of(seconds: f64) -> Self {
        let (word, seconds) = match seconds {
            long if long >= 0.999_5 => ("s", 1.0),
            middle if middle >= 0.000_099_95 => ("ms", 1e-3),
            _ => ("µs", 1e-6),
        };
        Self { word, seconds }
    }
}

/// A time with its unit, to three digits.
pub(super) fn duration(seconds: f64) -> String {
    let unit = Unit::of(seconds);
    format!("{} {}", three_digits(seconds / unit.seconds), unit.word)
}

/// A number to three digits, or more before the point.
pub(super) fn three_digits(number: f64) -> String {
    format!("{number:.*}", decimals(number))
}

/// Digits behind the point of [`three_digits`].
pub(super) fn decimals(number: f64) -> usize {
    let rounded = format!("{number:.2e}");
    let exponent: Option<i32> = rounded.split_once('e').and_then(|(_, it)| it.parse().ok());
    usize::try_from(2 - exponent.unwrap_or(0)).unwrap_or(0)
}

/// A share in percent, to about three digits.
pub(super) fn percent(share: f64) -> String {
    match 100.0 * share {
        0.0 => "0 %".to_owned(),
        tiny if tiny < 0.01 => "< 0.01 %".to_owned(),
        some if some < 10.0 => format!("{some:.2} %"),
        some => format!("{some:.1} %"),
    }
}

/// A text in lines of at most [`WIDTH`] columns, of which all but the first are indented.
pub(super) fn wrapped(text: &str, indent: &str) -> String {
    let options = Options::new(WIDTH)
        .subsequent_indent(indent)
        .break_words(false)
        .word_separator(WordSeparator::AsciiSpace)
        .word_splitter(WordSplitter::NoHyphenation);
    textwrap::fill(text, options)
}

/// Rows of cells as lines with aligned columns, two spaces apart.
///
/// `align` has a `<` or `>` for each column.
pub(super) fn aligned(align: &str, rows: &[Vec<String>]) -> Vec<String> {
    let width = |cell: &String| cell.chars().count();
    let widest = |column: usize| {
        rows.iter()
            .filter_map(|row| row.get(column).map(width))
            .max()
    };
    let widths: Vec<_> = (0..align.len())
        .map(|column| widest(column).unwrap_or(0))
        .collect();
    let line = |row: &Vec<String>| {
        let cells = row.iter().zip(align.chars()).zip(&widths);
        let cells = cells.map(|((cell, align), wide)| match align {
            '<' => format!("{cell:<wide$}"),
            _ => format!("{cell:>wide$}"),
        });
        let line = cells.collect::<Vec<_>>().join("  ");
        line.trim_end().to_owned()
    };
    rows.iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_has_three_digits() {
        for (seconds, expected) in [
            (0.000_000_5, "0.500 µs"),
            (0.000_012_34, "12.3 µs"),
            (0.000_099_96, "0.100 ms"),
            (0.000_308_1, "0.308 ms"),
            (0.003_081, "3.08 ms"),
            (0.009_996, "10.0 ms"),
            (0.068_24, "68.2 ms"),
            (0.099_96, "100 ms"),
            (0.629_4, "629 ms"),
            (0.999_6, "1.00 s"),
            (1.594, "1.59 s"),
            (12.34, "12.3 s"),
            (99.96, "100 s"),
            (1234.0, "1234 s"),
        ] {
            assert_eq!(duration(seconds), expected);
        }
    }

    #[test]
    fn columns_are_as_wide_as_their_widest_cell() {
        let rows = [["a", "1", "x"], ["bcd", "µ", ""], ["", "100", "yz"]];
        let rows = rows.map(|row| row.map(str::to_owned).to_vec());
        let expected = ["a      1  x", "bcd    µ", "     100  yz"];
        assert_eq!(aligned("<><", &rows), expected);
    }
}
