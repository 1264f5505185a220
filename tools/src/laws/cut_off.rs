//! The promise of the cut-off, and what is kept of it.

use heliodon::film::Film;
use heliodon::measure::{Curve, Figure, Panel, Scale};
use heliodon::read::{Options, read_file};
use heliodon::render::render;
use heliodon::scene::{Scene, Setting};

use super::series::{Failed, Series};

pub(crate) const COLUMNS: [&str; 4] = ["what", "scene", "cut-off", "largest-error"];

/// Scenes with mirrors that face each other, and with glass.
const SCENES: [&str; 3] = ["two-cameras-look-at", "tiled-floor-mirrors", "glass-ball"];
const SIZE: [u32; 2] = [120, 90];

/// The cut-offs are powers of two: 1, 1/2, … down to this one.
const HALVINGS: i32 = 16;

/// With this one nothing that matters is cut off.
const TRUTH: f64 = 1e-9;

/// The largest error of a channel for each cut-off, in intensity.
pub(crate) fn measured() -> Result<Vec<Series>, Failed> {
    let of = |name: &&str| -> Result<Series, Failed> {
        let mut scene = scene(name)?;
        let truth = drawn(&mut scene, TRUTH)?;
        let mut points = Vec::new();
        for halving in (0..=HALVINGS).rev() {
            let cut_off = libm::exp2(f64::from(-halving));
            let film = drawn(&mut scene, cut_off)?;
            points.push([cut_off, largest(&film, &truth)]);
        }
        Ok(Series::new("cut-off", name, points))
    };
    SCENES.iter().map(of).collect()
}

pub(crate) fn figure(all: &[Series]) -> Figure {
    let ends = [libm::exp2(f64::from(-HALVINGS)), 1.0];
    let bound = Curve {
        label: "the bound".to_owned(),
        hue: 6,
        is_bound: true,
        points: ends.map(|end| [end, end]).to_vec(),
    };
    let curves = all.iter().enumerate();
    let curves = curves.map(|(hue, series)| series.curve(hue, series.name.clone()));
    Figure {
        panels: vec![Panel {
            title: "",
            across: Scale::of("cut-off, in intensity"),
            curves: [bound].into_iter().chain(curves).collect(),
        }],
        up: Scale::of("largest error of a pixel, in intensity"),
    }
}

fn scene(name: &str) -> Result<Scene, Failed> {
    let options = Options {
        size: Some(SIZE),
        settings: vec![Setting::new("samples", "1")?],
        ..Options::default()
    };
    let reading = read_file(format!("scenes/{name}.kdl").as_ref(), &options)?;
    Ok(reading.map_err(|no| format!("{:?}", no.diagnostics))?.scene)
}

fn drawn(scene: &mut Scene, cut_off: f64) -> Result<Film, Failed> {
    scene.settings.cut_off = cut_off;
    let drawn = render(scene, &|_| ());
    Ok(drawn.map_err(|error| error.reason)?.0)
}

/// The largest difference of a channel.
fn largest(one: &Film, other: &Film) -> f64 {
    let pairs = one.pixels().iter().zip(other.pixels());
    let channels = pairs.flat_map(|(one, other)| {
        let pairs = one.channels().into_iter().zip(other.channels());
        pairs.map(|(one, other)| (one - other).abs())
    });
    channels.fold(0.0, f64::max)
}
