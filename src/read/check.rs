//! Values against what an attribute takes.

use super::say;
use crate::language::{Attribute, Location, Problem, Range, Takes, Value, did_you_mean};

/// A value as a file has it, before its type is known.
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

/// The typed value of an attribute from what stands on its line.
///
/// `at` is where to point if nothing stands there.
pub(super) fn value(
    attribute: &Attribute,
    raws: &[(Raw, Location)],
    at: Location,
) -> Result<Option<Value>, Problem> {
    if let Some(problem) = miscounted(attribute, raws, at) {
        return Err(problem);
    }
    let value = match (&attribute.takes, raws) {
        (Takes::Number(range), [one]) => number(attribute, one, *range)?.into(),
        (Takes::Pair(range), [a, b]) => {
            [number(attribute, a, *range)?, number(attribute, b, *range)?].into()
        }
        (Takes::Triple | Takes::Color, [a, b, c]) => {
            let read = |raw| number(attribute, raw, Range::Any);
            Value::Triple([read(a)?, read(b)?, read(c)?])
        }
        (Takes::Color, [one]) => number(attribute, one, Range::Any)?.into(),
        (Takes::NumberOrPair(range), [one]) => number_or_pair(attribute, one, *range)?,
        (Takes::Word(words), [one]) => word(attribute, one, words)?,
        (Takes::Name(_) | Takes::Path, [one]) => text(attribute, one)?,
        (Takes::Flag, [(Raw::Flag(flag), _)]) => (*flag).into(),
        (Takes::Flag, [one @ (Raw::Text(text), _)]) if text == "true" || text == "false" => {
            let help = format!("write it without quotes and with a `#`: #{text}");
            return Err(wrong_type(attribute, "#true or #false", one).help(help));
        }
        (Takes::Flag, [one]) => return Err(wrong_type(attribute, "#true or #false", one)),
        // Nothing is expected, and nothing is there.
        _ => return Ok(None),
    };
    Ok(Some(value))
}

/// The problem if there are too few values, or too many.
fn miscounted(attribute: &Attribute, raws: &[(Raw, Location)], at: Location) -> Option<Problem> {
    let (most, allowed): (usize, &[usize]) = match attribute.takes {
        Takes::Nothing => (0, &[0]),
        Takes::Pair(_) => (2, &[2]),
        Takes::Triple => (3, &[3]),
        Takes::Color => (3, &[1, 3]),
        _ => (1, &[1]),
    };
    if allowed.contains(&raws.len()) {
        return None;
    }
    let word = attribute.word;
    let expected = attribute.takes.words();
    let found = say::count(raws.len());
    let (message, label, at) = if most == 0 {
        let message = format!("`{word}` takes no value of its own");
        (message, "not expected".to_owned(), joined(raws, at))
    } else if raws.is_empty() {
        let label = format!("expected {expected} after it");
        (format!("`{word}` has no value"), label, at)
    } else if raws.len() < most {
        let label = format!("expected {expected}, found {found}");
        (
            format!("`{word}` has too few values"),
            label,
            joined(raws, at),
        )
    } else {
        let label = format!("expected {expected}, found {found}");
        let surplus = joined(&raws[most..], at);
        (format!("`{word}` has too many values"), label, surplus)
    };
    let problem = Problem::error(at, message, label);
    let properties = attribute.properties.iter().map(|property| property.word);
    Some(if most == 0 && !attribute.properties.is_empty() {
        problem.help(format!("it has the properties {}", say::words(properties)))
    } else {
        problem
    })
}

fn number(attribute: &Attribute, raw: &(Raw, Location), range: Range) -> Result<f64, Problem> {
    let word = attribute.word;
    let expected = range.words("a", "number");
    match raw {
        (Raw::Number(number), at) if number.is_finite() => {
            if range.contains(*number) {
                return Ok(*number);
            }
            let label = format!("expected {expected}, found {}", Value::Number(*number));
            Err(Problem::error(
                *at,
                format!("`{word}` is out of range"),
                label,
            ))
        }
        (found @ (Raw::Number(_) | Raw::Beyond(_)), at) => {
            let label = format!("expected a finite number, found {}", found.words());
            Err(Problem::error(
                *at,
                format!("`{word}` is not finite"),
                label,
            ))
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
) -> Result<Value, Problem> {
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

fn word(attribute: &Attribute, raw: &(Raw, Location), words: &[&str]) -> Result<Value, Problem> {
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
            let problem = Problem::error(*at, message, format!("expected {expected}"));
            Err(problem.suggest_name(did_you_mean(text, words.iter().copied())))
        }
        _ => Err(wrong_type(attribute, &expected, raw)),
    }
}

/// A name or a path.
fn text(attribute: &Attribute, raw: &(Raw, Location)) -> Result<Value, Problem> {
    let expected = attribute.takes.words();
    match raw {
        (Raw::Text(text), at) if text.is_empty() => {
            let message = format!("`{}` is empty", attribute.word);
            Err(Problem::error(*at, message, format!("expected {expected}")))
        }
        (Raw::Text(text), _) => Ok(Value::from(text.as_str())),
        (Raw::Number(number), _) => {
            let help = format!(
                "a name that is a number needs quotes: \"{}\"",
                Value::Number(*number)
            );
            Err(wrong_type(attribute, &expected, raw).help(help))
        }
        _ => Err(wrong_type(attribute, &expected, raw)),
    }
}

fn wrong_type(attribute: &Attribute, expected: &str, (found, at): &(Raw, Location)) -> Problem {
    let message = format!("`{}` has a value of the wrong type", attribute.word);
    let label = format!("expected {expected}, found {}", found.words());
    Problem::error(*at, message, label)
}

/// The stretch from the first value to the last; `at` if there is none.
fn joined(raws: &[(Raw, Location)], at: Location) -> Location {
    let (Some((_, first)), Some((_, last))) = (raws.first(), raws.last()) else {
        return at;
    };
    Location {
        length: last.start + last.length - first.start,
        ..*first
    }
}
