//! `docs/scene-language.md` and the readers agree: its reference is what the schemas say.

use std::fmt::Write;

use heliodon::language::{Attribute, Default, Naming, Schema};
use heliodon::read;
use support::texts::compare_section;

const DOCUMENT: &str = "docs/scene-language.md";
const MARKS: [&str; 2] = [
    "<!-- The reference is written by",
    "<!-- The end of the reference",
];

#[test]
fn the_document_lists_every_node_and_attribute() {
    let compared = compare_section(DOCUMENT, MARKS, &reference());
    compared.unwrap_or_else(|differs| panic!("{differs}"));
}

fn reference() -> String {
    let mut text = String::new();
    for schema in read::schemas() {
        // Writing to a String cannot fail.
        let _ = write!(text, "\n### `{}`\n\n{}\n\n", schema.word, schema.about);
        let _ = writeln!(text, "`{}`", usage(schema));
        let rows = rows(schema);
        if !rows.is_empty() {
            text += "\n| attribute | takes | unit | default | meaning |\n|---|---|---|---|---|\n";
            text += &rows;
        }
    }
    text + "\n"
}

/// The shape of a node's line: `texture "NAME" FILE divisor=…`.
fn usage(schema: &Schema) -> String {
    let mut usage = schema.word.to_owned();
    match schema.naming {
        Naming::None => {}
        Naming::Optional => usage += " [\"name\"]",
        Naming::Required => usage += " \"name\"",
    }
    if let Some(value) = schema.value {
        let _ = write!(usage, " {}", value.word);
    }
    for property in schema.properties {
        let _ = write!(usage, " [{}=…]", property.word);
    }
    if schema.all_attributes().next().is_some() {
        usage += " { … }";
    }
    usage
}

fn rows(schema: &Schema) -> String {
    let mut rows = String::new();
    if let Some(value) = schema.value {
        rows += &row(&format!("*{}*", value.word), value);
    }
    for property in schema.properties {
        rows += &row(&format!("`{}=`", property.word), property);
    }
    for attribute in schema.all_attributes() {
        rows += &row(&format!("`{}`", attribute.word), attribute);
        for property in attribute.properties {
            rows += &row(
                &format!("`{} … {}=`", attribute.word, property.word),
                property,
            );
        }
    }
    rows
}

fn row(word: &str, attribute: &Attribute) -> String {
    let default = match attribute.default {
        Default::Required => "required".to_owned(),
        Default::Absent => "none".to_owned(),
        other => other
            .value()
            .map_or(String::new(), |value| format!("`{value}`")),
    };
    let (takes, unit) = (attribute.takes.words(), attribute.unit);
    format!(
        "| {word} | {takes} | {unit} | {default} | {} |\n",
        attribute.about
    )
}
