//! Rays where straight borders cross pixels.

use heliodon::camera::{Pattern, SamplePositions};
use heliodon::math::scramble;
use heliodon::measure::{Figure, Panel, Scale, exponent};

use super::series::{Failed, Series};

/// The patterns in the order of their curves. Of one ray, `grid` is `center`.
const PATTERNS: [Pattern; 4] = [
    Pattern::Random,
    Pattern::Stratified,
    Pattern::Sobol,
    Pattern::Grid,
];

/// How many rays go through a pixel.
const COUNTS: [u32; 7] = [1, 4, 16, 64, 256, 1024, 4096];

/// From this many rays on the powers are fitted.
const FROM: f64 = 16.0;

pub(crate) const COLUMNS: [&str; 4] = ["what", "pattern", "rays", "rmse"];

/// The errors of all patterns.
pub(crate) fn measured() -> Result<Vec<Series>, Failed> {
    let series = PATTERNS.map(|pattern| {
        let points = COUNTS
            .iter()
            .map(|count| [f64::from(*count), error(pattern, *count)]);
        Series::new("edges", pattern.word(), points.collect())
    });
    Ok(series.to_vec())
}

pub(crate) fn figure(all: &[Series]) -> Figure {
    let curves = all.iter().enumerate().map(|(hue, series)| {
        let far = series.points.iter().filter(|point| point[0] >= FROM);
        let power = exponent(far.copied()).unwrap_or(0.0);
        series.curve(hue, format!("{}  N^−{:.2}", series.name, power.abs()))
    });
    Figure {
        panels: vec![Panel {
            title: "",
            across: Scale::of("rays through a pixel, N"),
            curves: curves.collect(),
        }],
        up: Scale::of("RMSE where a border crosses a pixel (1 = white)"),
    }
}

/// The root of the mean squared error of so many rays where straight borders cross 1024 pixels.
fn error(pattern: Pattern, count: u32) -> f64 {
    let pixels = 1024u32;
    let mut sum = 0.0;
    for pixel in 0..pixels {
        let drawn = |number: u64| {
            (scramble(scramble(u64::from(pixel)) ^ number) >> 11) as f64 / 2f64.powi(53)
        };
        let angle = drawn(1) * std::f64::consts::FRAC_PI_4;
        let (nx, ny) = (libm::sin(angle), libm::cos(angle));
        let d = (drawn(2) - 0.5) * (nx + ny);
        let places = SamplePositions::new(pattern, pixel as usize, 7, count);
        let inside = (0..count).filter(|number| {
            let [x, y] = places.at(*number);
            nx * x + ny * y < d
        });
        let error = inside.count() as f64 / f64::from(count) - covered(nx, ny, d);
        sum += error * error;
    }
    (sum / f64::from(pixels)).sqrt()
}

/// The area of a pixel around the origin that lies where `nx·x + ny·y < d`, for 0 ≤ nx ≤ ny.
///
/// The square's corner is cut off by up to three triangles; as the area of a polygon.
fn covered(nx: f64, ny: f64, d: f64) -> f64 {
    if nx == 0.0 {
        return (d / ny + 0.5).clamp(0.0, 1.0);
    }
    // From the corner with the lowest value on; the part below is a triangle less what of it
    // sticks out of the square.
    let deep = d + 0.5 * (nx + ny);
    let triangle = |side: f64| side.max(0.0).powi(2) / (2.0 * nx * ny);
    triangle(deep) - triangle(deep - nx) - triangle(deep - ny) + triangle(deep - nx - ny)
}
