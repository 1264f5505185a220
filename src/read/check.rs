//! Values of attributes: type, number and range.

use super::say;
use crate::language::{Attribute, Diagnostic, Location, Range, Takes, Value, did_you_mean};

/// A value of a file before its type is checked.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Raw {
    Number(f64),
    /// A number beyond all doubles, as it is written.
    Beyond(String),
    Text(String),
    Flag(bool),
    Null,
}

impl Raw {
    fn words(&self) -> String {
        match self {
            Self::Number(number) if number.is_nan() => "#nan".to_owned(),
            Self::Number(f64::INFINITY) => "#inf".to_owned(),
            Self::Number(f64::NEG_INFINITY) => "#-inf".to_owned(),
            Self::Number(number) => format!("the number {}", Value::Number(*number)),
            Self::Beyond(written) => format!("the number {}", say::shown(written)),
            Self::Text(text) => format!("the text {}", say::quoted(text)),
            Self::Flag(flag) => Value::Flag(*flag).to_string(),
            Self::Null => "#null".to_owned(),
        }
    }
}

/// The typed value of an attribute from the values on its line.
///
/// `at` is the place for an error about a missing value.
pub(super) fn value(
    attribute: &Attribute,
    raws: &[(Raw, Location)],
    at: Location,
) -> Result<Option<Value>, Diagnostic> {
    check_count(attribute, raws, at)?;
    let value = match (&attribute.takes, raws) {
        (Takes::Number(range), [one]) => number(attribute, one, *range)?.into(),
        (Takes::Pair(range), [a, b]) => {
            Value::Pair([number(attribute, a, *range)?, number(attribute, b, *range)?])
        }
        (Takes::Triple | Takes::Color, [a, b, c]) => {
            let read = |raw| number(attribute, raw, Range::Any);
            Value::Triple([read(a)?, read(b)?, read(c)?])
        }
        (Takes::Color, [one]) => number(attribute, one, Range::Any)?.into(),
        (Takes::NumberOrPair(range), [one]) => number_or_pair(attribute, one, *range)?,
        (Takes::Word(words), [one]) => word(attribute, one, words)?,
        (Takes::Name(_) | Takes::Path, [one]) => text(attribute, one)?,
        (Takes::Flag, [one]) => flag(attribute, one)?,
        // Nothing is expected, and nothing is there.
        _ => return Ok(None),
    };
    Ok(Some(value))
}

/// Checks the number of values.
fn check_count(
    attribute: &Attribute,
    raws: &[(Raw, Location)],
    at: Location,
) -> Result<(), Diagnostic> {
    let (most, allowed): (usize, &[usize]) = match attribute.takes {
        Takes::Nothing => (0, &[0]),
        Takes::Pair(_) => (2, &[2]),
        Takes::Triple => (3, &[3]),
        Takes::Color => (3, &[1, 3]),
        _ => (1, &[1]),
    };
    if allowed.contains(&raws.len()) {
        return Ok(());
    }
    let word = attribute.word;
    if most == 0 {
        let message = format!("`{word}` takes no value of its own");
        let error = Diagnostic::error(joined(raws, at), message, "not expected");
        let properties = attribute.properties.iter().map(|property| property.word);
        return Err(if attribute.properties.is_empty() {
            error
        } else {
            error.help(format!("it has the properties {}", say::words(properties)))
        });
    }
    let expected = attribute.takes.words();
    let found = say::count(raws.len());
    let (problem, label, at) = if raws.is_empty() {
        ("no value", format!("expected {expected} after it"), at)
    } else {
        let label = format!("expected {expected}, found {found}");
        if raws.len() < most {
            ("too few values", label, joined(raws, at))
        } else {
            ("too many values", label, joined(&raws[most..], at))
        }
    };
    Err(Diagnostic::error(
        at,
        format!("`{word}` has {problem}"),
        label,
    ))
}

fn number(attribute: &Attribute, raw: &(Raw, Location), range: Range) -> Result<f64, Diagnostic> {
    let word = attribute.word;
    let expected = range.words("a", "number");
    match raw {
        (Raw::Number(number), _) if range.contains(*number) => Ok(*number),
        (Raw::Number(number), at) if number.is_finite() => {
            let label = format!("expected {expected}, found {}", Value::Number(*number));
            let message = format!("`{word}` is out of range");
            Err(Diagnostic::error(*at, message, label))
        }
        (found @ (Raw::Number(_) | Raw::Beyond(_)), at) => {
            let label = format!("expected a finite number, found {}", found.words());
            let message = format!("`{word}` is not finite");
            Err(Diagnostic::error(*at, message, label))
        }
        (Raw::Text(text), _) if text.trim().parse::<f64>().is_ok_and(f64::is_finite) => {
            let help = format!("write the number without quotes: {}", text.trim());
            Err(wrong_type(attribute, &expected, raw).help(help))
        }
        _ => Err(wrong_type(attribute, &expected, raw)),
    }
}

fn number_or_pair(
    attribute: &Attribute,
    raw: &(Raw, Location),
    range: Range,
) -> Result<Value, Diagnostic> {
    let (Raw::Text(text), at) = raw else {
        return number(attribute, raw, range).map(Value::Number);
    };
    let read = |part: f64| number(attribute, &(Raw::Number(part), *at), range);
    let numbers: Vec<_> = text.split_whitespace().map(str::parse::<f64>).collect();
    match numbers.as_slice() {
        [Ok(one)] => read(*one).map(Value::Number),
        [Ok(a), Ok(b)] => Ok(Value::Pair([read(*a)?, read(*b)?])),
        _ => Err(wrong_type(attribute, &attribute.takes.words(), raw)),
    }
}

fn flag(attribute: &Attribute, raw: &(Raw, Location)) -> Result<Value, Diagnostic> {
    let error = || wrong_type(attribute, "#true or #false", raw);
    match &raw.0 {
        Raw::Flag(flag) => Ok((*flag).into()),
        Raw::Text(text) if text == "true" || text == "false" => {
            let help = format!("write it without quotes and with a `#`: #{text}");
            Err(error().help(help))
        }
        _ => Err(error()),
    }
}

fn word(attribute: &Attribute, raw: &(Raw, Location), words: &[&str]) -> Result<Value, Diagnostic> {
    let expected = attribute.takes.words();
    let found = match &raw.0 {
        Raw::Text(text) => text.clone(),
        // A word that is a number needs no quotes.
        Raw::Number(number) => Value::Number(*number).to_string(),
        _ => return Err(wrong_type(attribute, &expected, raw)),
    };
    if words.contains(&found.as_str()) {
        return Ok(Value::Text(found));
    }
    match raw {
        (Raw::Text(text), at) => {
            let message = format!("`{}` cannot be {}", attribute.word, say::quoted(text));
            let error = Diagnostic::error(*at, message, format!("expected {expected}"));
            Err(error.suggest_name(did_you_mean(text, words.iter().copied())))
        }
        _ => Err(wrong_type(attribute, &expected, raw)),
    }
}

/// A name or a path.
fn text(attribute: &Attribute, raw: &(Raw, Location)) -> Result<Value, Diagnostic> {
    let expected = attribute.takes.words();
    match raw {
        (Raw::Text(text), at) if text.is_empty() => {
            let message = format!("`{}` is empty", attribute.word);
            let label = format!("expected {expected}");
            Err(Diagnostic::error(*at, message, label))
        }
        (Raw::Text(text), _) => Ok(Value::from(text.as_str())),
        (Raw::Number(number), _) => {
            let number = Value::Number(*number);
            let help = format!("a name that is a number needs quotes: \"{number}\"");
            Err(wrong_type(attribute, &expected, raw).help(help))
        }
        _ => Err(wrong_type(attribute, &expected, raw)),
    }
}

fn wrong_type(attribute: &Attribute, expected: &str, (found, at): &(Raw, Location)) -> Diagnostic {
    let message = format!("`{}` has a value of the wrong type", attribute.word);
    let label = format!("expected {expected}, found {}", found.words());
    Diagnostic::error(*at, message, label)
}

/// The range from the first value to the last; `at` if there is none.
fn joined(raws: &[(Raw, Location)], at: Location) -> Location {
    let (Some((_, first)), Some((_, last))) = (raws.first(), raws.last()) else {
        return at;
    };
    Location {
        length: last.start + last.length - first.start,
        ..*first
    }
}
