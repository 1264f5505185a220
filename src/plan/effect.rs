//! The effects of a scene, and the decisions about them.

use serde::Serialize;

use crate::language::Location;
use crate::light::Light;
use crate::scene::RenderSettings;
use crate::surface::Surface;

/// An optical or imaging effect, simulated only if the scene contains it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Effect {
    /// Shadows of point lights.
    Shadows,
    /// Shadows of lamps, which have penumbras.
    SoftShadows,
    /// Reflections in specular surfaces.
    Mirrors,
    /// Light through transparent surfaces.
    Transparency,
    /// Refraction at surfaces with an index of refraction.
    Refraction,
    /// Specular highlights of lights on shiny surfaces.
    Glints,
    /// Lights that are limited to a cone.
    SpotCones,
    /// Lights that shine through a slide.
    Projectors,
    /// Texture images on surfaces.
    Textures,
    /// Filters over the footprint of a ray on a texture.
    TextureFilter,
    /// Several rays through each pixel.
    Antialiasing,
    /// A nonlinear transfer function from intensities to code values.
    TransferCurve,
}

impl Effect {
    /// All effects, in the order of reports.
    pub const ALL: [Self; 12] = [
        Self::Shadows,
        Self::SoftShadows,
        Self::Mirrors,
        Self::Transparency,
        Self::Refraction,
        Self::Glints,
        Self::SpotCones,
        Self::Projectors,
        Self::Textures,
        Self::TextureFilter,
        Self::Antialiasing,
        Self::TransferCurve,
    ];

    /// The name in reports.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::Shadows => "shadows",
            Self::SoftShadows => "soft shadows",
            Self::Mirrors => "mirrors",
            Self::Transparency => "transparency",
            Self::Refraction => "refraction",
            Self::Glints => "glints",
            Self::SpotCones => "spot cones",
            Self::Projectors => "projectors",
            Self::Textures => "textures",
            Self::TextureFilter => "filters",
            Self::Antialiasing => "antialiasing",
            Self::TransferCurve => "transfer curve",
        }
    }
}

/// The decision about an effect, with its reason.
#[derive(Debug, Clone, PartialEq)]
pub struct Decision {
    /// The effect.
    pub effect: Effect,
    /// True if it is simulated.
    pub on: bool,
    /// The reason, as a text.
    pub why: String,
    /// The causes in the scene, in file order; empty if it is not simulated.
    pub causes: Vec<Cause>,
}

/// A cause of an effect: an entity of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Cause {
    /// Its type and name.
    pub title: String,
    /// Its position in the scene file; `None` if it was not read from a file.
    pub location: Option<Location>,
}

impl Cause {
    /// A surface as a cause.
    #[must_use]
    pub fn of_surface(surface: &dyn Surface) -> Self {
        let common = surface.common();
        let word = surface.describe().schema.word;
        Self::new(word, common.name.as_deref(), common.location)
    }

    /// A light as a cause.
    #[must_use]
    pub fn of_light(light: &Light) -> Self {
        let word = light.describe().schema.word;
        Self::new(word, light.name.as_deref(), light.place)
    }

    /// The render settings as a cause.
    #[must_use]
    pub fn of_picture(picture: &RenderSettings) -> Self {
        Self::new(RenderSettings::SCHEMA.word, None, picture.place)
    }

    fn new(word: &str, name: Option<&str>, location: Option<Location>) -> Self {
        let title = name.map_or_else(|| word.to_owned(), |name| format!("{word} {name:?}"));
        Self { title, location }
    }
}
