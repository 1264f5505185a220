//! Pictures and their errors as PNG files.

use crate::film::{Film, Rounding};
use crate::language::ValueError;
use crate::measure::deviation::largest_errors;

/// Picture of a step and its errors as PNG files.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Pictures {
    pub(super) picture: Vec<u8>,
    pub(super) errors: Vec<u8>,
    /// Pixels with the largest errors, no two of them close to each other.
    pub(super) worst: Vec<[usize; 2]>,
}

/// Largest error in code values that is drawn black.
const FAINTEST: f64 = 1.0 / 16.0;

/// Colours from [`FAINTEST`] to 255 code values, evenly on a logarithmic scale.
const HEAT: [[f64; 3]; 6] = [
    [12.0, 12.0, 20.0],
    [58.0, 28.0, 104.0],
    [150.0, 40.0, 110.0],
    [228.0, 90.0, 60.0],
    [250.0, 180.0, 60.0],
    [255.0, 255.0, 220.0],
];

impl Pictures {
    pub(super) fn of(film: &Film, reference: &Film) -> Result<Self, ValueError> {
        let errors: Vec<_> = largest_errors(film, reference).collect();
        let size = [film.width(), film.height()];
        let (picture, heat) = rayon::join(|| png(film), || heat(&errors, size));
        Ok(Self {
            picture: picture?,
            errors: heat?,
            worst: worst(&errors, size),
        })
    }
}

/// A picture as a small PNG file.
pub(super) fn png(film: &Film) -> Result<Vec<u8>, ValueError> {
    let bytes = film.bytes(Rounding::Nearest);
    encoded(&bytes, [film.width(), film.height()], None)
}

/// Pixels as a PNG file of true colours, or of those of a palette.
fn encoded(
    bytes: &[u8],
    size: [usize; 2],
    palette: Option<Vec<u8>>,
) -> Result<Vec<u8>, ValueError> {
    let mut file = Vec::new();
    let [width, height] = size.map(|side| u32::try_from(side).unwrap_or(u32::MAX));
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_compression(png::Compression::Balanced);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_color(png::ColorType::Rgb);
    if let Some(palette) = palette {
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_palette(palette);
    }
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(bytes)?;
        writer.finish()
    });
    written.map_err(|error| {
        let reason = format!("cannot encode a picture: {error}");
        ValueError::new("image", reason, "choose a smaller picture")
    })?;
    Ok(file)
}

/// Errors in code values as a picture in colours of [`HEAT`].
fn heat(errors: &[f64], size: [usize; 2]) -> Result<Vec<u8>, ValueError> {
    let palette = (0..=u8::MAX).flat_map(|index| {
        let place = f64::from(index) / 255.0 * 5.0;
        let lower = (0..5)
            .rfind(|lower| f64::from(*lower) <= place)
            .unwrap_or(0);
        let part = place - f64::from(lower);
        let lower = lower as usize;
        [0, 1, 2].map(|c| byte(HEAT[lower][c] + part * (HEAT[lower + 1][c] - HEAT[lower][c])))
    });
    let codes = errors.iter().map(|error| {
        let doublings = libm::log2(error.max(FAINTEST) / FAINTEST);
        byte(255.0 * doublings / libm::log2(255.0 / FAINTEST))
    });
    let codes: Vec<_> = codes.collect();
    encoded(&codes, size, Some(palette.collect()))
}

/// The nearest whole number from 0 to 255.
#[expect(clippy::cast_possible_truncation, reason = "limited")]
#[expect(clippy::cast_sign_loss, reason = "not negative")]
fn byte(number: f64) -> u8 {
    number.round().clamp(0.0, 255.0) as u8
}

/// Pixels with the largest errors, no two of them in one crop of the page.
fn worst(errors: &[f64], [width, _]: [usize; 2]) -> Vec<[usize; 2]> {
    const COUNT: usize = 4;
    const APART: usize = 24;
    let mut worst: Vec<[usize; 2]> = Vec::new();
    for _ in 0..COUNT {
        let place = |at: usize| [at % width, at / width];
        let apart = |at: usize| {
            let [column, row] = place(at);
            let near = |other: &[usize; 2]| {
                other[0].abs_diff(column) < APART && other[1].abs_diff(row) < APART
            };
            !worst.iter().any(near)
        };
        let most = (0..errors.len()).filter(|at| errors[*at] > 0.5 && apart(*at));
        let Some(most) = most.max_by(|one, other| errors[*one].total_cmp(&errors[*other])) else {
            break;
        };
        worst.push(place(most));
    }
    worst
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_pixels_are_apart() {
        let mut errors = vec![0.0; 100 * 50];
        for (at, error) in [(10, 9.0), (12, 8.0), (90, 7.0), (3000, 0.4)] {
            errors[at] = error;
        }
        assert_eq!(worst(&errors, [100, 50]), [[10, 0], [90, 0]]);
    }

    #[test]
    fn heat_is_black_without_errors_and_bright_at_the_largest() {
        let png = heat(&[0.0, 255.0], [2, 1]).expect("a picture");
        let image = image::load_from_memory(&png)
            .expect("a picture")
            .into_rgb8();
        assert_eq!(image.get_pixel(0, 0).0, [12, 12, 20]);
        assert_eq!(image.get_pixel(1, 0).0, [255, 255, 220]);
    }
}
