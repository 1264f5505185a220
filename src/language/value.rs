//! Values of the scene language.

use std::fmt;

use glam::{DVec2, DVec3};

/// A value of an attribute.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// One number.
    Number(f64),
    /// Two numbers: a width and a height.
    Pair([f64; 2]),
    /// Three numbers: a point, a direction or a colour.
    Triple([f64; 3]),
    /// A word, a name or a path.
    Text(String),
    /// `#true` or `#false`.
    Flag(bool),
}

impl Value {
    /// The number; zero for anything else.
    #[must_use]
    pub fn number(&self) -> f64 {
        match self {
            Self::Number(number) => *number,
            _ => 0.0,
        }
    }

    /// The pair, or a number twice; zero for anything else.
    #[must_use]
    pub fn pair(&self) -> DVec2 {
        match self {
            Self::Number(number) => DVec2::splat(*number),
            Self::Pair(pair) => DVec2::from_array(*pair),
            _ => DVec2::ZERO,
        }
    }

    /// The triple, or a number three times; zero for anything else.
    #[must_use]
    pub fn triple(&self) -> DVec3 {
        match self {
            Self::Number(number) => DVec3::splat(*number),
            Self::Triple(triple) => DVec3::from_array(*triple),
            _ => DVec3::ZERO,
        }
    }

    /// The text; empty for anything else.
    #[must_use]
    pub fn text(&self) -> &str {
        match self {
            Self::Text(text) => text,
            _ => "",
        }
    }
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<[f64; 2]> for Value {
    fn from(pair: [f64; 2]) -> Self {
        Self::Pair(pair)
    }
}

impl From<DVec2> for Value {
    fn from(pair: DVec2) -> Self {
        Self::Pair(pair.to_array())
    }
}

impl From<DVec3> for Value {
    fn from(vector: DVec3) -> Self {
        Self::Triple(vector.to_array())
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<bool> for Value {
    fn from(flag: bool) -> Self {
        Self::Flag(flag)
    }
}

impl fmt::Display for Value {
    /// Writes the value as KDL 2; reading it gives the same bits.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write_number(out, *number),
            Self::Pair(numbers) => write_numbers(out, numbers),
            Self::Triple(numbers) => write_numbers(out, numbers),
            Self::Text(text) => write_text(out, text),
            Self::Flag(true) => out.write_str("#true"),
            Self::Flag(false) => out.write_str("#false"),
        }
    }
}

fn write_numbers(out: &mut fmt::Formatter<'_>, numbers: &[f64]) -> fmt::Result {
    for (index, number) in numbers.iter().enumerate() {
        if index > 0 {
            out.write_str(" ")?;
        }
        write_number(out, *number)?;
    }
    Ok(())
}

/// Writes the shortest decimal of a double, whole numbers without a point.
fn write_number(out: &mut fmt::Formatter<'_>, number: f64) -> fmt::Result {
    const LARGEST_PLAIN: f64 = 1e15;
    let whole = number.fract() == 0.0 && number.abs() < LARGEST_PLAIN;
    // An integer zero has no sign in KDL, a decimal one has.
    if whole && !(number == 0.0 && number.is_sign_negative()) {
        write!(out, "{number:.0}")
    } else {
        write!(out, "{number:?}")
    }
}

/// Writes a quoted KDL string.
fn write_text(out: &mut fmt::Formatter<'_>, text: &str) -> fmt::Result {
    out.write_str("\"")?;
    for character in text.chars() {
        match character {
            '"' => out.write_str("\\\"")?,
            '\\' => out.write_str("\\\\")?,
            '\n' => out.write_str("\\n")?,
            '\r' => out.write_str("\\r")?,
            '\t' => out.write_str("\\t")?,
            other if other.is_control() || needs_escape(other) => {
                write!(out, "\\u{{{:x}}}", u32::from(other))?;
            }
            other => write!(out, "{other}")?,
        }
    }
    out.write_str("\"")
}

/// True for the printable characters that KDL strings hold only as escapes.
///
/// They are line separators, marks of the writing direction, and the byte order mark.
fn needs_escape(character: char) -> bool {
    matches!(
        character,
        '\u{200e}'..='\u{200f}'
            | '\u{2028}'..='\u{202e}'
            | '\u{2066}'..='\u{2069}'
            | '\u{feff}'
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_back_to_the_same_bits() {
        for number in [
            0.0,
            -0.0,
            1.0,
            -3.0,
            0.1,
            1e300,
            5e-324,
            1.0 / 3.0,
            1e15,
            123456.75,
        ] {
            let text = Value::Number(number).to_string();
            let read: f64 = text.parse().expect("a decimal number");
            assert_eq!(read.to_bits(), number.to_bits(), "{text}");
        }
    }

    #[test]
    fn texts_are_quoted_and_escaped() {
        assert_eq!(Value::from("a \"b\"\\\n").to_string(), r#""a \"b\"\\\n""#);
    }
}
