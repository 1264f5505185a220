//! Rules about whole scenes: required nodes, single nodes, sizes of numbers.

use crate::camera::View;
use crate::language::{Diagnostic, Entry, Location, Node, Range, Schema, Sources, Value};
use crate::scene::RenderSettings;

/// The nodes of a kind.
pub(super) fn of<'a>(nodes: &'a [Node], schema: &'static Schema) -> impl Iterator<Item = &'a Node> {
    nodes.iter().filter(move |node| node.schema == schema)
}

/// Reports a missing picture and a missing camera.
pub(super) fn check_required(nodes: &[Node], diagnostics: &mut Vec<Diagnostic>) {
    const IMAGE: &str = "image 800 600";
    const CAMERA: &str = "camera { viewpoint 4 3 8; screen 8 6 }";
    let start = Location {
        source: 0,
        start: 0,
        length: 0,
    };
    if nodes.is_empty() && diagnostics.is_empty() {
        let error = Diagnostic::error(start, "the scene is empty", "expected a scene");
        let help = format!("a scene begins with, for example,\n{IMAGE}\n{CAMERA}");
        diagnostics.push(error.help(help));
        return;
    }
    for (schema, example) in [(&RenderSettings::SCHEMA, IMAGE), (&View::SCHEMA, CAMERA)] {
        let word = schema.word;
        if of(nodes, schema).next().is_none() {
            let message = format!("the scene has no `{word}`");
            let label = format!("expected a node `{word}` in this file");
            let error = Diagnostic::error(start, message, label);
            diagnostics.push(error.help(format!("add, for example, `{example}`")));
        }
    }
}

/// The first node of a kind, if it is valid. Reports further ones.
pub(super) fn single<'a>(
    nodes: &'a [Node],
    schema: &'static Schema,
    sources: &Sources,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<&'a Node> {
    let mut all = of(nodes, schema);
    let first = all.next()?;
    for other in all {
        if let (Some(at), Some(earlier)) = (other.location, first.location) {
            let message = format!("the scene has more than one `{}`", schema.word);
            let label = format!("the first is at {}", sources.position(earlier));
            diagnostics.push(Diagnostic::error(at, message, label).help("keep one of them"));
        }
    }
    Some(first).filter(|node| node.valid)
}

/// Reports numbers beyond [`Range::LARGEST`], in scenes of either language.
pub(super) fn check_magnitudes(nodes: &[Node], diagnostics: &mut Vec<Diagnostic>) {
    let entries = nodes
        .iter()
        .flat_map(|node| node.properties.iter().chain(&node.attributes));
    let all = entries.flat_map(|entry| std::iter::once(entry).chain(&entry.properties));
    diagnostics.extend(all.filter_map(too_large));
}

fn too_large(entry: &Entry) -> Option<Diagnostic> {
    let attribute = entry.attribute;
    let (value, at) = (entry.value.as_ref()?, entry.location?);
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
    Some(Diagnostic::error(at, message, label).help(if is_length {
        "choose a larger unit of length"
    } else {
        "choose a smaller number"
    }))
}
