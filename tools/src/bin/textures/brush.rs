//! Repaints a picture with brush strokes, broad ones first and fine ones where it has detail.

use crate::canvas::{Canvas, as_float};
use crate::colour::Colour;
use crate::noise::{cell, corner, fractal, random};
use crate::shape::{Point, length, smooth};
use crate::stroke::{Stroke, draw};

/// One round of strokes, all with the same brush.
struct Layer {
    /// Half the width of the brush in pixels.
    radius: f64,
    /// Half the length of a stroke in pixels.
    reach: f64,
    /// How much the picture must vary nearby for a stroke to be worth it.
    threshold: f64,
}

/// The rounds, from the underpainting to the finest brush.
const LAYERS: [Layer; 4] = [
    Layer {
        radius: 9.0,
        reach: 26.0,
        threshold: -1.0,
    },
    Layer {
        radius: 4.5,
        reach: 14.0,
        threshold: 0.03,
    },
    Layer {
        radius: 2.2,
        reach: 7.0,
        threshold: 0.05,
    },
    Layer {
        radius: 1.2,
        reach: 3.6,
        threshold: 0.08,
    },
];

/// How much the colour may change along a stroke.
const STRAY: f64 = 0.15;

/// Paints `source` anew on a copy of itself.
pub(crate) fn repaint(source: &Canvas) -> Canvas {
    let mut canvas = source.clone();
    for (number, layer) in (0_u32..).zip(&LAYERS) {
        let mut strokes = plan(source, layer, 100 + number * 10);
        // A shuffled order keeps neighbours from overlapping all in the same way.
        strokes.sort_by(|a, b| a.key.total_cmp(&b.key));
        for stroke in &strokes {
            draw(&mut canvas, stroke);
        }
    }
    canvas
}

/// The colour of the picture at a point; points outside count as the nearest inside.
fn sample(source: &Canvas, p: Point) -> Colour {
    let clip = |value: f64, size: usize| value.clamp(0.0, as_float(size) - 1.0);
    let column = usize::try_from(cell(clip(p.0, source.width()))).unwrap_or(0);
    let row = usize::try_from(cell(clip(p.1, source.height()))).unwrap_or(0);
    source.get(column, row)
}

/// How bright a colour looks.
fn brightness(colour: Colour) -> f64 {
    let [red, green, blue] = colour.0;
    0.30 * red + 0.59 * green + 0.11 * blue
}

/// Chooses the strokes of a layer on a jittered grid.
fn plan(source: &Canvas, layer: &Layer, seed: u32) -> Vec<Stroke> {
    let pitch = layer.radius * 0.95;
    let columns = cell(as_float(source.width()) / pitch) + 1;
    let rows = cell(as_float(source.height()) / pitch) + 1;
    let places = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
    places
        .filter_map(|(column, row)| {
            let pick = |slot: i64| random([column, row, slot], seed);
            let middle = (
                (corner(column) + pick(0)) * pitch,
                (corner(row) + pick(1)) * pitch,
            );
            stroke(source, layer, middle, pick(2), [pick(3), pick(4)])
        })
        .collect()
}

/// The stroke around a point, or nothing where the picture is even enough without it.
fn stroke(
    source: &Canvas,
    layer: &Layer,
    middle: Point,
    key: f64,
    luck: [f64; 2],
) -> Option<Stroke> {
    let step = layer.radius.max(1.5);
    let at = |dx: f64, dy: f64| sample(source, (middle.0 + dx * step, middle.1 + dy * step));
    let here = at(0.0, 0.0);
    let sides = [at(1.0, 0.0), at(-1.0, 0.0), at(0.0, 1.0), at(0.0, -1.0)];
    let detail = sides
        .iter()
        .map(|&side| side.difference(here))
        .fold(0.0, f64::max);
    if detail < layer.threshold {
        return None;
    }
    let [right, left, below, above] = sides.map(brightness);
    let slope = (right - left, below - above);
    // Strokes follow the edges; in even places they wander with a slow swirl.
    let swirl = fractal(middle.0 / 130.0, middle.1 / 130.0, 2, 7, [0, 0]) - 0.5;
    let swirl = (0.75 + swirl, -0.65 + 2.0 * swirl);
    let pull = smooth(0.0, 0.06, length(slope.0, slope.1));
    let size = length(slope.0, slope.1).max(1e-9);
    let mut edge = (-slope.1 / size, slope.0 / size);
    if edge.0 * swirl.0 + edge.1 * swirl.1 < 0.0 {
        edge = (-edge.0, -edge.1);
    }
    let along = (
        edge.0 * pull + swirl.0 * (1.0 - pull) + 0.25 * (luck[0] - 0.5),
        edge.1 * pull + swirl.1 * (1.0 - pull) + 0.25 * (luck[1] - 0.5),
    );
    let size = length(along.0, along.1).max(1e-9);
    let along = (along.0 / size, along.1 / size);
    // The mean along the stroke keeps a stroke from smearing one odd pixel over its length.
    let mean = (0..5).fold(Colour::BLACK, |sum, index| {
        let walk = (f64::from(index) - 2.0) / 2.0 * layer.reach * 0.5;
        sum + sample(
            source,
            (middle.0 + along.0 * walk, middle.1 + along.1 * walk),
        ) * 0.2
    });
    // A stroke ends where the picture becomes another thing.
    let same = |way: f64| {
        let steps = (1..=6).map(|index| layer.reach * f64::from(index) / 6.0);
        let apart = |walk: f64| {
            let p = (
                middle.0 + way * along.0 * walk,
                middle.1 + way * along.1 * walk,
            );
            sample(source, p).difference(here) < STRAY
        };
        steps.take_while(|&walk| apart(walk)).last().unwrap_or(0.0)
    };
    let reach = same(1.0).min(same(-1.0)).max(layer.radius * 0.6);
    let mix = here.mix(mean, 0.5) * (1.0 + 0.05 * (luck[0] - 0.5));
    let warm = Colour([
        1.0 + 0.04 * (luck[1] - 0.5),
        1.0,
        1.0 - 0.05 * (luck[1] - 0.5),
    ]);
    Some(Stroke {
        middle,
        along,
        colour: mix.filter(warm),
        reach,
        radius: layer.radius,
        key,
    })
}
