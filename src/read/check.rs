//! Values against what an attribute takes.

use crate::language::{Attribute, Location, Problem, Range, Takes, Value, did_you_mean};

/// A value as a file has it, before its type is known.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Raw {
    Number(f64),
    Text(String),
    Flag(bool),
    Null,
}

impl Raw {
    fn words(&self) -> String {
        match self {
            Self::Number(number) => format!("the number {number}"),
            Self::Text(text) => format!("the text {text:?}"),
            Self::Flag(true) => "#true".to_owned(),
            Self::Flag(false) => "#false".to_owned(),
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
    let word = attribute.word;
    match (&attribute.takes, raws) {
        (Takes::Nothing, []) => Ok(None),
        (Takes::Number(range), [one]) => number(attribute, one, *range).map(some_number),
        (Takes::Pair(range), [a, b]) => {
            let pair = [number(attribute, a, *range)?, number(attribute, b, *range)?];
            Ok(Some(Value::Pair(pair)))
        }
        (Takes::Triple | Takes::Color, [a, b, c]) => {
            let read = |raw| number(attribute, raw, Range::Any);
            Ok(Some(Value::Triple([read(a)?, read(b)?, read(c)?])))
        }
        (Takes::Color, [one]) => number(attribute, one, Range::Any).map(some_number),
        (Takes::NumberOrPair(range), [one]) => number_or_pair(attribute, one, *range).map(Some),
        (Takes::Word(words), [(Raw::Text(text), at)]) => {
            if words.contains(&text.as_str()) {
                return Ok(Some(Value::from(text.as_str())));
            }
            let message = format!("`{word}` does not know {text:?}");
            let label = format!("expected {}", attribute.takes.words());
            let problem = Problem::error(*at, message, label);
            Err(problem.suggest(did_you_mean(text, words.iter().copied())))
        }
        (Takes::Name(_) | Takes::Path, [(Raw::Text(text), at)]) => {
            if text.is_empty() {
                let message = format!("`{word}` is empty");
                let label = format!("expected {}", attribute.takes.words());
                return Err(Problem::error(*at, message, label));
            }
            Ok(Some(Value::from(text.as_str())))
        }
        (Takes::Flag, [(Raw::Flag(flag), _)]) => Ok(Some(Value::Flag(*flag))),
        (takes, [(raw, at)]) if !matches!(takes, Takes::Pair(_) | Takes::Triple) => {
            let message = format!("`{word}` has a value of the wrong type");
            let label = format!("expected {}, found {}", takes.words(), raw.words());
            Err(Problem::error(*at, message, label))
        }
        (takes, raws) => {
            let found = match raws.len() {
                0 => "nothing".to_owned(),
                1 => "one value".to_owned(),
                many => format!("{many} values"),
            };
            let at = raws
                .iter()
                .fold(None, |span, (_, at)| Some(joined(span, *at)))
                .unwrap_or(at);
            let message = format!("`{word}` has the wrong number of values");
            Err(Problem::error(
                at,
                message,
                format!("expected {}, found {found}", takes.words()),
            ))
        }
    }
}

fn some_number(number: f64) -> Option<Value> {
    Some(Value::Number(number))
}

fn number(
    attribute: &Attribute,
    (raw, at): &(Raw, Location),
    range: Range,
) -> Result<f64, Problem> {
    let word = attribute.word;
    let Raw::Number(number) = raw else {
        let message = format!("`{word}` has a value of the wrong type");
        let label = format!("expected a number, found {}", raw.words());
        return Err(Problem::error(*at, message, label));
    };
    if !number.is_finite() {
        let message = format!("`{word}` is not a finite number");
        let label = format!("expected a finite number, found {number}");
        return Err(Problem::error(*at, message, label));
    }
    if !range.contains(*number) {
        let message = format!("`{word}` is out of range");
        let label = format!("expected a number{}, found {number}", range.words());
        return Err(Problem::error(*at, message, label));
    }
    Ok(*number)
}

fn number_or_pair(
    attribute: &Attribute,
    raw: &(Raw, Location),
    range: Range,
) -> Result<Value, Problem> {
    let (Raw::Text(text), at) = raw else {
        return number(attribute, raw, range).map(Value::Number);
    };
    let numbers: Vec<_> = text.split_whitespace().map(str::parse::<f64>).collect();
    match numbers.as_slice() {
        [Ok(one)] => number(attribute, &(Raw::Number(*one), *at), range).map(Value::Number),
        [Ok(a), Ok(b)] => {
            let read = |part| number(attribute, &(Raw::Number(part), *at), range);
            Ok(Value::Pair([read(*a)?, read(*b)?]))
        }
        _ => {
            let message = format!("`{}` has a value of the wrong type", attribute.word);
            let label = format!("expected {}, found {text:?}", attribute.takes.words());
            Err(Problem::error(*at, message, label))
        }
    }
}

fn joined(span: Option<Location>, at: Location) -> Location {
    let Some(span) = span else { return at };
    let end = (at.start + at.length).max(span.start + span.length);
    Location {
        length: end - span.start,
        ..span
    }
}
