//! Numbers that are too large to compute with.

use crate::language::{Entry, Location, Node, Problem, Range, Value};

/// Reports the numbers beyond [`Range::LARGEST`], whatever language they were written in.
pub(super) fn refuse_too_large(nodes: &[Node], problems: &mut Vec<Problem>) {
    for node in nodes {
        for entry in node.properties.iter().chain(&node.attributes) {
            for entry in std::iter::once(entry).chain(&entry.properties) {
                problems.extend(too_large(entry));
            }
        }
    }
}

fn too_large(entry: &Entry) -> Option<Problem> {
    let attribute = entry.attribute;
    let (value, at): (_, Location) = (entry.value.as_ref()?, entry.location?);
    let numbers: &[f64] = match value {
        Value::Number(number) => &[*number],
        Value::Pair(numbers) => numbers,
        Value::Triple(numbers) => numbers,
        Value::Text(_) | Value::Flag(_) => &[],
    };
    let large = numbers
        .iter()
        .find(|number| number.abs() > Range::LARGEST)?;
    if attribute.is_direction() {
        return None;
    }
    let message = format!("`{}` is too large", attribute.word);
    let found = Value::Number(*large);
    let label = format!("expected no more than 1.8e75, which is 2^250, found {found}");
    let is_length = attribute.unit == "world units";
    Some(Problem::error(at, message, label).help(if is_length {
        "choose a larger unit of length"
    } else {
        "choose a smaller number"
    }))
}
