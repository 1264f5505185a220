//! Draws a tiny test texture in which every row and every column differs from all others.

use crate::canvas::Canvas;
use crate::colour::Colour;

/// The number of rows and columns.
const SIZE: usize = 8;

/// Draws the picture: red grows to the right, green grows downwards.
pub(crate) fn draw() -> Canvas {
    // At a pixel's centre x is column + 0.5, so 32 x is 32 column + 16.
    Canvas::paint(SIZE, SIZE, 1, |x, y| {
        Colour([32.0 * x, 32.0 * y, 128.0]) * (1.0 / 255.0)
    })
}
