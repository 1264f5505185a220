//! Scenes rendered through the library, and pictures compared with the ones that are kept.
//!
//! With `SNAPSHOTS=overwrite` in the environment, as for texts, a picture that differs is written
//! over its golden. The test fails all the same, so that no run passes against pictures it has
//! just made.

use std::fmt;
use std::fs;
use std::io;
use std::path::Path;

use heliodon::read::{Options, read_file};
use heliodon::render::render;
use image::{Rgb, RgbImage};

use crate::files::stem;

/// What is wrong, in words for the person who runs the test.
pub type Complaint = String;

/// Whether goldens are to be rewritten.
#[must_use]
pub fn updating() -> bool {
    std::env::var_os("SNAPSHOTS").is_some_and(|value| value == "overwrite")
}

/// A scene's picture in 8 bits a channel.
pub fn picture(scene: &Path, options: &Options) -> Result<RgbImage, Complaint> {
    let title = scene.display();
    let reading = read_file(scene, options).map_err(|error| format!("{title}: {error}"))?;
    let scene = reading
        .map_err(|scene_error| {
            let problems = scene_error.diagnostics.iter();
            let messages: Vec<_> = problems.map(|problem| problem.message.as_str()).collect();
            format!("{title}: {}", messages.join("; "))
        })?
        .scene;
    let (film, _) =
        render(&scene, &|_| ()).map_err(|error| format!("{title}: {}", error.reason))?;
    let encoding = scene.settings.encoding();
    Ok(RgbImage::from_fn(
        scene.settings.width,
        scene.settings.height,
        |column, row| {
            let pixel = film.pixel(column as usize, row as usize);
            // The code is at most 255, so its low byte is all of it.
            let code = |channel| encoding.code(channel, 255).to_le_bytes()[0];
            Rgb(pixel.channels().map(code))
        },
    ))
}

/// Compares a picture with its golden, pixel for pixel.
///
/// Where they differ, `comparison` becomes expected, difference and actual side by side.
pub fn compare(golden: &Path, actual: &RgbImage, comparison: &Path) -> Result<(), Complaint> {
    let complaint = match image::open(golden) {
        Ok(expected) => {
            let expected = expected.into_rgb8();
            let Some(difference) = Difference::between(&expected, actual) else {
                return Ok(());
            };
            let sheet = side_by_side(&expected, actual);
            let kept = write_small_png(comparison, &sheet);
            let kept = kept.map_or_else(
                |error| format!("not written, {error}"),
                |()| comparison.display().to_string(),
            );
            format!("{}: {difference}; side by side: {kept}", stem(golden))
        }
        Err(error) => format!("{}: no golden: {error}", stem(golden)),
    };
    if updating() {
        write_small_png(golden, actual).map_err(|error| format!("{complaint}; {error}"))?;
        return Err(format!("{complaint}; golden rewritten"));
    }
    Err(complaint)
}

/// How two pictures differ.
#[derive(Debug, PartialEq, Eq)]
pub enum Difference {
    /// In size.
    Size {
        /// The golden's width and height.
        expected: (u32, u32),
        /// The picture's width and height.
        actual: (u32, u32),
    },
    /// In so many pixels, by so many code values at most.
    Pixels {
        /// How many pixels differ.
        count: usize,
        /// The largest difference of a channel.
        largest: u8,
    },
}

impl Difference {
    /// The difference between two pictures, if there is one.
    pub fn between(expected: &RgbImage, actual: &RgbImage) -> Option<Self> {
        if expected.dimensions() != actual.dimensions() {
            return Some(Self::Size {
                expected: expected.dimensions(),
                actual: actual.dimensions(),
            });
        }
        let pairs = expected.pixels().zip(actual.pixels());
        let differences = pairs.map(|(one, other)| one.0.iter().zip(&other.0));
        let largest = differences.map(|pairs| pairs.map(|(a, b)| a.abs_diff(*b)).max());
        let differing: Vec<_> = largest.flatten().filter(|largest| *largest > 0).collect();
        let largest = *differing.iter().max()?;
        Some(Self::Pixels {
            count: differing.len(),
            largest,
        })
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size { expected, actual } => {
                let ((w, h), (x, y)) = (expected, actual);
                write!(f, "{x}x{y} pixels instead of {w}x{h}")
            }
            Self::Pixels { count, largest } => {
                write!(f, "{count} pixels differ, by {largest} of 255 at most")
            }
        }
    }
}

/// Expected, difference and actual side by side; the difference is amplified to be seen.
fn side_by_side(expected: &RgbImage, actual: &RgbImage) -> RgbImage {
    const GAIN: u8 = 16;
    let width = expected.width().max(actual.width());
    let height = expected.height().max(actual.height());
    let at = |image: &RgbImage, x, y| {
        image
            .get_pixel_checked(x, y)
            .map_or([0; 3], |pixel| pixel.0)
    };
    RgbImage::from_fn(3 * width, height, |x, y| {
        let column = x % width;
        let (a, b) = (at(expected, column, y), at(actual, column, y));
        Rgb(match x / width {
            0 => a,
            1 => [0, 1, 2].map(|channel| a[channel].abs_diff(b[channel]).saturating_mul(GAIN)),
            _ => b,
        })
    })
}

/// Writes a PNG that takes longer to write than others and less room.
pub fn write_small_png(path: &Path, image: &RgbImage) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    // Smooth pictures are smaller with filters, flat and speckled ones without.
    let adaptive = encoded(image, png::Filter::Adaptive)?;
    let unfiltered = encoded(image, png::Filter::NoFilter)?;
    let small = if unfiltered.len() < adaptive.len() {
        unfiltered
    } else {
        adaptive
    };
    fs::write(path, small)
}

fn encoded(image: &RgbImage, filter: png::Filter) -> io::Result<Vec<u8>> {
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, image.width(), image.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    encoder.set_filter(filter);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(image.as_raw())?;
    writer.finish()?;
    Ok(out)
}
