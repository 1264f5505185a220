//! Image feature in each pixel: edge, shadow border, texture.

use rayon::prelude::*;
use serde::Serialize;

use crate::language::ValueError;
use crate::plan::{Cause, Plan, Scope};
use crate::render::{Arrival, Event, Probe, Tracer};
use crate::scene::Scene;

/// Kind of place in a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Feature {
    /// Edge of a surface, or line where two intersect.
    Edge,
    /// Border of a shadow.
    ShadowBorder,
    /// Edge or shadow border seen by mirrored or transmitted rays.
    ReflectedEdge,
    /// Texture on a surface, or its reflection, away from edges.
    Texture,
    /// Anything else: a smooth surface or the background.
    Smooth,
}

impl Feature {
    /// All of them.
    pub(super) const ALL: [Self; 5] = [
        Self::Edge,
        Self::ShadowBorder,
        Self::ReflectedEdge,
        Self::Texture,
        Self::Smooth,
    ];

    /// Place in words, with its preposition.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Self::Edge => "at edges of surfaces",
            Self::ShadowBorder => "at shadow borders",
            Self::ReflectedEdge => "at edges in mirrors or behind glass",
            Self::Texture => "in textures",
            Self::Smooth => "on smooth surfaces",
        }
    }
}

/// Features of a picture, row by row from the top.
#[derive(Debug)]
pub(super) struct FeatureMap {
    pub(super) features: Vec<Feature>,
    /// Surface in the middle of each pixel.
    pub(super) surfaces: Vec<Option<usize>>,
    /// Kind and name of each surface of the scene.
    pub(super) titles: Vec<String>,
    /// Width of the picture in pixels.
    pub(super) width: usize,
}

/// Path of the ray through the middle of a pixel.
#[derive(Debug, Clone, Default, PartialEq)]
struct Path {
    /// Surfaces hit by the ray and by those it causes.
    hits: Vec<usize>,
    /// Lights hidden at the first hit, and at later ones.
    hidden: [Vec<usize>; 2],
}

impl Probe for Path {
    fn on(&mut self, event: Event<'_>) {
        match event {
            Event::Hit(surface, ..) => self.hits.push(surface),
            Event::Light(light, Arrival::Hidden) => {
                self.hidden[usize::from(self.hits.len() > 1)].push(light);
            }
            _ => {}
        }
    }
}

impl FeatureMap {
    /// Compares the path through the middle of each pixel with those of its four neighbours.
    pub(super) fn of(scene: &Scene) -> Result<Self, ValueError> {
        let plan = Plan::new(scene, Scope::CalledFor)?;
        let tracer = Tracer::new(&plan);
        let [width, height] = [scene.settings.width, scene.settings.height].map(|it| it as usize);
        let path = |at: usize| {
            let mut path = Path::default();
            #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
            let (x, y) = ((at % width) as f64, (height - 1 - at / width) as f64);
            tracer.sees(x, y, &mut path);
            path
        };
        let paths: Vec<Path> = (0..width * height).into_par_iter().map(path).collect();
        let textured = |surface: &usize| scene.surfaces[*surface].texture().is_some();
        let feature = |at: usize| {
            let (path, column) = (&paths[at], at % width);
            let neighbours = [
                (column > 0).then(|| at - 1),
                (column + 1 < width).then(|| at + 1),
                at.checked_sub(width),
                (at + width < paths.len()).then(|| at + width),
            ];
            let neighbours = neighbours.into_iter().flatten().map(|at| &paths[at]);
            let differs = |by: fn(&Path, &Path) -> bool| neighbours.clone().any(|it| by(path, it));
            if differs(|one, other| one.hits.first() != other.hits.first()) {
                Feature::Edge
            } else if differs(|one, other| one.hidden[0] != other.hidden[0]) {
                Feature::ShadowBorder
            } else if differs(|one, other| one != other) {
                Feature::ReflectedEdge
            } else if path.hits.iter().any(textured) {
                Feature::Texture
            } else {
                Feature::Smooth
            }
        };
        Ok(Self {
            features: (0..paths.len()).into_par_iter().map(feature).collect(),
            surfaces: paths
                .iter()
                .map(|path| path.hits.first().copied())
                .collect(),
            titles: scene
                .surfaces
                .iter()
                .map(|it| Cause::of_surface(&**it).title)
                .collect(),
            width,
        })
    }
}
