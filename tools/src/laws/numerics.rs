//! The share of wrong pixels of each arithmetic on scenes that are hard.

use heliodon::film::Film;
use heliodon::math::{Numerics, Rgb};
use heliodon::measure::{Change, Figure, Panel, Scale};
use heliodon::read::{Options, read_bytes};
use heliodon::render::render;
use heliodon::scene::Setting;

use super::series::{Failed, Series};
use super::variants::{moved, nodes, nodes_of, scaled, text, wall};

pub(crate) const COLUMNS: [&str; 4] = ["scene", "numerics", "what", "wrong"];

/// The arithmetics in the order of their curves.
const NUMERICS: [Numerics; 3] = [Numerics::ClassicF32, Numerics::Classic, Numerics::Robust];

const ROOM: &str = "docs/numerics/room.kdl";

/// Powers of ten by which a scene is moved, and those of its size.
const MOVES: [i32; 13] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12];
const SIZES: [i32; 13] = [-12, -10, -8, -6, -4, -2, 0, 2, 4, 6, 8, 10, 12];

/// A hard scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Hard {
    /// The corner of a room, further and further away from the origin.
    Moved,
    /// The same in other units of length.
    Scaled,
    /// A wall of tiles before a bright light, in other units. Rays aim at joints, and whichever tile they
    /// meet is right; what shows no tile is wrong.
    Wall,
}

/// The errors of all arithmetics on all scenes.
pub(crate) fn measured() -> Result<Vec<Series>, Failed> {
    let all = Hard::ALL.map(Hard::measured);
    Ok(all.into_iter().collect::<Result<Vec<_>, _>>()?.concat())
}

impl Hard {
    const ALL: [Self; 3] = [Self::Moved, Self::Scaled, Self::Wall];

    fn word(self) -> &'static str {
        match self {
            Self::Moved => "moved",
            Self::Scaled => "scaled",
            Self::Wall => "wall",
        }
    }

    /// The errors of all arithmetics, at powers of ten.
    fn measured(self) -> Result<Vec<Series>, Failed> {
        let nodes = match self {
            Self::Moved | Self::Scaled => nodes(ROOM),
            Self::Wall => nodes_of(&wall()),
        };
        let truth = picture(&text(&nodes), Numerics::Robust)?;
        let mut glazes = truth.pixels().to_vec();
        glazes.dedup();
        let share = |power: i32, numerics| -> Result<f64, Failed> {
            let text = match self {
                Self::Scaled | Self::Wall => scaled(&nodes, power),
                Self::Moved => moved(&nodes, libm::exp10(f64::from(power))),
            };
            let film = picture(&text, numerics)?;
            Ok(match self {
                Self::Moved | Self::Scaled => Change::between(&truth, &film).pixels,
                Self::Wall => share_without(&film, &glazes),
            })
        };
        let of = |numerics: Numerics| -> Result<Series, Failed> {
            let points = self.powers().iter().map(|power| {
                let point = [libm::exp10(f64::from(*power)), share(*power, numerics)?];
                Ok(point)
            });
            let points = points.collect::<Result<_, Failed>>()?;
            Ok(Series::new(self.word(), numerics.word(), points))
        };
        NUMERICS.into_iter().map(of).collect()
    }

    /// All the powers of ten that are shown.
    fn powers(self) -> &'static [i32] {
        match self {
            Self::Moved => &MOVES,
            Self::Scaled | Self::Wall => &SIZES,
        }
    }
}

pub(crate) fn figure(all: &[Series]) -> Figure {
    let panels = Hard::ALL.map(|hard| {
        let (title, across) = match hard {
            Hard::Moved => ("a room, moved", "moved by, in units"),
            Hard::Scaled => ("the room in other units", "size"),
            Hard::Wall => ("a wall of tiles in other units", "size"),
        };
        let series = all.iter().filter(|series| series.panel == hard.word());
        let curves = series.enumerate();
        let curves = curves.map(|(hue, series)| series.curve(hue, series.name.clone()));
        Panel {
            title,
            across: Scale::of(across),
            curves: curves.collect(),
        }
    });
    Figure {
        panels: panels.to_vec(),
        up: Scale {
            title: "share of wrong pixels",
            write: |share| format!("{} %", (1e6 * 100.0 * share).round() / 1e6),
        },
    }
}

fn picture(text: &str, numerics: Numerics) -> Result<Film, Failed> {
    let options = Options {
        settings: vec![Setting::new("numerics", numerics.word())?],
        ..Options::default()
    };
    let reading = read_bytes("scene", text.into(), "".into(), &options);
    let scene = reading.map_err(|no| format!("{:?}", no.diagnostics))?.scene;
    Ok(render(&scene, &|_| ()).map_err(|error| error.reason)?.0)
}

/// The share of the pixels that have none of these colours.
fn share_without(film: &Film, colors: &[Rgb]) -> f64 {
    let is_like = |one: &Rgb, other: &Rgb| {
        let mut channels = one.channels().into_iter().zip(other.channels());
        channels.all(|(one, other)| (one - other).abs() < 0.5 / 255.0)
    };
    let odd = film.pixels().iter();
    let odd = odd.filter(|pixel| !colors.iter().any(|color| is_like(pixel, color)));
    odd.count() as f64 / film.pixels().len() as f64
}
