//! Holds a picture as a grid of 8-bit pixels, fills it from a function and writes it as PNG.

use crate::colour::Colour;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;
use std::thread;

/// A picture: rows of red, green, blue bytes, the top row first.
#[derive(Clone)]
pub(crate) struct Canvas {
    width: usize,
    height: usize,
    pixels: Vec<[u8; 3]>,
}

impl Canvas {
    /// Paints a picture by asking `shade` for the colour at points of the plane.
    ///
    /// The point (x, y) is measured in pixels from the top left corner. Every pixel is the mean
    /// of `grid` times `grid` points, which softens the edges.
    pub(crate) fn paint(
        width: usize,
        height: usize,
        grid: u32,
        shade: impl Fn(f64, f64) -> Colour + Sync,
    ) -> Self {
        let mut pixels = vec![[0; 3]; width * height];
        let workers = thread::available_parallelism().map_or(1, usize::from);
        let rows_each = height.div_ceil(workers);
        // Every pixel depends on its place alone, so the split into bands cannot change it.
        thread::scope(|scope| {
            for (index, rows) in pixels.chunks_mut(rows_each * width).enumerate() {
                let shade = &shade;
                scope.spawn(move || {
                    for (offset, pixel) in rows.iter_mut().enumerate() {
                        let column = offset % width;
                        let row = index * rows_each + offset / width;
                        *pixel = average(column, row, grid, shade).to_bytes();
                    }
                });
            }
        });
        Self {
            width,
            height,
            pixels,
        }
    }

    /// The number of pixels in a row.
    pub(crate) fn width(&self) -> usize {
        self.width
    }

    /// The number of rows.
    pub(crate) fn height(&self) -> usize {
        self.height
    }

    /// The colour of a pixel.
    pub(crate) fn get(&self, column: usize, row: usize) -> Colour {
        Colour::from_bytes(self.pixels[row * self.width + column])
    }

    /// Replaces the colour of a pixel.
    pub(crate) fn set(&mut self, column: usize, row: usize, colour: Colour) {
        self.pixels[row * self.width + column] = colour.to_bytes();
    }

    /// Writes the picture as a PNG file without any metadata.
    pub(crate) fn write(&self, path: &Path) -> Result<(), Box<dyn std::error::Error>> {
        let file = BufWriter::new(File::create(path)?);
        let mut encoder = png::Encoder::new(
            file,
            u32::try_from(self.width)?,
            u32::try_from(self.height)?,
        );
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::High);
        encoder.set_filter(png::Filter::Adaptive);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(self.pixels.as_flattened())?;
        writer.finish()?;
        Ok(())
    }
}

/// The mean colour of a pixel over a regular grid of points.
fn average(column: usize, row: usize, grid: u32, shade: &impl Fn(f64, f64) -> Colour) -> Colour {
    let mut sum = Colour::BLACK;
    for j in 0..grid {
        for i in 0..grid {
            let x = as_float(column) + (f64::from(i) + 0.5) / f64::from(grid);
            let y = as_float(row) + (f64::from(j) + 0.5) / f64::from(grid);
            sum = sum + shade(x, y);
        }
    }
    sum * (1.0 / f64::from(grid * grid))
}

/// A pixel count as a coordinate.
#[expect(
    clippy::cast_precision_loss,
    reason = "Pictures are far smaller than 2^53 pixels"
)]
pub(crate) fn as_float(count: usize) -> f64 {
    count as f64
}
