//! Scene to text.

use std::fmt::Write;

use super::{Lighting, RenderSettings, Scene};
use crate::camera::View;
use crate::language::{Node, Schema, Value};
use crate::light::{Cone, Light, Slide};
use crate::material::Material;
use crate::texture::Texture;

/// The parts of a scene, in the order in which they are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Part {
    RenderSettings,
    Textures,
    Materials,
    Lights,
    Surfaces,
}

impl Part {
    fn of(schema: &'static Schema) -> Self {
        if [&RenderSettings::SCHEMA, &View::SCHEMA, &Lighting::SCHEMA].contains(&schema) {
            Self::RenderSettings
        } else if schema == &Texture::SCHEMA {
            Self::Textures
        } else if schema == &Material::SCHEMA {
            Self::Materials
        } else if [&Light::SCHEMA, &Cone::SCHEMA, &Slide::SCHEMA].contains(&schema) {
            Self::Lights
        } else {
            Self::Surfaces
        }
    }

    /// The comment above it; the beginning speaks for itself.
    fn title(self) -> Option<&'static str> {
        match self {
            Self::RenderSettings => None,
            Self::Textures => Some("// Textures"),
            Self::Materials => Some("// Materials"),
            Self::Lights => Some("// Lights"),
            Self::Surfaces => Some("// Surfaces"),
        }
    }
}

impl Scene {
    /// The whole scene as KDL text, which reads back as a scene with the same
    /// [hash](Self::hash).
    ///
    /// `file_name` says by which name the text refers to a texture's file, since such names are
    /// relative to where the text is put.
    #[must_use]
    pub fn to_kdl(
        &self,
        spell_out_defaults: bool,
        file_name: impl Fn(&Texture) -> String,
    ) -> String {
        let mut textures = self.textures.iter();
        let mut text = String::new();
        let mut before: Option<&'static Schema> = None;
        for mut node in self.describe() {
            if node.schema == &Texture::SCHEMA {
                let file = textures.next().map(|texture| file_name(texture));
                node.value = file.as_deref().map(Value::from);
            }
            if !spell_out_defaults {
                node = node.without_defaults();
            }
            if says_nothing(&node) {
                continue;
            }
            separate(&mut text, before, node.schema);
            before = Some(node.schema);
            // Writing to a String cannot fail.
            let _ = write!(text, "{node}");
        }
        text
    }
}

/// Whether a node could as well be missing.
fn says_nothing(node: &Node) -> bool {
    node.schema == &Lighting::SCHEMA && node.attributes.is_empty()
}

/// Writes what stands between two nodes: a part's title, and an empty line unless both have one
/// line each.
fn separate(text: &mut String, before: Option<&'static Schema>, next: &'static Schema) {
    let Some(before) = before else { return };
    let part = Part::of(next);
    let new_part = part != Part::of(before);
    let one_liners = before == &Texture::SCHEMA && next == &Texture::SCHEMA;
    if !one_liners {
        text.push('\n');
    }
    if let Some(title) = part.title().filter(|_| new_part) {
        text.push_str(title);
        text.push_str("\n\n");
    }
}
