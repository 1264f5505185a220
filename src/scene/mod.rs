//! Scenes: settings, camera, lights and surfaces.

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
    /// The picture's size and accuracy settings.
    pub settings: RenderSettings,
    /// The camera.
    pub view: View,
    /// The falloff of light with distance.
    pub lighting: Lighting,
    /// The textures in use, in file order.
    pub textures: Vec<Arc<Texture>>,
    /// The materials in file order.
    pub materials: Vec<Arc<Material>>,
    /// The lights in file order; they are summed in this order.
    pub lights: Vec<Light>,
    /// The surfaces in file order; the first of coincident ones is visible.
    pub surfaces: Vec<Box<dyn Surface>>,
    /// The planes and borders that surfaces share.
    pub shared: Vec<Shared>,
    /// The source texts.
    pub sources: Sources,
}

impl Scene {
    /// True if a texture is looked up with a filter wider than one texel.
    #[must_use]
    pub fn is_filtered(&self) -> bool {
        let mut surfaces = self.surfaces.iter();
        self.settings.texture_filter != Filter::Nearest
            && surfaces.any(|surface| surface.texture().is_some())
    }

    /// The schemas of all nodes of a scene. `include` belongs to files only.
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

    /// The scene as nodes of the scene language, with all defaults.
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

    /// Hash of the numbers, names and texels of the scene.
    ///
    /// It does not depend on comments, layout, file names or the scene's language.
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
