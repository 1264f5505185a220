//! Sample positions in a pixel.

use sobol_burley::sample;

use super::Pattern;
use crate::math::scramble;

/// The sample positions of a pixel.
///
/// A position depends on pixel, number and axis alone, so a picture does not depend on threads,
/// crop or repetition. For `grid` and `stratified` the pixel has as many cells of equal area as
/// samples, in rows of cells whose heights are proportional to their numbers of cells.
#[derive(Debug, Clone, Copy)]
pub struct SamplePositions {
    pattern: Pattern,
    /// The seed of the pixel.
    pub seed: u64,
    /// The number of samples.
    count: u32,
    /// The number of rows of cells.
    rows: u32,
}

/// The part of a pixel that a sample represents.
///
/// The pixel is a square of side 1 around the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SampleCell {
    /// Centre.
    pub center: [f64; 2],
    /// Width and height.
    pub sides: [f64; 2],
}

impl SampleCell {
    /// A square around a position, with the area of one of `count` samples.
    #[must_use]
    pub fn around(position: [f64; 2], count: u32) -> Self {
        Self {
            center: position,
            sides: [1.0 / f64::from(count).sqrt(); 2],
        }
    }
}

impl SamplePositions {
    /// The positions of `count` samples, at least one.
    ///
    /// Columns and rows of pixels count from the lower left.
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

    /// The position of a sample, x and y from −½ to ½ around the pixel's centre.
    #[must_use]
    pub fn at(&self, number: u32) -> [f64; 2] {
        let from_corner = match self.pattern {
            Pattern::Center => return [0.0; 2],
            Pattern::Grid => self.in_cell(number, [0.5; 2]),
            Pattern::Stratified => self.in_cell(number, self.random(number)),
            Pattern::Random => self.random(number),
            Pattern::Sobol => {
                #[expect(clippy::cast_possible_truncation, reason = "half of the bits suffice")]
                let seed = self.seed as u32;
                [0, 1].map(|axis| f64::from(sample(number, axis, seed)))
            }
        };
        from_corner.map(|coordinate| coordinate - 0.5)
    }

    /// The cell of the sample at a position.
    ///
    /// The cells of all samples tile the pixel for `grid`, `stratified`, and `sobol` with a power
    /// of two. In other cases a cell is a square around its position.
    #[must_use]
    pub fn cell(&self, position: [f64; 2]) -> SampleCell {
        let from_corner = position.map(|coordinate| coordinate + 0.5);
        // The lower edge of the cell along an axis with equal cells.
        let low = |axis: usize, side: f64| {
            let cells = 1.0 / side;
            (from_corner[axis] * cells).floor().clamp(0.0, cells - 1.0) * side
        };
        let (corner, sides) = match self.pattern {
            Pattern::Grid | Pattern::Stratified => {
                let count = f64::from(self.count);
                #[expect(clippy::cast_possible_truncation, reason = "below the count")]
                #[expect(clippy::cast_sign_loss, reason = "casts from float saturate")]
                let number = (from_corner[1] * count) as u32;
                let [start, cells] = self.row_of(number.min(self.count - 1));
                let sides = [1.0 / cells, cells / count];
                let column = (from_corner[0] * cells).floor().clamp(0.0, cells - 1.0);
                ([column * sides[0], start / count], sides)
            }
            Pattern::Sobol if self.count.is_power_of_two() => {
                let halvings = self.count.trailing_zeros();
                let columns = 1 << halvings.div_ceil(2);
                let sides = [columns, self.count / columns].map(|cells| 1.0 / f64::from(cells));
                ([low(0, sides[0]), low(1, sides[1])], sides)
            }
            _ => return SampleCell::around(position, self.count),
        };
        SampleCell {
            center: [0, 1].map(|axis| corner[axis] + sides[axis] / 2.0 - 0.5),
            sides,
        }
    }

    /// The position of a sample in the pixel, from its position in its cell.
    fn in_cell(&self, number: u32, [x, y]: [f64; 2]) -> [f64; 2] {
        let [start, cells] = self.row_of(number);
        let cell = f64::from(number) - start;
        [
            (cell + x) / cells,
            (start + cells * y) / f64::from(self.count),
        ]
    }

    /// The numbers of cells before the row of a sample's cell, and in the row.
    fn row_of(&self, number: u32) -> [f64; 2] {
        let [number, count, rows] = [number, self.count, self.rows].map(u64::from);
        // The last row whose first cell is not after this one.
        let row = ((number + 1) * rows - 1) / count;
        let start = count * row / rows;
        let end = count * (row + 1) / rows;
        #[expect(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
        [start, end - start].map(|it| it as f64)
    }

    /// Two random numbers from 0 to below 1.
    fn random(&self, number: u32) -> [f64; 2] {
        [0, 1].map(|axis| fraction(self.seed, 2 * u64::from(number) + axis))
    }
}

/// A random number from 0 to below 1.
fn fraction(seed: u64, index: u64) -> f64 {
    const STEPS: f64 = 9_007_199_254_740_992.0; // 2^53
    #[expect(clippy::cast_precision_loss, reason = "53 bits fit")]
    let bits = (scramble(seed ^ index.wrapping_mul(0x9E37_79B9_7F4A_7C15)) >> 11) as f64;
    bits / STEPS
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_tile_the_pixel() {
        for pattern in [Pattern::Grid, Pattern::Stratified, Pattern::Sobol] {
            for count in [1, 2, 4, 5, 8, 9, 16, 23, 32, 64] {
                if pattern == Pattern::Sobol && !u32::is_power_of_two(count) {
                    continue;
                }
                let positions = SamplePositions::new(pattern, 3, 7, count);
                let cells = (0..count).map(|number| positions.at(number));
                let cells: Vec<_> = cells.map(|at| (at, positions.cell(at))).collect();
                let area: f64 = cells.iter().map(|(_, it)| it.sides[0] * it.sides[1]).sum();
                assert!((area - 1.0).abs() < 1e-12, "{pattern:?} {count}: {area}");
                for (number, (position, cell)) in cells.iter().enumerate() {
                    let far = |other: &SampleCell, position: &[f64; 2]| {
                        let away = |axis: usize| {
                            (position[axis] - other.center[axis]).abs() / other.sides[axis]
                        };
                        away(0).max(away(1))
                    };
                    assert!(far(cell, position) <= 0.5 + 1e-9, "{pattern:?} {count}");
                    let others = cells[..number].iter();
                    let mut apart = others.map(|(_, other)| far(other, &cell.center));
                    assert!(apart.all(|far| far > 0.5), "{pattern:?} {count}");
                }
            }
        }
    }

    #[test]
    fn other_cells_are_squares_around_their_samples() {
        let positions = SamplePositions::new(Pattern::Random, 0, 0, 4);
        let cell = positions.cell([0.3, -0.4]);
        assert_eq!((cell.center, cell.sides), ([0.3, -0.4], [0.5, 0.5]));
    }
}
