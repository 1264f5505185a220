//! Filters on a floor of squares that goes on to the horizon.

use std::path::Path;

use glam::DVec2;
use heliodon::camera::Camera;
use heliodon::film::Film;
use heliodon::measure::{Figure, Panel, Scale};
use heliodon::read::{Options, read_bytes};
use heliodon::render::render;
use heliodon::scene::{Scene, Setting};
use heliodon::texture::Filter;
use rayon::prelude::*;

use super::series::{Failed, Series};

pub(crate) const COLUMNS: [&str; 4] = ["what", "filter", "texels", "rmse"];

/// The side of the picture in pixels; the horizon is in its middle.
const SIDE: usize = 64;
/// The vertical field of view, in degrees.
const VIEW: f64 = 40.0;
/// The side of a square, where the eye is 1 above the floor.
const SQUARE: f64 = 0.25;
/// How far the floor goes.
const FAR: f64 = 1e6;
/// Where the eye looks, to the side of straight ahead: a picture each.
const TURNS: [f64; 4] = [0.11, 0.37, 0.61, 0.83];
/// How many lines a row of pixels is cut into to find the truth.
const LINES: u32 = 4096;
/// Rows below the horizon that belong together: from each of these to the next.
const ROWS: [usize; 11] = [0, 1, 2, 3, 4, 6, 8, 11, 16, 22, SIDE / 2];

/// What is tried: a name, a filter and how many rays.
const TRIED: [(&str, Filter, &str); 6] = [
    ("nearest", Filter::Nearest, "1"),
    ("bilinear", Filter::Bilinear, "1"),
    ("mipmap", Filter::Mipmap, "1"),
    ("anisotropic", Filter::Anisotropic, "1"),
    ("64 rays, nearest", Filter::Nearest, "64"),
    ("exact", Filter::Exact, "1"),
];

/// The errors of what is tried.
pub(crate) fn measured() -> Result<Vec<Series>, Failed> {
    let folder = tempfile::tempdir()?;
    let squares =
        image::GrayImage::from_fn(2, 2, |x, y| image::Luma([if x == y { 0 } else { 255 }]));
    squares.save(folder.path().join("squares.png"))?;
    let mut errors = vec![[0.0; SIDE / 2]; TRIED.len()];
    for turn in TURNS {
        let mut scene = scene(turn, folder.path())?;
        let truth = truth(&scene)?;
        for ((_, filter, samples), errors) in TRIED.iter().zip(&mut errors) {
            let settings = [("texture-filter", filter.word()), ("samples", samples)];
            for (word, text) in settings {
                scene.settings = scene.settings.with(&Setting::new(word, text)?);
            }
            let drawn = render(&scene, &|_| ());
            let (film, _) = drawn.map_err(|error| error.reason)?;
            add_squares(errors, &film, &truth);
        }
    }
    let series = TRIED.iter().zip(&errors);
    Ok(series
        .map(|((name, ..), errors)| Series::new("horizon", name, points(errors)))
        .collect())
}

pub(crate) fn figure(all: &[Series]) -> Figure {
    let curves = all.iter().enumerate();
    let curves = curves.map(|(hue, series)| series.curve(hue, series.name.clone()));
    Figure {
        panels: vec![Panel {
            title: "",
            across: Scale::of("texels that a pixel covers in depth"),
            curves: curves.collect(),
        }],
        up: Scale::of("RMSE of a pixel (1 = white)"),
    }
}

/// The floor, seen in a direction.
fn scene(turn: f64, folder: &Path) -> Result<Scene, Failed> {
    let text = format!(
        "image {SIDE} {SIDE}
        camera {{ viewpoint 0.1 1 0.07; look-at {} 1 -0.93; field-of-view {VIEW} }}
        lighting {{ view-falloff none }}
        texture \"squares\" \"squares.png\"
        material \"paint\" {{ ambient 1 }}
        texture-plane {{
            material \"paint\"
            point -{FAR} 0 {FAR}; normal 0 1 0; xdir 1 0 0; dimensions {} {}
            texture \"squares\" mode=\"repeat\" texel={SQUARE}
        }}",
        0.1 + turn,
        2.0 * FAR,
        2.0 * FAR
    );
    let reading = read_bytes("floor", text.into(), folder.into(), &Options::default());
    Ok(reading.map_err(|no| format!("{:?}", no.diagnostics))?.scene)
}

/// What every pixel below the horizon shows, row by row.
///
/// The eye is level, so a line of the picture shows a line of the floor, all of it equally far: its
/// mean is that of the squares along it, which is exact. A row is the mean of many lines.
fn truth(scene: &Scene) -> Result<Vec<f64>, Failed> {
    let camera = scene
        .view
        .camera(scene.settings.width, scene.settings.height);
    let camera = camera.map_err(|error| error.reason)?;
    let pixels = (0..SIDE * SIDE / 2).into_par_iter();
    Ok(pixels
        .map(|at| {
            let (column, row) = ((at % SIDE) as f64, (at / SIDE) as f64);
            let upper = (SIDE / 2) as f64 - 0.5 - row;
            let lines = (0..LINES).map(|line| {
                let y = upper - (f64::from(line) + 0.5) / f64::from(LINES);
                let ends = [column - 0.5, column + 0.5].map(|x| square_met(&camera, x, y));
                mean_along(ends)
            });
            lines.sum::<f64>() / f64::from(LINES)
        })
        .collect())
}

/// Where the ray through a place of the picture meets the floor, counted in squares.
fn square_met(camera: &Camera, x: f64, y: f64) -> DVec2 {
    let ray = camera.ray(x, y);
    let place = camera.viewpoint() + ray.dir * (camera.viewpoint().y / -ray.dir.y);
    DVec2::new(place.x + FAR, FAR - place.z) / SQUARE
}

/// The share of a way that leads over white squares; beyond the floor all is black.
fn mean_along([from, to]: [DVec2; 2]) -> f64 {
    let way = to - from;
    if from.max(to).max_element() > 2.0 * FAR / SQUARE {
        return 0.0;
    }
    let mut crossings = vec![0.0, 1.0];
    for axis in [0, 1] {
        let [low, high] = [from[axis].min(to[axis]), from[axis].max(to[axis])];
        let mut line = low.floor() + 1.0;
        while line < high {
            crossings.push((line - from[axis]) / way[axis]);
            line += 1.0;
        }
    }
    crossings.sort_by(f64::total_cmp);
    let steps = crossings.windows(2).map(|step| {
        let square = (from + way * f64::midpoint(step[0], step[1])).floor();
        // The texture's first row is its upper one, and the floor's first row of texels the lower.
        let is_white = (square.x + square.y) % 2.0 == 0.0;
        if is_white { step[1] - step[0] } else { 0.0 }
    });
    steps.sum()
}

/// Adds the squares of a picture's errors in each row.
fn add_squares(sums: &mut [f64], film: &Film, truth: &[f64]) {
    let pixels = &film.pixels()[SIDE * SIDE / 2..];
    let rows = pixels.chunks(SIDE).zip(truth.chunks(SIDE));
    for (sum, (row, truth)) in sums.iter_mut().zip(rows) {
        let errors = row.iter().zip(truth).map(|(pixel, truth)| pixel.r - truth);
        *sum += errors.map(|error| error * error).sum::<f64>();
    }
}

/// How many texels a pixel covers in depth, and the root of the mean squared error there.
fn points(squares: &[f64]) -> Vec<[f64; 2]> {
    let step = 2.0 * libm::tan(VIEW.to_radians() / 2.0) / SIDE as f64;
    let groups = ROWS.windows(2).map(|ends| {
        let [first, end] = [ends[0], ends[1]];
        let pixels = ((end - first) * SIDE * TURNS.len()) as f64;
        let mean = squares[first..end].iter().sum::<f64>() / pixels;
        let texels = |row: usize| {
            let down = row as f64 + 0.5;
            1.0 / (step * down * down * SQUARE)
        };
        [(texels(first) * texels(end - 1)).sqrt(), mean.sqrt()]
    });
    let mut groups: Vec<_> = groups.collect();
    groups.reverse();
    groups
}
