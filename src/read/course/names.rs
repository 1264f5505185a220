//! Names that a scene uses twice.

use std::collections::{HashMap, HashSet};

use super::entity::Block;
use crate::language::{Problem, Schema, Value};
use crate::light::{Cone, Light, Slide};
use crate::material::Material;
use crate::texture::Texture;

/// Things that can be mixed up if they have the same name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Kind {
    Material,
    Texture,
    Light,
    Surface,
}

impl Kind {
    fn of(schema: &'static Schema) -> Self {
        if schema == &Material::SCHEMA {
            Self::Material
        } else if schema == &Texture::SCHEMA {
            Self::Texture
        } else if [&Light::SCHEMA, &Cone::SCHEMA, &Slide::SCHEMA].contains(&schema) {
            Self::Light
        } else {
            Self::Surface
        }
    }

    fn word(self) -> &'static str {
        match self {
            Self::Material => "material",
            Self::Texture => "texture",
            Self::Light => "light",
            Self::Surface => "surface",
        }
    }
}

/// The first thing of a name.
#[derive(Debug)]
struct First {
    line: usize,
    /// How many of the names `name-2`, `name-3` … have been tried.
    tried: usize,
}

/// Gives the later ones of equal names new names; the courses' programs always found the first.
pub(super) fn make_unique(blocks: &mut [Block], problems: &mut Vec<Problem>) {
    let mut taken = all_names(blocks);
    let mut firsts: HashMap<(Kind, String), First> = HashMap::new();
    for block in blocks {
        let Some(name) = block.name.clone() else {
            continue;
        };
        let kind = Kind::of(block.entity.schema);
        let Some(first) = firsts.get_mut(&(kind, name.clone())) else {
            firsts.insert(
                (kind, name),
                First {
                    line: block.line,
                    tried: 1,
                },
            );
            continue;
        };
        let new = loop {
            first.tried += 1;
            let new = format!("{name}-{}", first.tried);
            if taken.insert(new.clone()) {
                break new;
            }
        };
        problems.push(warning(block, kind, first.line, &new));
        block.name = Some(new);
    }
}

/// All names that are given or meant.
fn all_names(blocks: &[Block]) -> HashSet<String> {
    let given = blocks.iter().filter_map(|block| block.name.clone());
    let attributes = blocks.iter().flat_map(|block| &block.given);
    let meant = attributes.filter_map(|given| match &given.value {
        Some(Value::Text(name)) => Some(name.clone()),
        _ => None,
    });
    given.chain(meant).collect()
}

fn warning(block: &Block, kind: Kind, first_line: usize, new: &str) -> Problem {
    let name = block.name.as_deref().unwrap_or_default();
    let message = format!("a second {} is called `{name}`", kind.word());
    let label = format!("read as `{new}`");
    Problem::warning(block.head, message, label).help(match kind {
        Kind::Material | Kind::Texture => {
            format!("`{name}` means the one in line {first_line}; this one is never used")
        }
        Kind::Light | Kind::Surface => format!("the first is in line {first_line}"),
    })
}
