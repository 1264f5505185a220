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

/// A part of a pixel, which is a square of side 1 around the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Share {
    /// Its middle.
    pub center: [f64; 2],
    /// Its width and height.
    pub sides: [f64; 2],
}

impl Share {
    /// A square around a place, which is as large as that of each of so many rays.
    #[must_use]
    pub fn around(place: [f64; 2], count: u32) -> Self {
        Self {
            center: place,
            sides: [1.0 / f64::from(count).sqrt(); 2],
        }
    }
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

    /// The part of the pixel that the ray through a place stands for.
    ///
    /// The parts of all rays make up the pixel, each once, where one lies in each of as many equal cells;
    /// else each is a square around its place.
    #[must_use]
    pub fn share(&self, place: [f64; 2]) -> Share {
        let from_corner = place.map(|place| place + 0.5);
        let cells = match self.pattern {
            Pattern::Grid | Pattern::Stratified => {
                let count = f64::from(self.count);
                #[expect(clippy::cast_possible_truncation, reason = "below the count")]
                #[expect(clippy::cast_sign_loss, reason = "casts from float saturate")]
                let number = (from_corner[1] * count) as u32;
                let [start, cells] = self.row_of(number.min(self.count - 1));
                let sides = [1.0 / cells, cells / count];
                let column = (from_corner[0] * cells).floor().clamp(0.0, cells - 1.0);
                let corner = [column * sides[0], start / count];
                Some((corner, sides))
            }
            Pattern::Sobol if self.count.is_power_of_two() => {
                let halvings = self.count.trailing_zeros();
                let columns = 1 << halvings.div_ceil(2);
                let sides = [columns, self.count / columns].map(|cells| 1.0 / f64::from(cells));
                let corner = [0, 1].map(|axis| {
                    let cells = 1.0 / sides[axis];
                    (from_corner[axis] * cells).floor().clamp(0.0, cells - 1.0) * sides[axis]
                });
                Some((corner, sides))
            }
            _ => None,
        };
        cells.map_or(Share::around(place, self.count), |(corner, sides)| Share {
            center: [0, 1].map(|axis| corner[axis] + sides[axis] / 2.0 - 0.5),
            sides,
        })
    }

    /// The place of a ray in the pixel, from that in its cell.
    fn in_cell(&self, number: u32, [x, y]: [f64; 2]) -> [f64; 2] {
        let [start, cells] = self.row_of(number);
        let cell = f64::from(number) - start;
        [
            (cell + x) / cells,
            (start + cells * y) / f64::from(self.count),
        ]
    }

    /// The row of cells that this ray's is in: how many cells come before it, and how many it has.
    fn row_of(&self, number: u32) -> [f64; 2] {
        let [number, count, rows] = [number, self.count, self.rows].map(u64::from);
        // The last row of cells of which the first is not beyond this one.
        let row = ((number + 1) * rows - 1) / count;
        let start = count * row / rows;
        let end = count * (row + 1) / rows;
        #[expect(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
        [start, end - start].map(|it| it as f64)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_the_parts_of_a_pixel() {
        for pattern in [Pattern::Grid, Pattern::Stratified, Pattern::Sobol] {
            for count in [1, 2, 4, 5, 8, 9, 16, 23, 32, 64] {
                if pattern == Pattern::Sobol && !u32::is_power_of_two(count) {
                    continue;
                }
                let places = Places::new(pattern, 3, 7, count);
                let shares = (0..count).map(|number| places.at(number));
                let shares: Vec<_> = shares.map(|at| (at, places.share(at))).collect();
                let area: f64 = shares.iter().map(|(_, it)| it.sides[0] * it.sides[1]).sum();
                assert!((area - 1.0).abs() < 1e-12, "{pattern:?} {count}: {area}");
                for (number, (place, share)) in shares.iter().enumerate() {
                    let far = |other: &Share, place: &[f64; 2]| {
                        let away = |axis: usize| {
                            (place[axis] - other.center[axis]).abs() / other.sides[axis]
                        };
                        away(0).max(away(1))
                    };
                    assert!(far(share, place) <= 0.5 + 1e-9, "{pattern:?} {count}");
                    let others = shares[..number].iter();
                    let mut apart = others.map(|(_, other)| far(other, &share.center));
                    assert!(apart.all(|far| far > 0.5), "{pattern:?} {count}");
                }
            }
        }
    }

    #[test]
    fn shares_that_are_no_parts_are_squares_around_their_rays() {
        let places = Places::new(Pattern::Random, 0, 0, 4);
        let share = places.share([0.3, -0.4]);
        assert_eq!((share.center, share.sides), ([0.3, -0.4], [0.5, 0.5]));
    }
}
