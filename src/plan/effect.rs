//! The effects that a scene can call for, and what was decided about them.

use serde::Serialize;

use crate::language::Location;
use crate::light::Light;
use crate::scene::RenderSettings;
use crate::surface::Surface;

/// Something that costs time and changes pictures, if a scene calls for it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Effect {
    /// Surfaces that stand before lights.
    Shadows,
    /// Surfaces that stand before lamps.
    SoftShadows,
    /// Surfaces that show what is before them.
    Mirrors,
    /// Surfaces that let light through.
    Transparency,
    /// Surfaces that bend what goes through them.
    Refraction,
    /// The images of lights on shiny surfaces.
    Glints,
    /// Lights that shine into a cone.
    SpotCones,
    /// Lights that shine through a slide.
    Projectors,
    /// Images on surfaces.
    Textures,
    /// More of an image in a pixel than one texel.
    TextureFilter,
    /// Several rays through each pixel.
    Antialiasing,
    /// A curve from intensities to code values.
    TransferCurve,
}

impl Effect {
    /// All of them, in the order in which they are explained.
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

    /// What it is called.
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

/// Whether an effect is simulated, and why.
#[derive(Debug, Clone, PartialEq)]
pub struct Decision {
    /// What was decided about.
    pub effect: Effect,
    /// Whether it is simulated.
    pub on: bool,
    /// Why, in words.
    pub why: String,
    /// What of the scene calls for it, in file order; empty if nothing does.
    pub causes: Vec<Cause>,
}

/// A thing in the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Cause {
    /// Its kind and name.
    pub title: String,
    /// Where it stands in the scene file, if it was read from one.
    pub location: Option<Location>,
}

impl Cause {
    /// A surface.
    #[must_use]
    pub fn of_surface(surface: &dyn Surface) -> Self {
        let common = surface.common();
        let word = surface.describe().schema.word;
        Self::new(word, common.name.as_deref(), common.location)
    }

    /// A light.
    #[must_use]
    pub fn of_light(light: &Light) -> Self {
        let word = light.describe().schema.word;
        Self::new(word, light.name.as_deref(), light.place)
    }

    /// The picture.
    #[must_use]
    pub fn of_picture(picture: &RenderSettings) -> Self {
        Self::new(RenderSettings::SCHEMA.word, None, picture.place)
    }

    fn new(word: &str, name: Option<&str>, location: Option<Location>) -> Self {
        let title = name.map_or_else(|| word.to_owned(), |name| format!("{word} {name:?}"));
        Self { title, location }
    }
}
