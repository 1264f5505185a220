//! Unique names for entities of equal names.

use std::collections::{HashMap, HashSet};

use super::block::Block;
use crate::language::{Diagnostic, Schema, Value};
use crate::light::{Cone, Light, Slide};
use crate::material::Material;
use crate::texture::Texture;

/// The kind of an entity, within which names must be unique.
fn kind(schema: &'static Schema) -> &'static str {
    if schema == &Material::SCHEMA {
        "material"
    } else if schema == &Texture::SCHEMA {
        "texture"
    } else if [&Light::SCHEMA, &Cone::SCHEMA, &Slide::SCHEMA].contains(&schema) {
        "light"
    } else {
        "surface"
    }
}

/// The first entity of a name.
#[derive(Debug)]
struct First {
    line: usize,
    /// The last number tried of `name-2`, `name-3` …
    tried: usize,
}

/// Renames all but the first of equal names, with a warning.
///
/// The courses' programs looked up the first.
pub(super) fn make_unique(blocks: &mut [Block], diagnostics: &mut Vec<Diagnostic>) {
    let mut taken = all_names(blocks);
    let mut firsts: HashMap<(&str, String), First> = HashMap::new();
    for block in blocks {
        let Some(name) = block.name.clone() else {
            continue;
        };
        let kind = kind(block.entity.schema);
        let Some(first) = firsts.get_mut(&(kind, name.clone())) else {
            let (line, tried) = (block.line, 1);
            firsts.insert((kind, name), First { line, tried });
            continue;
        };
        let new = loop {
            first.tried += 1;
            let new = format!("{name}-{}", first.tried);
            if taken.insert(new.clone()) {
                break new;
            }
        };
        let line = first.line;
        let help = match kind {
            "material" | "texture" => {
                format!("`{name}` means the one in line {line}; this one is never used")
            }
            _ => format!("the first is in line {line}"),
        };
        let message = format!("a second {kind} is called `{name}`");
        let warning = Diagnostic::warning(block.head, message, format!("read as `{new}`"));
        diagnostics.push(warning.help(help));
        block.name = Some(new);
    }
}

/// All names of entities, and all texts of attributes.
fn all_names(blocks: &[Block]) -> HashSet<String> {
    let given = blocks.iter().filter_map(|block| block.name.clone());
    let attributes = blocks.iter().flat_map(|block| &block.given);
    let texts = attributes.filter_map(|given| match &given.value {
        Some(Value::Text(name)) => Some(name.clone()),
        _ => None,
    });
    given.chain(texts).collect()
}
