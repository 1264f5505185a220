//! Where in a pixel the rays go.

use sobol_burley::sample;

use super::Pattern;
use crate::math::scramble;

/// The places of a pixel's rays: each is a function of pixel, number and axis alone, so a picture is
/// the same on every run, for every number of threads, and in part as a whole.
///
/// For `grid` and `stratified` the pixel is cut into as many cells of equal area as there are rays,
/// for any number: rows of cells, each row as high as its share.
#[derive(Debug, Clone, Copy)]
pub struct Places {
    pattern: Pattern,
    /// What tells the pixel from others.
    pub seed: u64,
    /// How many there are.
    count: u32,
    /// How many rows of cells.
    rows: u32,
}

impl Places {
    /// So many places, at least one, in the pixel of this column and row, from the lower left.
    #[must_use]
    pub fn new(pattern: Pattern, column: usize, row: usize, count: u32) -> Self {
        let rows = f64::from(count).sqrt().round().max(1.0);
        #[expect(clippy::cast_possible_truncation, reason = "at most 256")]
        #[expect(clippy::cast_sign_loss, reason = "at least 1")]
        let rows = rows as u32;
        Self {
            pattern,
            seed: scramble((column as u64) << 32 ^ row as u64),
            count,
            rows,
        }
    }

    /// The place of the ray with this number, from −½ to ½ around the pixel's centre along x and y.
    #[must_use]
    pub fn at(&self, number: u32) -> [f64; 2] {
        let from_corner = match self.pattern {
            Pattern::Center => return [0.0; 2],
            Pattern::Grid => self.in_cell(number, [0.5; 2]),
            Pattern::Stratified => self.in_cell(number, self.drawn(number)),
            Pattern::Random => self.drawn(number),
            Pattern::Sobol => {
                #[expect(clippy::cast_possible_truncation, reason = "half of the bits do")]
                let seed = self.seed as u32;
                [0, 1].map(|axis| f64::from(sample(number, axis, seed)))
            }
        };
        from_corner.map(|place| place - 0.5)
    }

    /// The place of a ray in the pixel, from that in its cell.
    fn in_cell(&self, number: u32, [x, y]: [f64; 2]) -> [f64; 2] {
        let [number, count, rows] = [number, self.count, self.rows].map(u64::from);
        // The last row of cells of which the first is not beyond this one.
        let band = ((number + 1) * rows - 1) / count;
        let start = count * band / rows;
        let end = count * (band + 1) / rows;
        #[expect(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
        let [cell, cells, start] = [number - start, end - start, start].map(|it| it as f64);
        [
            (cell + x) / cells,
            (start + cells * y) / f64::from(self.count),
        ]
    }

    /// Two numbers from 0 up to but not including 1.
    fn drawn(&self, number: u32) -> [f64; 2] {
        [0, 1].map(|axis| fraction(self.seed, 2 * u64::from(number) + axis))
    }
}

/// A number from 0 up to but not including 1.
fn fraction(seed: u64, index: u64) -> f64 {
    const STEPS: f64 = 9_007_199_254_740_992.0; // 2^53
    #[expect(clippy::cast_precision_loss, reason = "53 bits fit")]
    let bits = (scramble(seed ^ index.wrapping_mul(0x9E37_79B9_7F4A_7C15)) >> 11) as f64;
    bits / STEPS
}
