//! What is to be drawn.

mod lighting;
mod render_settings;
mod setting;
mod settings;
mod write;

pub use lighting::{Falloff, Lighting};
pub use render_settings::RenderSettings;
pub use setting::{Setting, SettingKind};
pub use settings::SETTINGS;

use std::sync::Arc;

use crate::camera::View;
use crate::geometry::Shared;
use crate::language::{Node, Schema, Sources};
use crate::light::{Cone, Light, Slide};
use crate::material::Material;
use crate::surface::{self, Surface};
use crate::texture::{Filter, Texture};

/// A scene in which every name is resolved.
#[derive(Debug)]
pub struct Scene {
    /// The picture's size and how its pixels are made.
    pub settings: RenderSettings,
    /// Where it is taken from.
    pub view: View,
    /// How light fades.
    pub lighting: Lighting,
    /// The textures in use, in file order.
    pub textures: Vec<Arc<Texture>>,
    /// The materials in file order.
    pub materials: Vec<Arc<Material>>,
    /// The lights in file order; they are summed in this order.
    pub lights: Vec<Light>,
    /// The surfaces in file order; of coincident ones the first is seen.
    pub surfaces: Vec<Box<dyn Surface>>,
    /// The planes and lines that surfaces share.
    pub shared: Vec<Shared>,
    /// The texts that it was read from.
    pub sources: Sources,
}

impl Scene {
    /// Whether there are textures of which a ray sees more than the texel that it meets.
    #[must_use]
    pub fn is_filtered(&self) -> bool {
        let mut surfaces = self.surfaces.iter();
        self.settings.texture_filter != Filter::Nearest
            && surfaces.any(|surface| surface.texture().is_some())
    }

    /// Every kind of node that a scene may hold, but for `include`, which only files have.
    pub fn schemas() -> impl Iterator<Item = &'static Schema> {
        const PARTS: &[&Schema] = &[
            &RenderSettings::SCHEMA,
            &View::SCHEMA,
            &Lighting::SCHEMA,
            &Texture::SCHEMA,
            &Material::SCHEMA,
            &Light::SCHEMA,
            &Cone::SCHEMA,
            &Slide::SCHEMA,
        ];
        PARTS.iter().chain(surface::SCHEMAS).copied()
    }

    /// The whole scene as nodes of the scene language, every default spelled out.
    #[must_use]
    pub fn describe(&self) -> Vec<Node> {
        let head = [
            self.settings.describe(),
            self.view.describe(),
            self.lighting.describe(),
        ];
        let textures = self.textures.iter().map(|texture| texture.describe());
        let materials = self.materials.iter().map(|material| material.describe());
        let lights = self.lights.iter().map(Light::describe);
        let surfaces = self
            .surfaces
            .iter()
            .map(|surface| surface.common().describe(surface.describe()));
        head.into_iter()
            .chain(textures)
            .chain(materials)
            .chain(lights)
            .chain(surfaces)
            .collect()
    }

    /// A fingerprint of everything that shapes the picture: numbers, names and texels, but not
    /// comments, layout, file names or the language it was written in.
    #[must_use]
    pub fn hash(&self) -> String {
        let mut hasher = blake3::Hasher::new();
        for mut node in self.describe() {
            if node.schema == &Texture::SCHEMA {
                node.value = None;
            }
            hasher.update(node.to_string().as_bytes());
        }
        for texture in &self.textures {
            hasher.update(&(texture.texels.width as u64).to_le_bytes());
            let bytes = texture
                .texels
                .channels
                .iter()
                .flatten()
                .flat_map(|c| c.to_le_bytes());
            hasher.update(&bytes.collect::<Vec<u8>>());
        }
        hasher.finalize().to_hex().to_string()
    }
}
