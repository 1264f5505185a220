//! What there is to be seen in each pixel, so that it can be said where a picture errs.

use rayon::prelude::*;
use serde::Serialize;

use crate::language::ValueError;
use crate::plan::{Plan, Scope};
use crate::render::{Arrival, Event, Probe, Tracer};
use crate::scene::Scene;

/// What is in a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Spot {
    /// The edge of a surface, or the line where two meet.
    Edge,
    /// The border of a shadow.
    ShadowBorder,
    /// An edge or a shadow's border that is seen in a mirror or through a surface.
    ReflectedEdge,
    /// An image on a surface, or its reflection, away from edges.
    Texture,
    /// Anything else: a smooth surface or nothing.
    Smooth,
}

impl Spot {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Edge,
        Self::ShadowBorder,
        Self::ReflectedEdge,
        Self::Texture,
        Self::Smooth,
    ];

    /// Where that is, in words.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Self::Edge => "at edges of surfaces",
            Self::ShadowBorder => "at borders of shadows",
            Self::ReflectedEdge => "at edges seen by mirrored or transmitted rays",
            Self::Texture => "in images on surfaces",
            Self::Smooth => "on smooth surfaces",
        }
    }
}

/// What is in each pixel of a picture, row by row from the top.
#[derive(Debug)]
pub(super) struct Spots {
    /// What is there.
    pub(super) spots: Vec<Spot>,
    /// The surface that is seen in the pixel's middle.
    pub(super) surfaces: Vec<Option<usize>>,
    /// The width of the picture in pixels.
    pub(super) width: usize,
}

/// What the ray through the middle of a pixel came by.
#[derive(Debug, Clone, Default, PartialEq)]
struct Track {
    /// The surfaces that it and those it caused met.
    met: Vec<usize>,
    /// The lights that were hidden where it met the first, and on its further way.
    hidden: [Vec<usize>; 2],
}

impl Probe for Track {
    fn on(&mut self, event: Event<'_>) {
        match event {
            Event::Hit(surface, ..) => self.met.push(surface),
            Event::Light(light, Arrival::Hidden) => {
                self.hidden[usize::from(self.met.len() > 1)].push(light);
            }
            _ => {}
        }
    }
}

impl Spots {
    /// Looks at the middle of every pixel and at its neighbours.
    pub(super) fn of(scene: &Scene) -> Result<Self, ValueError> {
        let plan = Plan::new(scene, Scope::CalledFor)?;
        let tracer = Tracer::new(&plan);
        let (width, height) = (
            scene.settings.width as usize,
            scene.settings.height as usize,
        );
        let tracks: Vec<Track> = (0..width * height)
            .into_par_iter()
            .map(|at| {
                let mut track = Track::default();
                #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
                let (x, y) = ((at % width) as f64, (height - 1 - at / width) as f64);
                tracer.sees(x, y, &mut track);
                track
            })
            .collect();
        let textured = |surface: &usize| scene.surfaces[*surface].texture().is_some();
        let spot = |at: usize| {
            let (track, column) = (&tracks[at], at % width);
            let neighbours = [
                (column > 0).then(|| at - 1),
                (column + 1 < width).then(|| at + 1),
                at.checked_sub(width),
                (at + width < tracks.len()).then(|| at + width),
            ];
            let neighbours = neighbours.into_iter().flatten().map(|at| &tracks[at]);
            let differs =
                |by: fn(&Track, &Track) -> bool| neighbours.clone().any(|it| by(track, it));
            if differs(|one, other| one.met.first() != other.met.first()) {
                Spot::Edge
            } else if differs(|one, other| one.hidden[0] != other.hidden[0]) {
                Spot::ShadowBorder
            } else if differs(|one, other| one != other) {
                Spot::ReflectedEdge
            } else if track.met.iter().any(textured) {
                Spot::Texture
            } else {
                Spot::Smooth
            }
        };
        Ok(Self {
            spots: (0..tracks.len()).into_par_iter().map(spot).collect(),
            surfaces: tracks
                .iter()
                .map(|track| track.met.first().copied())
                .collect(),
            width,
        })
    }
}
